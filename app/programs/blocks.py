"""A block of a function: a loop's or a branch's statements, under its head."""

from collections.abc import Sequence
from dataclasses import dataclass, field

from app.domain.condition import Condition
from app.domain.program import Branch, Comment, Loop, Statement
from app.programs.signatures import LoopHead


@dataclass(slots=True)
class Block:
    """Statements under one head."""

    outer: int
    """Columns before the head; 0 of the function."""
    line: int
    head: LoopHead | Condition | None = None
    """Of a loop, or of a branch; None of the function itself."""
    indent: int | None = None
    """Columns before the statements, once the first of them is read."""
    statements: list[Statement] = field(default_factory=list[Statement])
    first: tuple[Statement, ...] | None = None
    """Of what stands after ``else:``, what stands before it."""


def awaits_else(block: Block, indent: int) -> bool:
    """Whether it is what stands before the ``else:`` at so many columns."""
    branch = block.head is not None and not isinstance(block.head, LoopHead)
    return branch and block.first is None and block.outer == indent


def closed(block: Block) -> Statement:
    """The statement that the block makes, once it is read."""
    body = tuple(block.statements)
    match block.head:
        case LoopHead(variable, items, condition):
            return Loop(
                variable=variable, items=items, condition=condition, body=body, line=block.line
            )
        case None:
            raise AssertionError("a function is no statement")
        case condition if block.first is None:
            return Branch(condition=condition, body=body, line=block.line)
        case condition:
            return Branch(condition=condition, body=block.first, otherwise=body, line=block.line)


def says_something(statements: Sequence[Statement]) -> bool:
    """Whether there is any statement but comments."""
    return not all(isinstance(statement, Comment) for statement in statements)
