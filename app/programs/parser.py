"""Program text → ``Program``; nothing is ever executed, and what is not understood is refused.

The language: optional ``from actions import …`` lines, an optional ``objects = [...]``, then one
``def name():`` whose body holds an optional docstring, an optional ``objects = [...]`` of its own,
comments, calls of action primitives on quoted names and numbers, ``pass``, ``return`` (which ends
the program), and assertions, either as the paper writes them::

    assert('close' to 'lime')
        else: find('lime')

or as Python does: ``assert near('lime'), find('lime')``.
"""

import keyword
from dataclasses import replace

from app.domain.errors import Fault, ProgramRefused
from app.domain.program import Assertion, Comment, Pass, Program, Statement
from app.programs.assertions import read_call, read_condition, read_recovery
from app.programs.cursor import Cursor
from app.programs.lexer import Line, read_lines, refuse

MAX_STATEMENTS = 2000
MAX_FAULTS = 10
"""So many faulty lines are told of at once."""

_FOREIGN = frozenset(keyword.kwlist)


def parse_program(text: str) -> Program:
    """Read a program.

    Raises:
        ProgramRefused: it is outside the plan language; each fault names its line.
    """
    reading = _Reading()
    faults: list[Fault] = []
    try:
        for line in read_lines(text):
            try:
                reading.take(line)
            except ProgramRefused as refused:
                faults += refused.faults
                if len(faults) >= MAX_FAULTS:
                    break
    except ProgramRefused as refused:
        faults += refused.faults
    if faults:
        raise ProgramRefused(*faults)
    return reading.program()


class _Reading:
    """What has been read of a program so far."""

    def __init__(self) -> None:
        self.name: str | None = None
        self.objects: tuple[str, ...] | None = None
        self.body: list[Statement] = []
        self.statements = 0
        self.indent: int | None = None
        """Columns before the body's statements, once the first of them is read."""
        self.ended = False
        """A ``return`` was read: what follows is checked, and left out."""

    def program(self) -> Program:
        """The whole of it.

        Raises:
            ProgramRefused: there is no function, or nothing but comments in it.
        """
        if self.name is None:
            wanted = "has no function; write def task_name(): and the calls indented below it"
            raise ProgramRefused(Fault(field="program", message=wanted))
        if all(isinstance(statement, Comment) for statement in self.body):
            wanted = "has no statement in its function; write pass if there is nothing to do"
            raise ProgramRefused(Fault(field="program", message=wanted))
        return Program(name=self.name, objects=self.objects, body=tuple(self.body))

    def take(self, line: Line) -> None:
        """Read one more line."""
        cursor = Cursor(line)
        if self.name is None:
            self._take_header(cursor)
        else:
            self._take_body(cursor)

    def _take_header(self, cursor: Cursor) -> None:
        token = cursor.line.tokens[0]
        if token.kind in ("comment", "string"):
            return
        if cursor.line.indent:
            refuse(token.line, "is indented, but stands in no function; write def name(): above it")
        if cursor.takes("from"):
            _check_import(cursor)
        elif cursor.sees("objects"):
            self.objects = _objects(cursor)
        elif cursor.takes("def"):
            self.name = _function_name(cursor)
        else:
            refuse(
                token.line,
                "before the function only from actions import … and objects = [...] may stand, "
                f"not {cursor.shown()}",
            )

    def _take_body(self, cursor: Cursor) -> None:
        token = cursor.line.tokens[0]
        if token.kind == "comment":
            if cursor.line.indent:
                self._add(Comment(text=token.text, line=token.line))
            return
        self._check_place(cursor)
        if cursor.sees("else"):
            self._take_else(cursor)
        elif cursor.sees("objects") and cursor.sees("=", distance=1):
            objects = _objects(cursor)
            if self.body and not all(isinstance(each, Comment) for each in self.body):
                refuse(token.line, "the object list stands above the first statement; move it up")
            self.objects = objects
        elif token.kind == "string":
            if self.body:
                refuse(token.line, "a string does nothing here; write a comment with #")
            cursor.take("string", "a docstring")
            cursor.finish("a docstring stands alone on its line")
        else:
            self._take_statement(cursor)

    def _check_place(self, cursor: Cursor) -> None:
        line = cursor.line
        if cursor.sees("def") or cursor.sees("class"):
            refuse(line.number, "a program is one function; remove this one")
        if not line.indent:
            refuse(line.number, "stands outside the function; indent it or remove it")
        if self.indent is None:
            self.indent = line.indent
        deeper = line.indent > self.indent
        if line.indent != self.indent and not (deeper and cursor.sees("else")):
            refuse(
                line.number,
                f"is indented by {line.indent} columns where the body has {self.indent}; "
                "there are no blocks in a plan, align it",
            )

    def _take_statement(self, cursor: Cursor) -> None:
        token = cursor.line.tokens[0]
        statement: Statement
        if cursor.takes("pass"):
            statement = Pass(line=token.line)
        elif cursor.takes("return"):
            statement = Pass(line=token.line)
            cursor.finish("return takes no value")
            if all(isinstance(each, Comment) for each in self.body):
                self._add(statement)
            self.ended = True
            return
        elif cursor.takes("assert"):
            statement = _assertion(cursor, token.line)
        else:
            _check_call(cursor)
            statement = read_call(cursor)
        cursor.finish("one statement stands on a line, with no operators")
        if cursor.next is not None:
            self._add(Comment(text=cursor.next.text, line=token.line))
        self._add(statement)

    def _take_else(self, cursor: Cursor) -> None:
        cursor.takes("else")
        cursor.expect(":", "a recovery reads else: find('lime')")
        line = cursor.number
        if cursor.next is None:
            refuse(line, "write the recovery on the same line: else: find('lime')")
        call = read_call(cursor)
        cursor.finish("one recovery stands on a line")
        if self.ended:
            return
        last = self.body[-1] if self.body else None
        if not isinstance(last, Assertion):
            refuse(line, "else: follows an assertion; there is none above this line")
        self._count(line)
        self.body[-1] = replace(last, recovery=(*last.recovery, call))

    def _add(self, statement: Statement) -> None:
        if self.ended:
            return
        self._count(statement.line)
        if isinstance(statement, Assertion):
            self.statements += len(statement.recovery)
        self.body.append(statement)

    def _count(self, line: int) -> None:
        self.statements += 1
        if self.statements > MAX_STATEMENTS:
            refuse(line, f"there are more than {MAX_STATEMENTS} statements; split the task")


