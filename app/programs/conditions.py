"""Goal conditions as clients write them: text ↔ ``Condition``, and whether a scene can decide it.

``in(banana, bowl)``, ``not open(drawer)``, ``any_of(in(cup, box), on(cup, tray))``,
``count(box; red block | blue block) = 1``. Names may hold spaces, quotes and balanced brackets; a
name with a comma, a bar or the like stands in quotes, with backslash escapes.
"""

import difflib
import re
from collections.abc import Mapping, Sequence
from typing import NoReturn

from app.domain.condition import AnyOf, Condition, Count, Not, Property, Relation, relations
from app.domain.errors import Fault, GoalRefused
from app.domain.goal import Goal
from app.domain.program import Variable, literal
from app.domain.scene import Scene

MAX_CHARACTERS = 10_000
MAX_DEPTH = 8
MAX_CONDITIONS = 200
EXAMPLE = "in(banana, bowl), not open(drawer), any_of(…, …) or count(box; cup | mug) = 2"

_SPACE = re.compile(r"\s*")
_WORD = re.compile(r"[A-Za-z_]\w*")
_NUMBER = re.compile(r"[0-9]{1,4}(?![0-9])")
_QUOTED = re.compile(r"'([^'\\]*(?:\\.[^'\\]*)*)'|\"([^\"\\]*(?:\\.[^\"\\]*)*)\"")
_ESCAPE = re.compile(r"\\(x[0-9a-f]{2}|u[0-9a-f]{4}|U00(?:0[0-9a-f]|10)[0-9a-f]{4}|.)")
_NAMED_ESCAPES = {"n": "\n", "r": "\r", "t": "\t"}
_PLAIN = re.compile(r"\w+( \w+)*")
"""What is printed without quotes."""


def parse_condition(text: str, *, field: str = "goal") -> Condition:
    """Read one goal condition.

    Raises:
        GoalRefused: it is malformed; the fault names ``field``.
    """
    if len(text) > MAX_CHARACTERS:
        message = f"has {len(text)} characters; at most {MAX_CHARACTERS} are taken"
        raise GoalRefused(Fault(field=field, message=message))
    reading = _Reading(text, field)
    condition = reading.condition(0)
    if reading.position < len(text):
        reading.refuse(f"goes on after its end with {text[reading.position :][:40]!r}")
    return condition


def print_condition(condition: Condition) -> str:
    """The condition as a client would write it; parsing gives it back."""
    match condition:
        case Relation(name, arguments):
            return f"{name}({', '.join(map(_shown, arguments))})"
        case Not(inner):
            return f"not {print_condition(inner)}"
        case AnyOf(conditions):
            return f"any_of({', '.join(map(print_condition, conditions))})"
        case Count(container, objects, number):
            return f"count({_shown(container)}; {' | '.join(map(_shown, objects))}) = {number}"
        case Property(name, subject, value):
            return f"{name}({_shown(subject)}) == {literal(value)}"


def check_condition(
    condition: Condition, scene: Scene, known: Mapping[str, int], *, field: str = "goal"
) -> None:
    """Whether the scene's world can decide it; ``known`` relations by number of arguments.

    Raises:
        GoalRefused: a relation or an object is not known, or the number of objects is wrong.
    """
    names = frozenset(scene.names if scene.agent is None else (*scene.names, scene.agent))
    for relation in relations(condition):
        message = _relation_fault(relation, known) or _object_fault(relation, names)
        if message:
            raise GoalRefused(Fault(field=field, message=message))


def parse_goal(texts: Sequence[str], scene: Scene, known: Mapping[str, int]) -> Goal:
    """Read all goal conditions of a request.

    Raises:
        GoalRefused: with a fault for every condition that is wrong, named ``goal.0`` and so on.
    """
    if len(texts) > MAX_CONDITIONS:
        message = f"has {len(texts)} conditions; at most {MAX_CONDITIONS} are taken"
        raise GoalRefused(Fault(field="goal", message=message))
    found: list[Condition] = []
    faults: list[Fault] = []
    for index, text in enumerate(texts):
        try:
            condition = parse_condition(text, field=f"goal.{index}")
            check_condition(condition, scene, known, field=f"goal.{index}")
            found.append(condition)
        except GoalRefused as refused:
            faults += refused.faults
    if faults:
        raise GoalRefused(*faults)
    return Goal(tuple(found))


def nearest(name: str, names: Sequence[str]) -> str | None:
    """The known name most like this one, if any is like it."""
    if len(name) > 100:
        return None
    close = difflib.get_close_matches(name, names, n=1)
    return close[0] if close else None


