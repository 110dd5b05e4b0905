"""Tasks that name their objects: one, two, several, and by pronoun."""

from app.training.phrases import Speaker
from app.training.scenes import Item, Setting
from app.training.tasks import Answered, Step, answer, put, task_kind

JOINS = (
    "{a} and {b}",
    "{a}, then {b}",
    "{a} and then {b}",
    "{a}. {b}",
    "first {a}, then {b}",
    "{a}; {b}",
    "{a}. After that {b}",
    "{a}, and after that {b}",
    "{a}, and {b}",
)


@task_kind("simple")
def simple(say: Speaker, scene: Setting) -> Answered:
    """One thing to one place."""
    item, holder = say.rng.choice(scene.things), say.rng.choice(scene.holders)
    return answer(say.dress(say.move(say.the(item), holder)), put([item], holder))


@task_kind("two goals")
def two_goals(say: Speaker, scene: Setting) -> Answered | None:
    """Two things, to one place or to two."""
    if len(scene.things) < 2:
        return None
    first, second = say.rng.sample(scene.things, 2)
    places = [say.rng.choice(scene.holders) for _ in range(2)]
    steps = put([first], places[0]) + put([second], places[1])
    if places[0] == places[1] and say.rng.random() < 0.7:
        sentence = say.dress(say.move(say.both([first, second]), places[0]))
        chosen = [first, second]
        return answer(sentence, put(_as_said(sentence, chosen), places[0]))
    parts = [say.move(say.the(item), at) for item, at in ((first, places[0]), (second, places[1]))]
    sentence = say.choose(JOINS).format(a=parts[0], b=parts[1])
    return answer(say.dress(sentence), steps)


@task_kind("several places")
def several(say: Speaker, scene: Setting) -> Answered | None:
    """Three or four things over several places."""
    if len(scene.things) < 3 or len(scene.holders) < 2:
        return None
    items = say.rng.sample(scene.things, min(len(scene.things), say.rng.choice((3, 3, 4))))
    pairs = [(item, say.rng.choice(scene.holders)) for item in items]
    steps: list[Step] = [step for item, holder in pairs for step in put([item], holder)]
    short = [
        f"{say.the(i).text} {say.rng.choice(('in', 'into')) if h.preposition == 'in' else 'on'} {say.the(h).text}"
        for i, h in pairs
    ]
    verb = say.choose(("put", "place", "i want", "move", "set", "sort these:", "put away:"))
    return answer(
        say.dress(
            f"{verb} {', '.join(short[:-1])}{say.rng.choice((' and ', ', and '))}{short[-1]}"
        ),
        steps,
    )


@task_kind("one in each")
def one_in_each(say: Speaker, scene: Setting) -> Answered | None:
    """As many things as places, one to each in order."""
    holders = scene.listed(scene.holders)
    if len(holders) < 2 or len(scene.things) < len(holders) or len({h.noun for h in holders}) > 1:
        return None
    items = scene.listed(say.rng.sample(scene.things, len(holders)))
    what = say.both(items).text
    noun = holders[0].noun
    sentence = say.choose(
        (
            f"put {what} in the {noun}s, one in each",
            f"one per {noun}: {what}",
            f"distribute {what} so that each {noun} gets exactly one",
            f"share {what} out, one for each {noun}",
            f"every {noun} gets one of these: {what}",
        )
    )
    steps = [
        step
        for item, holder in zip(_as_said(sentence, items), holders, strict=True)
        for step in put([item], holder)
    ]
    return answer(say.dress(sentence), [("#", f"each {noun} gets one"), *steps])


@task_kind("pronoun")
def pronoun(say: Speaker, scene: Setting) -> Answered | None:
    """The thing is named in one sentence and meant by a pronoun in the next."""
    item, holder = say.rng.choice(scene.things), say.rng.choice(scene.holders)
    the, at = say.the(item).text, f"{holder.preposition} {say.the(holder).text}"
    if len(scene.things) > 1 and say.rng.random() < 0.35:
        return _pronouns_of_two(say, scene)
    sentence = say.choose(
        (
            f"take {the} and put it {at}",
            f"see {the}? put it {at}",
            f"do you see {the}? it should go {at}",
            f"pick up {the}. now put it {at}",
            f"{the} is in the way. please move it so that it is {at}",
            f"there is {the}; i want it {at}",
            f"i don't need {the} any more, so put it {at}",
            f"grab {the}, it belongs {at}",
            f"{the} can't stay here. {at} is where it goes",
            f"i just used {the}. can you put it {at}?",
            f"here is {say.the(holder).text}. put {the} {holder.preposition} it",
            f"get {say.the(holder).text} ready, i mean: put {the} {holder.preposition} it",
            f"{say.the(holder).text} is empty. {the} goes {holder.preposition} it",
            f"look at {the}. it is lonely, place it {at}",
            f"{say.the(holder).text} is still free, so {the} can go there",
            f"i see {the} lying around; {at} with it",
        )
    )
    return answer(say.dress(sentence), put([item], holder))


def _pronouns_of_two(say: Speaker, scene: Setting) -> Answered:
    first, second = say.rng.sample(scene.things, 2)
    holder = say.rng.choice(scene.holders)
    at, one, two = (
        f"{holder.preposition} {say.the(holder).text}",
        say.the(first).text,
        say.the(second).text,
    )
    kind = say.rng.choice(("them", "former", "latter", "too"))
    chosen = {"former": [first], "latter": [second]}.get(kind, [first, second])
    options = {
        "them": (
            f"take {one} and {two} and put them {at}",
            f"{one} and {two} are in my way. put both {at}",
            f"here are {one} and {two}. they belong {at}",
            f"see {one} and {two}? move the two of them {at}",
        ),
        "former": (
            f"here are {one} and {two}. put the former {at}",
            f"there are {one} and {two}; only the first one goes {at}",
            f"of {one} and {two}, i need the first {at}",
        ),
        "latter": (
            f"here are {one} and {two}. put the latter {at}",
            f"there are {one} and {two}; move only the second one {at}",
            f"leave {one} where it is, but take {two} and put it {at}",
            f"not {one} but {two}: it should be {at}",
        ),
        "too": (
            f"put {one} {at}, and {two} too",
            f"put {one} {at}. {two} goes there as well",
            f"{one} goes {at} and so does {two}",
            f"place {one} {at} and do the same with {two}",
        ),
    }
    return answer(say.dress(say.choose(options[kind])), put(chosen, holder))


def _as_said(sentence: str, items: list[Item]) -> list[Item]:
    return sorted(items, key=lambda item: sentence.find(item.name))
