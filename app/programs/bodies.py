"""The body of a function, read line by line: statements, and blocks told by their indentation."""

import keyword
from collections.abc import Mapping, Sequence
from dataclasses import replace

from app.domain.program import ActionCall, Assertion, Comment, Pass, Statement
from app.programs.assertions import read_assertion, read_call
from app.programs.blocks import Block, awaits_else, closed, says_something
from app.programs.cursor import Cursor
from app.programs.lexer import Line, refuse
from app.programs.signatures import (
    LoopHead,
    Signature,
    check_helper_call,
    read_branch,
    read_loop,
)

MAX_NESTING = 4
"""Blocks within blocks."""

_FOREIGN = frozenset(keyword.kwlist)


class Body:
    """What has been read of a function so far."""

    def __init__(
        self,
        *,
        limit: int,
        variables: Sequence[str] = (),
        helpers: Mapping[str, Signature] | None = None,
    ) -> None:
        """Begin.

        Args:
            limit: so many statements it may hold.
            variables: the function's parameters.
            helpers: what may be called besides action primitives.
        """
        self.statements = 0
        self.called: set[str] = set()
        """The helpers that are called."""
        self._limit = limit
        self._parameters = frozenset(variables)
        self._helpers = helpers or {}
        self._blocks = [Block(0, 0)]
        self._pending: list[tuple[int, Comment]] = []
        """Comments with their indentation; the next statement tells which block they are in."""
        self._ended = False
        """A ``return`` was read: what follows is checked, and left out."""

    @property
    def fresh(self) -> bool:
        """Whether nothing but comments was read."""
        return not self.says_something and len(self._blocks) == 1

    @property
    def says_something(self) -> bool:
        """Whether there is any statement but comments."""
        return says_something(self._blocks[0].statements)

    def finish(self) -> tuple[Statement, ...]:
        """The function is through.

        Raises:
            ProgramRefused: a block of it holds nothing.
        """
        self._place_comments(0)
        self._close(0)
        return tuple(self._blocks[0].statements)

    def take(self, line: Line) -> None:
        """Read one more line, which is indented.

        Raises:
            ProgramRefused: it is outside the plan language.
        """
        cursor = Cursor(line)
        token = line.tokens[0]
        if token.kind == "comment":
            self._pending.append((line.indent, Comment(text=token.text, line=token.line)))
        elif cursor.takes("else"):
            self._take_else(cursor)
        elif token.kind == "string":
            if not self.fresh or self._pending:
                refuse(token.line, "a string does nothing here; write a comment with #")
            cursor.take("string", "a docstring")
            cursor.finish("a docstring stands alone on its line")
        else:
            self._find_place(cursor)
            self._take_statement(cursor)

    def _find_place(self, cursor: Cursor) -> None:
        """Close the blocks that end before this line."""
        line = cursor.line
        if cursor.sees("def") or cursor.sees("class"):
            refuse(line.number, "a plan is one function, its helpers stand above it; remove this")
        self._place_comments(line.indent)
        self._close(line.indent)
        block = self._blocks[-1]
        if block.indent is None and line.indent > block.outer:
            block.indent = line.indent
        if line.indent != block.indent:
            refuse(
                line.number,
                f"is indented by {line.indent} columns where the body has {block.indent}; "
                "only for, if and else: open blocks in a plan, align it",
            )
        cursor.variables = self._variables()

    def _take_statement(self, cursor: Cursor) -> None:
        line = cursor.line.tokens[0].line
        if cursor.takes("for"):
            head = read_loop(cursor)
            self._remark(cursor)
            self._open(Block(cursor.line.indent, line, head))
        elif cursor.takes("if"):
            condition = read_branch(cursor)
            self._remark(cursor)
            self._open(Block(cursor.line.indent, line, condition))
        elif cursor.takes("return"):
            self._return(cursor, line)
        else:
            statement = self._simple(cursor, line)
            cursor.finish("one statement stands on a line, with no operators")
            self._remark(cursor)
            self._add(statement)

    def _simple(self, cursor: Cursor, line: int) -> Statement:
        if cursor.takes("pass"):
            return Pass(line=line)
        if cursor.takes("assert"):
            return read_assertion(cursor, line)
        _check_call(cursor)
        call = read_call(cursor)
        if call.action in self._helpers:
            check_helper_call(call, self._helpers[call.action])
            self.called.add(call.action)
        return call

    def _return(self, cursor: Cursor, line: int) -> None:
        cursor.finish("return takes no value")
        if len(self._blocks) > 1:
            refuse(line, "return ends a function, and does not stand in a block")
        if not self.says_something:
            self._add(Pass(line=line))
        self._ended = True

    def _take_else(self, cursor: Cursor) -> None:
        cursor.expect(":", "a recovery reads else: find('lime')")
        if cursor.next is None or cursor.next.kind == "comment":
            self._take_otherwise(cursor)
            return
        line, block = cursor.number, self._blocks[-1]
        if block.indent is not None and cursor.line.indent < block.indent:
            refuse(line, "write what is to be done on the lines below else:")
        cursor.variables = self._variables()
        call = read_call(cursor)
        cursor.finish("one recovery stands on a line")
        if self._ended:
            return
        last = block.statements[-1] if block.statements and not self._pending else None
        if not isinstance(last, Assertion):
            refuse(line, "else: follows an assertion; there is none above this line")
        self._count(line)
        self._check_recovery(call)
        block.statements[-1] = replace(last, recovery=(*last.recovery, call))

    def _take_otherwise(self, cursor: Cursor) -> None:
        """The other side of a branch, whose ``if`` stands above this ``else:``."""
        indent, line = cursor.line.indent, cursor.line.number
        place = next(
            (at for at, each in enumerate(self._blocks) if awaits_else(each, indent)), None
        )
        if place is None:
            last = self._blocks[-1].statements[-1:]
            if last and isinstance(last[0], Assertion):
                refuse(line, "write the recovery on the same line: else: find('lime')")
            refuse(line, "else: stands below the if it belongs to, or below an assertion")
        block = self._blocks[place]
        self._place_comments(block.indent or 0)
        self._close_down_to(place + 1)
        self._check_block(block)
        block.first, block.statements = tuple(block.statements), []
        block.indent = None
        self._remark(cursor)

    def _open(self, block: Block) -> None:
        if len(self._blocks) > MAX_NESTING:
            refuse(block.line, f"blocks nest deeper than {MAX_NESTING}; write a helper")
        self._count(block.line)
        self._blocks.append(block)

    def _close(self, indent: int) -> None:
        """End the blocks that a line with so many columns before it is not in."""
        while len(self._blocks) > 1 and indent <= self._blocks[-1].outer:
            self._close_down_to(len(self._blocks) - 1)

    def _close_down_to(self, depth: int) -> None:
        while len(self._blocks) > depth:
            block = self._blocks.pop()
            self._check_block(block)
            if not self._ended:
                self._blocks[-1].statements.append(closed(block))

    def _check_block(self, block: Block) -> None:
        if not says_something(block.statements):
            refuse(block.line, "a block holds at least one statement; write pass if none is wanted")

    def _place_comments(self, indent: int) -> None:
        """Put the comments read since the last statement into their blocks."""
        pending, self._pending = self._pending, []
        for columns, comment in pending:
            self._close(max(columns, indent))
            self._add(comment)

    def _remark(self, cursor: Cursor) -> None:
        """A comment at the end of a line stands above it."""
        if cursor.next is not None:
            self._add(Comment(text=cursor.next.text, line=cursor.line.tokens[0].line))

    def _add(self, statement: Statement) -> None:
        if self._ended:
            return
        self._count(statement.line)
        if isinstance(statement, Assertion):
            self.statements += len(statement.recovery)
            for call in statement.recovery:
                self._check_recovery(call)
        self._blocks[-1].statements.append(statement)

    def _check_recovery(self, call: ActionCall) -> None:
        if call.action in self._helpers:
            refuse(call.line, f"a recovery is an action, and {call.action[:80]} is a helper")

    def _count(self, line: int) -> None:
        self.statements += 1
        if self.statements > self._limit:
            refuse(line, "there are more than 2000 statements; split the task")

    def _variables(self) -> frozenset[str]:
        bound = (each.head.variable for each in self._blocks if isinstance(each.head, LoopHead))
        return self._parameters | frozenset(bound)


def _check_call(cursor: Cursor) -> None:
    """A better message for what is Python, but no call of an action."""
    token = cursor.line.tokens[0]
    if token.kind != "name":
        return
    if token.text == "elif":
        refuse(token.line, "elif is not part of the plan language; write else: and an if below it")
    if token.text in _FOREIGN:
        refuse(token.line, f"{token.text} is not part of the plan language; write out the calls")
    if cursor.sees(".", distance=1):
        refuse(token.line, "attributes are not part of the plan language; call an action by name")
    if cursor.sees("=", distance=1):
        refuse(token.line, "only objects = [...] is assigned; write names in quotes in the calls")
