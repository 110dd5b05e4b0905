"""What is known of objects and never changes: category, colour, kind, whatever a scene tells."""

from collections.abc import Iterator, Sequence

from app.domain.condition import AnyOf, Condition, Count, Not, Property, Relation
from app.domain.program import Described, PropertyValue
from app.domain.scene import Scene, SceneObject
from app.programs.knowledge.properties import colour_word
from app.programs.predicates import NAME

SPELLINGS = {"color": "colour", "type": "category", "class": "category"}


class Properties:
    """The properties of the objects, as their scene and their program describe them."""

    def __init__(self, scene: Scene, described: Sequence[Described] = ()) -> None:
        self._known: dict[str, dict[str, PropertyValue]] = {}
        for item in scene.objects:
            self._known[item.name] = dict(properties_of(item))
        for entry in described:
            self._describe(entry)
        self.names = frozenset(name for known in self._known.values() for name in known) | {NAME}
        """Every property that anything is known to have."""

    def decide(self, condition: Condition) -> Condition | bool:
        """What is left of the condition: true, false, or what the world has to decide.

        A property that no object has cannot be decided, and stays.
        """
        match condition:
            case Relation() | Count():
                return condition
            case Property():
                return self._holds(condition)
            case Not(inner):
                decided = self.decide(inner)
                return not decided if isinstance(decided, bool) else Not(decided)
            case AnyOf(conditions):
                return _any([self.decide(each) for each in conditions])

    def _describe(self, entry: Described) -> None:
        known = self._known.setdefault(entry.name, {})
        known.update({_spelt(name): value for name, value in entry.properties})
        for _, entries in entry.holds:
            for each in entries:
                self._describe(each)

    def _holds(self, wanted: Property) -> bool | Property:
        name = _spelt(wanted.name)
        if name == NAME:
            return wanted.subject == wanted.value
        if name not in self.names:
            return wanted
        value = self._known.get(wanted.subject, {}).get(name, False)
        values = value if isinstance(value, tuple) else (value,)
        return any(_same(each, wanted.value) for each in values)


def properties_of(item: SceneObject) -> Iterator[tuple[str, PropertyValue]]:
    """What a scene tells of an object, in a fixed order."""
    for name, value in (("kind", item.kind), ("category", item.category)):
        if value is not None:
            yield name, value
    if item.colour is not None:
        yield "colour", colour_word(item.colour)
    yield "container", item.container
    for name, value in item.properties:
        yield _spelt(name), value


def _spelt(name: str) -> str:
    return SPELLINGS.get(name, name)


def _same(value: str | float, wanted: str | float) -> bool:
    if isinstance(value, str) and isinstance(wanted, str):
        return value.casefold() == wanted.casefold()
    return value == wanted


def _any(decided: Sequence[Condition | bool]) -> Condition | bool:
    left = [each for each in decided if not isinstance(each, bool)]
    if len(left) < len(decided) and any(each is True for each in decided):
        return True
    if not left:
        return False
    return left[0] if len(left) == 1 < len(decided) else AnyOf(tuple(left))
