"""Tasks that choose from a set: all but some, so many of them."""

from app.training.groups import class_groups, class_phrase, name_groups
from app.training.phrases import NUMBERS, NounPhrase, Speaker
from app.training.scenes import Item, Setting
from app.training.tasks import Answered, answer, put, stated, task_kind

BUT = (
    "except",
    "except for",
    "but not",
    "but",
    "apart from",
    "other than",
    "with the exception of",
    "besides",
    "minus",
    "excluding",
)
EVERYTHING = (
    "everything",
    "all the things",
    "all objects",
    "all of it",
    "all the stuff",
    "all items",
    "every object",
    "the lot",
)


@task_kind("except")
def all_but(say: Speaker, scene: Setting) -> Answered | None:
    """A class, the look-alikes of a name or everything, without one or two of them."""
    whole = _whole(say, scene)
    if whole is None:
        return None
    text, what, members = whole
    left = scene.listed(
        say.rng.sample(members, 1 if len(members) < 4 or say.rng.random() < 0.7 else 2)
    )
    chosen = [item for item in members if item not in left]
    holder = say.rng.choice(scene.holders) if what != "everything" else scene.holders[0]
    names = say.both(left).text if len(left) > 1 else say.the(left[0]).text
    steps = [
        stated(f"{what}, not {' and '.join(item.name for item in left)}", chosen),
        *put(chosen, holder),
    ]
    if say.rng.random() < 0.6:
        what_is_meant = NounPhrase(f"{text} {say.choose(BUT)} {names}", True)
        return answer(say.dress(say.move(what_is_meant, holder, gather=True)), steps)
    start = say.move(NounPhrase(text, True), holder, gather=True)
    end = say.choose(
        (
            f"but leave {names} where it is",
            f"but not {names}",
            f"only {names} stays where it is",
            f"{names} should stay",
            f"don't touch {names}",
            f"keep {names} out of it",
            f"without {names}",
            f"i still need {names}, so leave that out",
            f"not {names} though",
            f"just not {names}",
        )
    )
    return answer(say.dress(f"{start}{say.rng.choice((', ', ', ', '. ', ' - '))}{end}"), steps)


@task_kind("counting")
def counting(say: Speaker, scene: Setting) -> Answered | None:
    """So many of a class or of the look-alikes of a name."""
    groups = class_groups(say, scene) + name_groups(scene)
    groups = [(what, items) for what, items in groups if len(items) > 1]
    if not groups:
        return None
    what, members = say.rng.choice(groups)
    number = say.rng.randint(1, min(5, len(members)))
    holder = say.rng.choice(scene.holders)
    if number == len(members) == 2 and say.rng.random() < 0.7:
        text, word = say.choose((f"both {what}", f"both of the {what}", f"the two {what}")), "both"
    else:
        word = NUMBERS[number]
        options = (
            f"{word} of the {what}",
            f"exactly {word} of the {what}",
            f"any {word} of the {what}",
            f"only {word} of the {what}",
            f"{word} of the {what}",
            f"{number} of the {what}",
            f"no more than {word} of the {what}",
        )
        text = say.choose(
            options
            if number == 1
            else (*options, f"{word} {what}", f"exactly {word} {what}", f"{number} {what}")
        )
        if number == 2 and say.rng.random() < 0.15:
            text = f"a couple of {what}"
    chosen = members[:number]
    return answer(
        say.dress(say.move(NounPhrase(text, number > 1), holder)),
        [stated(f"{word} of {what}", chosen), *put(chosen, holder)],
    )


def _whole(say: Speaker, scene: Setting) -> tuple[str, str, list[Item]] | None:
    things = scene.listed(scene.things)
    if len(scene.holders) == 1 and len(things) > 2 and say.rng.random() < 0.4:
        return say.choose(EVERYTHING), "everything", things
    groups = [g for g in class_groups(say, scene) + name_groups(scene) if len(g[1]) > 1]
    if not groups:
        return None
    what, members = say.rng.choice(groups)
    return class_phrase(say, what, members)[0], what, members