def _check_import(cursor: Cursor) -> None:
    if not (cursor.takes("actions") and cursor.takes("import")):
        refuse(cursor.number, "only from actions import … is taken; remove other imports")


def _function_name(cursor: Cursor) -> str:
    name = cursor.take("name", "a function has a name, like def put_away():").text
    cursor.expect("(", "a function reads def name():")
    cursor.expect(")", "a plan takes no parameters: def name():")
    cursor.expect(":", "a function reads def name():")
    cursor.finish("the body stands on the lines below")
    return name


def _objects(cursor: Cursor) -> tuple[str, ...]:
    cursor.takes("objects")
    cursor.expect("=", "the object list reads objects = ['lime', 'bowl']")
    cursor.expect("[", "the object list reads objects = ['lime', 'bowl']")
    found: list[str] = []
    cursor.skip_comments()
    while not cursor.takes("]"):
        found.append(cursor.take("string", "the list holds names in quotes").text)
        cursor.skip_comments()
        if not cursor.sees("]"):
            cursor.expect(",", "names stand with commas between them")
            cursor.skip_comments()
    cursor.finish("the object list stands alone on its line")
    return tuple(found)


def _assertion(cursor: Cursor, line: int) -> Assertion:
    condition = read_condition(cursor)
    recovery = read_recovery(cursor) if cursor.takes(",") else ()
    return Assertion(condition=condition, recovery=recovery, line=line)


def _check_call(cursor: Cursor) -> None:
    """A better message for what is Python, but no call of an action."""
    token = cursor.line.tokens[0]
    if token.kind == "name" and token.text in _FOREIGN:
        refuse(token.line, f"{token.text} is not part of the plan language; write out the calls")
    if token.kind == "name" and cursor.sees(".", distance=1):
        refuse(token.line, "attributes are not part of the plan language; call an action by name")
    if token.kind == "name" and cursor.sees("=", distance=1):
        refuse(token.line, "only objects = [...] is assigned; write names in quotes in the calls")
