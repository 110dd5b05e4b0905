"""Tasks that cannot be done, or that could mean several things: nothing is moved."""

from app.training.groups import ALL, class_groups, name_groups
from app.training.phrases import NUMBERS, NounPhrase, Speaker
from app.training.scenes import Item, Setting
from app.training.sorting_tasks import ALL_THINGS
from app.training.tasks import Answered, declined, task_kind


@task_kind("absent")
def absent(say: Speaker, scene: Setting) -> Answered | None:
    """The thing, or the place, is not there; something like it may be."""
    words = say.vocabulary.words
    holder, names = say.rng.choice(scene.holders), {item.name for item in scene.order}
    if say.rng.random() < 0.3:
        preposition = say.rng.choice(("in", "on"))
        noun = say.rng.choice(words["containers"][preposition])
        if any(noun in name for name in names):
            return None
        item = say.rng.choice(scene.things)
        return declined(
            say.dress(say.move(say.the(item), Item(noun, noun, "", preposition))),
            f"there is no {noun}",
        )
    kinds = [item.kind for item in scene.things if item.kind]
    near = say.vocabulary.classes[
        say.rng.choice(kinds if kinds and say.rng.random() < 0.6 else list(say.vocabulary.classes))
    ].things
    noun = say.rng.choice(near)
    if any(noun in name or name in noun for name in names) or noun.split()[-1] in " ".join(names):
        return None
    sentence = say.move(NounPhrase(f"the {noun}"), holder)
    if say.rng.random() < 0.25:
        other = say.rng.choice(scene.things)
        pair = say.rng.sample([f"the {noun}", say.the(other).text], 2)
        sentence = say.move(NounPhrase(" and ".join(pair), True), holder)
    return declined(say.dress(sentence), f"there is no {noun}")


@task_kind("absent kind")
def absent_kind(say: Speaker, scene: Setting) -> Answered | None:
    """No member of the class, or nothing of the colour, is there."""
    holder = say.rng.choice(scene.holders)
    if scene.marked == "color":
        used = {item.properties["color"] for item in scene.order if item.properties}
        text = " ".join(item.name for item in scene.order)
        free = [c for c in say.vocabulary.words["colours"] if c not in used and c not in text]
        colour, noun = say.rng.choice(free), say.rng.choice(scene.things).noun
        if say.rng.random() < 0.5:
            return declined(
                say.dress(say.move(NounPhrase(f"the {colour} {noun}"), holder)),
                f"there is no {colour} {noun}",
            )
        return declined(
            say.dress(say.move(NounPhrase(say.choose(ALL_THINGS).format(v=colour), True), holder)),
            f"there is nothing {colour}",
        )
    present = {item.kind for item in scene.things}
    if scene.marked:
        return None
    free = [
        name
        for name in say.vocabulary.classes
        if all(say.vocabulary.disjoint(name, p) for p in present) and name not in present
    ]
    near = [
        name for name in free if any(frozenset((name, p)) in say.vocabulary.close for p in present)
    ]
    name = say.rng.choice(near if near and say.rng.random() < 0.5 else free)
    return declined(
        say.dress(say.move(NounPhrase(say.choose(ALL).format(c=name), True), holder, gather=True)),
        f"there are no {name}",
    )


@task_kind("too few")
def too_few(say: Speaker, scene: Setting) -> Answered | None:
    """More are asked for than there are."""
    groups = class_groups(say, scene) + name_groups(scene)
    if not groups:
        return None
    what, members = say.rng.choice(groups)
    number = len(members) + say.rng.choice((1, 1, 2))
    text = say.choose(
        (
            f"{NUMBERS[number]} {what}",
            f"exactly {NUMBERS[number]} {what}",
            f"{number} of the {what}",
            f"{NUMBERS[number]} of the {what}",
        )
    )
    return declined(
        say.dress(say.move(NounPhrase(text, True), say.rng.choice(scene.holders))),
        f"only {len(members)} of {what}: {', '.join(i.name for i in members)}",
    )


@task_kind("no such skill")
def no_skill(say: Speaker, scene: Setting) -> Answered:
    """Nothing on the import line does it."""
    skill, item = say.rng.choice(say.vocabulary.words["skills"]), say.rng.choice(scene.order)
    sentence = say.choose(
        (
            "{s} {x}",
            "please {s} {x}",
            "could you {s} {x}?",
            "{s} {x} for me",
            "i want you to {s} {x}",
            "can you {s} {x}",
        )
    )
    first, _, rest = skill.partition(" ")
    text = sentence.format(s=first, x=f"{say.the(item).text} {rest}".strip())
    return declined(
        text if say.rng.random() < 0.5 else text[0].upper() + text[1:], f"the robot cannot {skill}"
    )


@task_kind("into itself")
def into_itself(say: Speaker, scene: Setting) -> Answered:
    """A thing into or onto itself."""
    holder = say.rng.choice(scene.order)
    sentence = say.move(say.the(holder), holder)
    if say.rng.random() < 0.4:
        sentence = f"put {say.the(holder).text} {holder.preposition or 'on'} itself"
    return declined(say.dress(sentence), "nothing goes into itself")


@task_kind("ambiguous")
def ambiguous(say: Speaker, scene: Setting) -> Answered | None:
    """One of several is meant, and nothing tells which."""
    groups = [group for group in name_groups(scene) if len(group[1]) > 1]
    if not groups:
        return None
    _, members = say.rng.choice(groups)
    noun = members[0].noun
    sentence = say.move(NounPhrase(f"the {noun}"), say.rng.choice(scene.holders))
    return declined(
        say.dress(sentence), f"which {noun}: {' or '.join(item.name for item in members)}?"
    )
