"""Program: what a language model wrote, parsed; nothing of it is ever executed as Python."""

from dataclasses import dataclass, field

from app.domain.condition import Condition

Argument = str | float
"""An object's name, or a number; a ``Variable`` stands for either until it is unrolled."""


class Variable(str):
    """The name of a loop's variable or of a helper's parameter, where an argument may stand.

    It is never equal to the same text as an object's name. ``offset`` is added to the number it
    stands for: ``x + 0.1``.
    """

    __slots__ = ("offset",)
    offset: float

    def __new__(cls, name: str, offset: float = 0.0) -> "Variable":
        """The variable of this name."""
        made = super().__new__(cls, name)
        made.offset = offset
        return made

    def __eq__(self, other: object) -> bool:
        """Whether it is the same variable with the same offset."""
        if not isinstance(other, Variable):
            return False
        return str.__eq__(self, other) and self.offset == other.offset

    def __ne__(self, other: object) -> bool:
        """Whether it is not."""
        return not self == other

    def __hash__(self) -> int:
        """Of the name and the offset."""
        return hash(("Variable", str(self), self.offset))

    def __repr__(self) -> str:
        """As it is written."""
        return f"Variable({literal(self)})"


@dataclass(frozen=True, slots=True, kw_only=True)
class Comment:
    """A natural-language summary of the sub-task that follows."""

    text: str
    line: int = field(default=0, compare=False)
    """1-based line of the program's text; where a statement stands is not what it says."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ActionCall:
    """An action primitive applied to objects: ``grab_and_putin('banana', 'bowl')``."""

    action: str
    """An action primitive's name, or a helper's."""
    arguments: tuple[Argument, ...] = ()
    keywords: tuple[tuple[str, Argument], ...] = ()
    """Arguments by the name of their parameter: ``place('banana', x=0.4)``."""
    line: int = field(default=0, compare=False)

    def __str__(self) -> str:
        named = (f"{name}={literal(value)}" for name, value in self.keywords)
        return f"{self.action}({', '.join((*map(literal, self.arguments), *named))})"


@dataclass(frozen=True, slots=True, kw_only=True)
class Assertion:
    """A condition the program demands, and the calls that make it so where it is false."""

    condition: Condition
    recovery: tuple[ActionCall, ...] = ()
    line: int = field(default=0, compare=False)


@dataclass(frozen=True, slots=True, kw_only=True)
class Pass:
    """Nothing to do; a program that is only this declines the task."""

    line: int = field(default=0, compare=False)


@dataclass(frozen=True, slots=True, kw_only=True)
class Branch:
    """``if condition: … else: …``, decided where the plan has come to it."""

    condition: Condition
    body: tuple["Statement", ...]
    otherwise: tuple["Statement", ...] = ()
    line: int = field(default=0, compare=False)


@dataclass(frozen=True, slots=True, kw_only=True)
class Loop:
    """``for variable in …:``, over the names and numbers that are listed or over the objects."""

    variable: str
    items: tuple[Argument, ...] | None
    """What it goes through; None for all objects of the program's list."""
    condition: Condition | None = None
    """Which of them: ``[each for each in objects if category(each) == 'fruit']``, speaking of the variable."""
    body: tuple["Statement", ...]
    line: int = field(default=0, compare=False)


Statement = Comment | ActionCall | Assertion | Pass | Branch | Loop


@dataclass(frozen=True, slots=True, kw_only=True)
class Helper:
    """A function that the task, or a later helper, calls: ``def put_away(item, place):``."""

    name: str
    parameters: tuple[str, ...]
    body: tuple[Statement, ...]
    line: int = field(default=0, compare=False)


PropertyValue = str | float | bool | tuple[str, ...]
HOLDS = ("in it", "on it")
"""The keys of a described object under which other objects stand."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Described:
    """An entry of a scene graph: an object with its properties and with what it holds."""

    name: str
    properties: tuple[tuple[str, PropertyValue], ...] = ()
    holds: tuple[tuple[str, tuple["Described", ...]], ...] = ()
    """Under one or both of ``HOLDS``."""

    @property
    def names(self) -> tuple[str, ...]:
        """Its own name and those of all that it holds, as they are written."""
        inner = (entry.names for _, entries in self.holds for entry in entries)
        return (self.name, *(name for names in inner for name in names))


@dataclass(frozen=True, slots=True, kw_only=True)
class Program:
    """One task as a function over the scene's objects."""

    name: str
    objects: tuple[str, ...] | None = None
    """The object list, where the program states one."""
    described: tuple[Described, ...] = ()
    """The same as a scene graph, where it is stated as one: the names are those of ``objects``."""
    helpers: tuple[Helper, ...] = ()
    """Each calls none but earlier ones."""
    body: tuple[Statement, ...] = ()


def literal(value: Argument) -> str:
    r"""The argument as Python writes it: a text in single quotes, ``'driver\'s cup'``."""
    if isinstance(value, Variable):
        sign = "-" if value.offset < 0 else "+"
        return f"{value} {sign} {abs(value.offset)!r}" if value.offset else f"{value}"
    if not isinstance(value, str):
        return repr(value)
    escaped = "".join(
        f"\\{character}" if character in "\\'" else _printable(character) for character in value
    )
    return f"'{escaped}'"


def _printable(character: str) -> str:
    return character if character.isprintable() else repr(character)[1:-1]
