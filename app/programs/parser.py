"""Program text → ``Program``; nothing is ever executed, and what is not understood is refused.

The language: optional ``from actions import …`` lines, an optional ``objects = [...]`` (or a scene
graph, ``objects = {...}``), helper functions, then the task, ``def name():``, whose body holds an
optional docstring, an optional ``objects = [...]`` of its own, comments, calls of action primitives
and of helpers, ``pass``, ``return`` (which ends the function), loops over listed names or over the
objects, ``if`` and ``else``, and assertions, either as the paper writes them::

    assert('close' to 'lime')
        else: find('lime')

or as Python does: ``assert near('lime'), find('lime')``.
"""

from app.domain.errors import Fault, ProgramRefused
from app.domain.program import Described, Helper, Program
from app.programs.bodies import Body
from app.programs.cursor import Cursor
from app.programs.lexer import Line, read_lines, refuse
from app.programs.objects import read_objects
from app.programs.signatures import Signature, read_signature

MAX_FAULTS = 10
"""So many faulty lines are told of at once."""
MAX_STATEMENTS = 2000
MAX_HELPERS = 20


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
        self.objects: tuple[str, ...] | None = None
        self.described: tuple[Described, ...] = ()
        self.helpers: list[Helper] = []
        self.signature: Signature | None = None
        """Of the function that is being read."""
        self.body = Body(limit=MAX_STATEMENTS)
        self.known: dict[str, Signature] = {}
        self.called: set[str] = set()

    def program(self) -> Program:
        """The whole of it.

        Raises:
            ProgramRefused: there is no function, or nothing but comments in it.
        """
        if self.signature is None:
            wanted = "has no function; write def task_name(): and the calls indented below it"
            raise ProgramRefused(Fault(field="program", message=wanted))
        if self.signature.parameters:
            refuse(self.signature.line, "a plan takes no parameters: def name():")
        body = self.body.finish()
        if not self.body.says_something:
            wanted = "has no statement in its function; write pass if there is nothing to do"
            raise ProgramRefused(Fault(field="program", message=wanted))
        self.called |= self.body.called
        for helper in self.helpers:
            if helper.name not in self.called:
                refuse(
                    helper.line,
                    "a program is one function and the helpers it calls; "
                    f"nothing calls {helper.name[:80]}",
                )
        return Program(
            name=self.signature.name,
            objects=self.objects,
            described=self.described,
            helpers=tuple(self.helpers),
            body=body,
        )

    def take(self, line: Line) -> None:
        """Read one more line."""
        if self.signature is None:
            self._take_header(Cursor(line))
        elif line.indent or line.tokens[0].kind == "comment":
            self._take_body(line)
        elif Cursor(line).sees("def"):
            self._end_helper(self.signature)
            self._begin(Cursor(line))
        else:
            refuse(line.number, "stands outside the function; indent it or remove it")

    def _take_header(self, cursor: Cursor) -> None:
        token = cursor.line.tokens[0]
        if token.kind in ("comment", "string"):
            return
        if cursor.line.indent:
            refuse(token.line, "is indented, but stands in no function; write def name(): above it")
        if cursor.takes("from"):
            _check_import(cursor)
        elif cursor.sees("objects"):
            self.objects, self.described = read_objects(cursor)
        elif cursor.sees("def"):
            self._begin(cursor)
        else:
            refuse(
                token.line,
                "before the function only from actions import … and objects = [...] may stand, "
                f"not {cursor.shown()}",
            )

    def _take_body(self, line: Line) -> None:
        cursor = Cursor(line)
        if not line.indent:
            return  # A remark between functions.
        if cursor.sees("objects") and cursor.sees("=", distance=1):
            objects = read_objects(cursor)
            if not self.body.fresh:
                refuse(line.number, "the object list stands above the first statement; move it up")
            self.objects, self.described = objects
            return
        self.body.take(line)

    def _begin(self, cursor: Cursor) -> None:
        self.signature = signature = read_signature(cursor)
        if signature.name in self.known:
            refuse(signature.line, f"{signature.name[:80]} is defined twice")
        self.body = Body(
            limit=MAX_STATEMENTS - self.body.statements,
            variables=signature.parameters,
            helpers=self.known,
        )

    def _end_helper(self, signature: Signature) -> None:
        """The function read so far is a helper, since another one follows."""
        body = self.body.finish()
        if not self.body.says_something:
            refuse(signature.line, f"{signature.name[:80]} does nothing; write pass if it is to")
        if len(self.helpers) >= MAX_HELPERS:
            refuse(
                signature.line, f"there are more than {MAX_HELPERS} helpers; write out the calls"
            )
        self.called |= self.body.called
        self.known = {**self.known, signature.name: signature}
        self.helpers.append(
            Helper(
                name=signature.name,
                parameters=signature.parameters,
                body=body,
                line=signature.line,
            )
        )


def _check_import(cursor: Cursor) -> None:
    if not (cursor.takes("actions") and cursor.takes("import")):
        refuse(cursor.number, "only from actions import … is taken; remove other imports")
