"""Program: what a language model wrote, parsed; nothing of it is ever executed as Python."""

from dataclasses import dataclass, field

from app.domain.condition import Condition

Argument = str | float
"""An object's name, or a number."""


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
    arguments: tuple[Argument, ...]
    line: int = field(default=0, compare=False)

    def __str__(self) -> str:
        return f"{self.action}({', '.join(map(literal, self.arguments))})"


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


Statement = Comment | ActionCall | Assertion | Pass


@dataclass(frozen=True, slots=True, kw_only=True)
class Program:
    """One task as a function over the scene's objects."""

    name: str
    objects: tuple[str, ...] | None = None
    """The object list local to the function, where the program states one."""
    body: tuple[Statement, ...] = ()


def literal(value: Argument) -> str:
    r"""The argument as a Python literal in single quotes: ``'driver\'s cup'``."""
    if not isinstance(value, str):
        return repr(value)
    escaped = "".join(
        f"\\{character}" if character in "\\'" else _printable(character) for character in value
    )
    return f"'{escaped}'"


def _printable(character: str) -> str:
    return character if character.isprintable() else repr(character)[1:-1]