def _relation_fault(relation: Relation, known: Mapping[str, int]) -> str | None:
    if relation.name not in known:
        return f"there is no relation {relation.name!r}; known: {', '.join(sorted(known))}"
    wanted = known[relation.name]
    if len(relation.arguments) != wanted:
        return f"{relation.name} speaks of {wanted} object(s), not {len(relation.arguments)}"
    if len(set(relation.arguments)) < wanted:
        return f"{relation.name} speaks of different objects, not {relation.arguments[0]!r} twice"
    return None


def _object_fault(relation: Relation, names: frozenset[str]) -> str | None:
    for name in relation.arguments:
        if name not in names:
            likely = nearest(name, sorted(names))
            hint = f"did you mean {likely!r}?" if likely else f"there is: {_listed(names)}"
            return f"there is no object {name[:80]!r} in the scene; {hint}"
    return None


def _listed(names: frozenset[str]) -> str:
    listed = sorted(names)
    return ", ".join(listed[:20]) + (", …" if len(listed) > 20 else "") if listed else "nothing"


def _shown(name: str) -> str:
    return name if isinstance(name, Variable) or _PLAIN.fullmatch(name) else literal(name)


class _Reading:
    """A condition's text and the place in it that was come to."""

    def __init__(self, text: str, field: str) -> None:
        self.text = text
        self.field = field
        self.position = 0

    def refuse(self, message: str) -> NoReturn:
        raise GoalRefused(Fault(field=self.field, message=f"{message}; write {EXAMPLE}"))

    def match(self, pattern: re.Pattern[str]) -> re.Match[str] | None:
        found = pattern.match(self.text, self.position)
        if found:
            self.position = found.end()
        return found

    def takes(self, symbol: str) -> bool:
        self.match(_SPACE)
        if not self.text.startswith(symbol, self.position):
            return False
        self.position += len(symbol)
        self.match(_SPACE)
        return True

    def expect(self, symbol: str) -> None:
        if not self.takes(symbol):
            rest = self.text[self.position :][:40]
            self.refuse(f"{symbol!r} is missing before {rest!r}" if rest else f"lacks a {symbol!r}")

    def condition(self, depth: int) -> Condition:
        if depth > MAX_DEPTH:
            self.refuse(f"nests deeper than {MAX_DEPTH}")
        self.match(_SPACE)
        word = self.match(_WORD)
        if word is None:
            self.refuse(f"no condition begins with {self.text[self.position :][:40]!r}")
        if word[0] == "not":
            return Not(self.condition(depth + 1))
        self.expect("(")
        if word[0] == "any_of":
            found = [self.condition(depth + 1)]
            while self.takes(","):
                found.append(self.condition(depth + 1))
            self.expect(")")
            return AnyOf(tuple(found))
        return self.count() if word[0] == "count" else self.relation(word[0])

    def relation(self, name: str) -> Relation:
        arguments = [self.name()]
        while self.takes(","):
            arguments.append(self.name())
        self.expect(")")
        return Relation(name, tuple(arguments))

    def count(self) -> Count:
        container = self.name()
        self.expect(";")
        objects = [self.name()]
        while self.takes("|"):
            objects.append(self.name())
        self.expect(")")
        self.expect("=")
        self.takes("=")
        number = self.match(_NUMBER)
        if number is None:
            self.refuse("count ends with a number of at most four digits")
        self.match(_SPACE)
        return Count(container, tuple(objects), int(number[0]))

    def name(self) -> str:
        """A name in quotes, or everything up to the next comma, bar or unbalanced bracket."""
        self.match(_SPACE)
        start = self.position
        quoted = self.match(_QUOTED)
        if quoted:
            self.match(_SPACE)
            if self.text[self.position : self.position + 1] in (",", ";", "|", ")", ""):
                return _ESCAPE.sub(_character, quoted[1] if quoted[1] is not None else quoted[2])
            self.position = start
        depth = 0
        while self.position < len(self.text):
            character = self.text[self.position]
            if (character in ",;|" and depth == 0) or (character == ")" and depth == 0):
                break
            depth += (character == "(") - (character == ")")
            self.position += 1
        name = self.text[start : self.position].strip()
        if not name:
            self.refuse("a name is missing")
        return name


def _character(match: re.Match[str]) -> str:
    code = match[1]
    if len(code) > 1:
        return chr(int(code[1:], 16))
    return _NAMED_ESCAPES.get(code, code)
