"""Tasks that sort: all of a class, of a colour, of a material, of a size."""

from collections.abc import Sequence

from app.training.groups import ALL, class_groups, class_phrase, property_groups
from app.training.phrases import NounPhrase, Speaker, plural
from app.training.scenes import Item, Setting
from app.training.tasks import Answered, Step, answer, put, stated, task_kind

ALL_THINGS = (
    "all the {v} things",
    "everything {v}",
    "everything that is {v}",
    "all {v} objects",
    "anything {v}",
    "all {v} items",
    "the {v} things",
    "whatever is {v}",
    "every {v} thing",
    "all the {v} stuff",
    "every {v} object",
    "only what is {v}",
    "all objects that are {v}",
)


@task_kind("sort class")
def sort_class(say: Speaker, scene: Setting) -> Answered | None:
    """All of a class to one place, or each class to its own."""
    groups = class_groups(say, scene)
    if not groups:
        return None
    if len(groups) > 1 and len(scene.holders) > 1 and say.rng.random() < 0.5:
        chosen = say.rng.sample(groups, min(len(groups), len(scene.holders)))
        return _into_places(say, scene, chosen)
    what, members = say.rng.choice(groups)
    holder = say.rng.choice(scene.holders)
    text, many = class_phrase(say, what, members)
    sentence = say.move(NounPhrase(text, many), holder, gather=True)
    return answer(say.dress(sentence), [stated(what, members), *put(members, holder)])


@task_kind("class and rest")
def class_and_rest(say: Speaker, scene: Setting) -> Answered | None:
    """One class here, everything else there."""
    groups = class_groups(say, scene)
    if len(groups) < 2 or len(scene.holders) != 2:
        return None
    what, members = say.rng.choice(groups)
    rest = [item for item in scene.listed(scene.things) if item not in members]
    first, second = say.rng.sample(scene.holders, 2)
    start = say.move(NounPhrase(class_phrase(say, what, members)[0], True), first)
    end = say.choose(
        (
            f"everything else {second.preposition} {say.the(second).text}",
            f"the rest {second.preposition} {say.the(second).text}",
            f"all other things go {second.preposition} {say.the(second).text}",
            f"what is left goes {second.preposition} {say.the(second).text}",
        )
    )
    steps = [
        stated(what, members),
        *put(members, first),
        stated("the rest", rest),
        *put(rest, second),
    ]
    return answer(say.dress(f"{start}{say.rng.choice((' and ', ', ', '; '))}{end}"), steps)


@task_kind("sort property")
def sort_property(say: Speaker, scene: Setting) -> Answered | None:
    """All of a colour, a material or a size."""
    groups = property_groups(scene)
    if not groups:
        return None
    if len(groups) > 1 and len(scene.holders) > 1 and say.rng.random() < 0.5:
        chosen = say.rng.sample(groups, min(len(groups), len(scene.holders)))
        return _into_places(
            say, scene, [(_spoken(say, scene, value), items) for value, items in chosen]
        )
    value, members = say.rng.choice(groups)
    word, holder = _spoken(say, scene, value), say.rng.choice(scene.holders)
    nouns = {item.noun for item in members}
    if len(nouns) == 1 and len(members) > 1 and say.rng.random() < 0.5:
        what = f"{word} {plural(members[0].noun)}"
        text = say.choose(ALL).format(c=what)
    elif len({item.noun for item in scene.things}) > 1 and say.rng.random() < 0.25:
        noun = say.rng.choice(sorted(nouns))
        members = [item for item in members if item.noun == noun]
        what = f"{word} {plural(noun)}"
        text = say.choose(ALL).format(c=what)
    else:
        what, text = word, say.choose(ALL_THINGS).format(v=word)
        material = say.vocabulary.words["material_nouns"].get(value)
        if material and say.rng.random() < 0.4:
            text = say.choose(
                (
                    "everything made of {m}",
                    "all the things that are made of {m}",
                    "anything made from {m}",
                    "whatever is of {m}",
                    "all objects of {m}",
                )
            ).format(m=material)
    return answer(
        say.dress(say.move(NounPhrase(text, True), holder, gather=True)),
        [stated(what, members), *put(members, holder)],
    )


@task_kind("same colour")
def same_colour(say: Speaker, scene: Setting) -> Answered | None:
    """Each thing to the place of its own colour."""
    holders = {item.name.split()[0]: item for item in scene.holders if " " in item.name}
    pairs = [(value, items) for value, items in property_groups(scene) if value in holders]
    if (
        scene.marked != "color"
        or len(holders) < 2
        or not pairs
        or len(holders) != len(scene.holders)
    ):
        return None
    noun = scene.holders[0].noun
    sentence = say.choose(
        (
            f"put everything {scene.holders[0].preposition} the {noun} of its own color",
            f"sort the things by color: each goes to the {noun} of the same color",
            f"match every object with the {noun} that has the same color",
            f"each thing belongs in the matching {noun}",
            f"sort by color into the {plural(noun)}",
            f"place all things with the {noun} of their color",
        )
    )
    steps: list[Step] = []
    for value, items in pairs:
        steps += [stated(value, items), *put(items, holders[value])]
    return answer(say.dress(sentence), steps)


def _into_places(
    say: Speaker, scene: Setting, groups: Sequence[tuple[str, list[Item]]]
) -> Answered:
    holders = say.rng.sample(scene.holders, len(groups))
    parts: list[str] = []
    steps: list[Step] = []
    adjective = bool(scene.marked)
    for (what, members), holder in zip(groups, holders, strict=True):
        text = say.choose(
            ("the {c} things", "everything {c}", "all {c} things", "the {c} ones", "{c} things")
            if adjective
            else ALL[:5]
        ).format(v=what, c=what)
        at = f"{say.rng.choice(('in', 'into')) if holder.preposition == 'in' else 'on'} {say.the(holder).text}"
        parts.append(
            f"{text} {say.rng.choice(('', '', '', 'go ', 'belong '))}{at}"
            if parts
            else f"{text} {at}"
        )
        steps += [stated(what, members), *put(members, holder)]
    joined = f"{', '.join(parts[:-1])}{say.rng.choice((' and ', ', ', '; '))}{parts[-1]}"
    start = say.choose(
        ("put", "place", "sort:", "sort this:", "move", "separate them:", "tidy up:", "i want")
    )
    return answer(say.dress(f"{start} {joined}"), steps)


def _spoken(say: Speaker, scene: Setting, value: str) -> str:
    return (
        say.rng.choice(say.vocabulary.words["size_words"][value])
        if scene.marked == "size"
        else value
    )
