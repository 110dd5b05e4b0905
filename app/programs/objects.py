"""The object list of a program, or its scene graph: nested dicts of what is where and of what kind.

``objects = {'tray': {'material': 'wood', 'on it': {'cup': {'colour': 'red'}}}, 'lime': {}}``
"""

from collections.abc import Sequence

from app.domain.program import HOLDS, Described, PropertyValue, literal
from app.programs.cursor import Cursor
from app.programs.lexer import refuse

_WANTED = "the object list reads objects = ['lime', 'bowl'] or objects = {'lime': {…}, …}"
_COMMAS = "names stand with commas between them"
TEXT = "is"
"""The property of an entry that is a text: ``{'lime': 'green fruit'}``."""


def read_objects(cursor: Cursor) -> tuple[tuple[str, ...], tuple[Described, ...]]:
    """Names and, where the list is a scene graph, their descriptions.

    Raises:
        ProgramRefused: it is neither a list of names nor a dict of descriptions.
    """
    cursor.takes("objects")
    cursor.expect("=", _WANTED)
    described: tuple[Described, ...] = ()
    if cursor.takes("{"):
        described = _entries(cursor)
        names = tuple(name for entry in described for name in entry.names)
    else:
        cursor.expect("[", _WANTED)
        names = tuple(_quoted(cursor) for _ in cursor.items("]", _COMMAS))
    cursor.finish("the object list stands alone on its line")
    return names, described


def objects_line(names: Sequence[str], described: Sequence[Described] = ()) -> str:
    """The line that states them: ``objects = ['lime', 'bowl']``."""
    if described:
        return f"objects = {_graph(described)}"
    return f"objects = [{', '.join(map(literal, names))}]"


def _entries(cursor: Cursor) -> tuple[Described, ...]:
    """The entries of a dict whose opening brace is behind."""
    return tuple(_entry(cursor) for _ in cursor.items("}", _COMMAS))


def _entry(cursor: Cursor) -> Described:
    name = _quoted(cursor)
    cursor.expect(":", "after an object's name comes what is known of it: 'lime': {…}")
    if not cursor.takes("{"):
        return Described(name=name, properties=((TEXT, _value(cursor)),))
    properties: list[tuple[str, PropertyValue]] = []
    holds: list[tuple[str, tuple[Described, ...]]] = []
    for _ in cursor.items("}", "properties stand with commas between them"):
        key = cursor.take("string", "a property has a name in quotes").text
        cursor.expect(":", "a property reads 'colour': 'red'")
        if key in HOLDS:
            holds.append((key, _held(cursor)))
        else:
            properties.append((key, _value(cursor)))
    return Described(name=name, properties=tuple(properties), holds=tuple(holds))


def _held(cursor: Cursor) -> tuple[Described, ...]:
    if cursor.takes("{"):
        return _entries(cursor)
    cursor.expect("[", "what an object holds reads 'in it': ['lime'] or 'in it': {'lime': {…}}")
    return tuple(Described(name=_quoted(cursor)) for _ in cursor.items("]", _COMMAS))


def _value(cursor: Cursor) -> PropertyValue:
    if cursor.sees("{"):
        refuse(cursor.number, f"other objects stand under {' or '.join(map(repr, HOLDS))} only")
    if cursor.takes("["):
        return tuple(_quoted(cursor) for _ in cursor.items("]", _COMMAS))
    truth = cursor.truth()
    return cursor.argument() if truth is None else truth


def _quoted(cursor: Cursor) -> str:
    return cursor.take("string", "the list holds names in quotes").text


def _graph(entries: Sequence[Described]) -> str:
    return f"{{{', '.join(f'{literal(each.name)}: {_properties(each)}' for each in entries)}}}"


def _properties(entry: Described) -> str:
    told = [f"{literal(key)}: {_shown(value)}" for key, value in entry.properties]
    told += [f"{literal(place)}: {_graph(entries)}" for place, entries in entry.holds]
    return f"{{{', '.join(told)}}}"


def _shown(value: PropertyValue) -> str:
    return f"[{', '.join(map(literal, value))}]" if isinstance(value, tuple) else literal(value)
