"""Which sets a scene has, by class, by name and by property, and how a class is spoken of."""

from collections.abc import Sequence

from app.training.phrases import Speaker, plural
from app.training.scenes import Item, Setting

ALL = (
    "all the {c}",
    "the {c}",
    "all {c}",
    "all of the {c}",
    "the {c}",
    "every single one of the {c}",
    "only the {c}",
    "just the {c}",
    "whatever {c} there are",
    "any {c} you can find",
    "all our {c}",
    "each of the {c}",
    "{c}",
)
EACH = (
    "every {one}",
    "each {one}",
    "any {one}",
    "everything that is a {one}",
    "anything that counts as a {one}",
)


def class_groups(say: Speaker, scene: Setting) -> list[tuple[str, list[Item]]]:
    """The scene's classes, some under another or a wider name, with their members."""
    names = sorted({item.kind for item in scene.things if item.kind})
    if scene.marked or not names:
        return []
    groups: list[tuple[str, list[Item]]] = []
    for name in names:
        known = say.vocabulary.classes[name]
        called = say.choose((name, name, name, *known.aliases))
        groups.append((called, scene.listed(i for i in scene.things if i.kind == name)))
    wider = say.vocabulary.supers(names)
    if wider and say.rng.random() < 0.3:
        called, covered = say.rng.choice(wider)
        groups = [(called, scene.listed(i for i in scene.things if i.kind in covered))]
    return groups


def name_groups(scene: Setting) -> list[tuple[str, list[Item]]]:
    """Look-alikes by the plural of their name."""
    nouns = sorted({item.noun for item in scene.things if not item.kind})
    return [(plural(n), scene.listed(i for i in scene.things if i.noun == n)) for n in nouns]


def property_groups(scene: Setting) -> list[tuple[str, list[Item]]]:
    """The values of the property that tells look-alikes apart, with those that have it."""
    if scene.marked in ("", "position"):
        return []
    values = sorted({item.properties[scene.marked] for item in scene.things})
    return [
        (v, scene.listed(i for i in scene.things if i.properties[scene.marked] == v))
        for v in values
    ]


def class_phrase(say: Speaker, what: str, members: Sequence[Item]) -> tuple[str, bool]:
    known = say.vocabulary.classes.get(what)
    if known and members and say.rng.random() < 0.15:
        return say.choose(EACH).format(one=known.one), False
    return say.choose(ALL).format(c=what), True
