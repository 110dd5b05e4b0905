"""Scene + actions → a GBNF grammar of a function's body: every call of it parses and grounds.

What it binds: the actions on offer with the number and kinds of their arguments, the scene's own
object names as Python literals, a container where a container is wanted (as far as the scene has
any), what affords it where objects tell of their affordances (no door to a table, nothing put
onto a room), one of the words where a word is wanted, never an object onto itself, and at most
``MAX_STEPS`` steps, so that no text is endless.
"""

from collections.abc import Iterable, Sequence

from app.domain.action import ActionSignature, Parameter
from app.domain.program import literal
from app.domain.scene import Scene, SceneObject

INDENT = "    "
MAX_STEPS = 40
ROOM = "room"
"""A category: one goes there, and puts nothing in or on it."""
MAX_COMMENT = 100
"""Characters."""
GROUP = 12
"""Objects that share the rule for all others; so the grammar does not grow as their square."""
NUMBER = r'number ::= "-"? [0-9]{1,4} ("." [0-9]{1,4})?'
PLACES = ("in", "on")
"""Relations that are asserted of two objects unless told otherwise."""
STATES = {
    "held": "in 'hands'",
    "open": "is 'opened'",
    "closed": "is 'closed'",
    "switched_on": "is 'switchon'",
    "switched_off": "is 'switchoff'",
}
"""Relations of one object, as the paper asserts them; ``near`` is told before the name."""
NEEDED = {
    "held": "grabbable",
    "open": "can_open",
    "closed": "can_open",
    "switched_on": "has_switch",
    "switched_off": "has_switch",
}
"""What an object affords that such a relation can be true of."""
NEAR = "'close' to "


def program_grammar(  # noqa: PLR0913 - one parameter per switch
    scene: Scene,
    actions: Iterable[ActionSignature],
    *,
    comments: bool,
    feedback: bool,
    relations: Iterable[str] = PLACES,
    begun: bool = False,
    affordances: bool = True,
) -> str:
    """The grammar of everything after the cue: indented lines, then an empty one.

    With ``comments`` a comment may stand before each call and at the end; with ``feedback``
    assertions of these ``relations`` with recoveries, as the paper writes them, may stand between
    the calls. A body that was ``begun`` may have nothing left to say. Without ``affordances`` any
    object may stand where one is wanted, whatever can be done with it.
    """
    words = _Words(scene, affordances=affordances)
    calls = [rule for action in actions if (rule := words.call(action))]
    remark = "comment? " if comments else ""
    declined = f'declined ::= {remark}{_quote(INDENT)} "pass\\n"'
    rules: list[str] = []
    if calls:
        asserted = words.assertions(relations) if feedback else ()
        kinds = ['call "\\n"', *asserted]
        rules += [
            f"step ::= {remark}{_quote(INDENT)} ({' | '.join(kinds)})",
            f"call ::= {' | '.join(calls)}",
            f'recovery ::= {_quote(f"{INDENT * 2}else: ")} call "\\n"',
        ]
    fewest = 0 if begun else 1
    steps = f"step{{{fewest},{MAX_STEPS}}} {remark}| " if calls else ""
    if comments:
        rules.append(
            f'comment ::= {_quote(f"{INDENT}# ")} [^\\x00-\\x1f\\x7f]{{1,{MAX_COMMENT}}} "\\n"'
        )
    return "\n".join([f'root ::= ({steps}declined) "\\n"', declined, *rules, *words.rules]) + "\n"


class _Words:
    """The rules for what may stand between a call's brackets."""

    def __init__(self, scene: Scene, *, affordances: bool) -> None:
        self.names = scene.names
        told = scene.objects if affordances else ()
        holders = tuple(item.name for item in told if item.container)
        self.holders = holders or scene.names
        things = tuple(item.name for item in told if item.category != ROOM)
        self.supports = things or scene.names
        self._affordances = {item.name: _affordances(item) for item in told}
        self.rules: list[str] = []
        self._known: dict[str, str] = {}

    def call(self, action: ActionSignature) -> str | None:
        """The name of a rule for calls of this action, or None where none can be made."""
        named = [each for each in action.parameters if each.role not in ("number", "word")]
        first = len(named)
        in_front = list(action.parameters[:first]) == named
        rest = action.parameters[first:] if in_front else ()
        objects = self._objects(named if in_front else action.parameters)
        if objects is None or not all(map(_can_be, action.parameters)):
            return None
        body = f" {_quote(', ')} ".join(filter(None, (objects, self._values(rest)))) or '""'
        rule = f"call-{len(self.rules)}"
        self.rules.append(f"{rule} ::= {_quote(f'{action.name}(')} {body} {_quote(')')}")
        return rule

    def assertions(self, relations: Iterable[str]) -> tuple[str, ...]:
        """The name of a rule for assertions in the paper's form, if any can be made.

        One to three recoveries stand below each.
        """
        asserted = sorted(set(relations))
        places = [name for name in asserted if name in PLACES]
        forms: list[str] = []
        for name in places:
            second = Parameter(name="", role="container" if name == "in" else "support")
            pair = self._pairs(Parameter(name=""), second, _quote(f" {name} "))
            forms += [pair] if pair else []
        forms += self._states([name for name in asserted if name in STATES])
        if self.names and "near" in asserted:
            forms.append(f"{_quote(NEAR)} {self._name(self.names)}")
        if not forms:
            return ()
        self.rules.append(f'assertion ::= "assert(" ({" | ".join(forms)}) ")\\n" recovery{{1,3}}')
        return ("assertion",)

    def _states(self, asserted: Sequence[str]) -> list[str]:
        """Assertions of one object: each of those that can be so."""
        spoken: dict[tuple[str, ...], list[str]] = {}
        for name in asserted:
            if able := self._affording(self.names, NEEDED[name]):
                spoken.setdefault(able, []).append(_quote(f" {STATES[name]}"))
        return [f"{self._name(able)} ({' | '.join(said)})" for able, said in spoken.items()]

    def _objects(self, parameters: Sequence[Parameter]) -> str | None:
        """What stands for these parameters; empty for none of them."""
        roles = [parameter.role for parameter in parameters]
        if len(roles) == 2 and not {"number", "word"} & set(roles):
            return self._pairs(parameters[0], parameters[1], _quote(", "))
        parts: list[str] = []
        for parameter in parameters:
            part = self._value(parameter)
            if part is None:
                return None
            parts.append(part)
        return f" {_quote(', ')} ".join(parts)

    def _values(self, parameters: Sequence[Parameter]) -> str:
        """Numbers and words at the end of a call: all in order, or all by name."""
        if not parameters:
            return ""
        comma = f" {_quote(', ')} "
        values = [self._value(parameter) or "" for parameter in parameters]
        pairs = zip(parameters, values, strict=True)
        named = [f"{_quote(f'{parameter.name}=')} {value}" for parameter, value in pairs]
        return f"({comma.join(values)} | {comma.join(named)})"

    def _value(self, parameter: Parameter) -> str | None:
        match parameter.role:
            case "number":
                if NUMBER not in self.rules:
                    self.rules.append(NUMBER)
                return "number"
            case "word":
                return self._name(parameter.words)
            case "object" | "support" | "container":
                choices = self._choices(parameter)
                return self._name(choices) if choices else None

    def _choices(self, parameter: Parameter) -> tuple[str, ...]:
        roles = {"container": self.holders, "support": self.supports}
        return self._affording(roles.get(parameter.role, self.names), parameter.affordance)

    def _affording(self, names: tuple[str, ...], affordance: str | None) -> tuple[str, ...]:
        """Those that afford it; all of them where no object of the scene tells what it affords."""
        if affordance is None or not any(self._affordances.values()):
            return names
        return tuple(name for name in names if affordance in self._affordances[name])

    def _pairs(self, one: Parameter, other: Parameter, between: str) -> str | None:
        """Two different objects: the first decides which are left for the second."""
        first, second = self._choices(one), self._choices(other)
        choices: list[str] = []
        free = [name for name in first if name not in second]
        if free and second:
            choices.append(f"{self._name(free)} {between} {self._name(second)}")
        groups = [second[start : start + GROUP] for start in range(0, len(second), GROUP)]
        for group in groups:
            others = [self._name(each) for each in groups if each is not group]
            elsewhere = [self._rule("others", " | ".join(others))] if others else []
            for name in group:
                near = [each for each in group if each != name]
                rest = [*elsewhere, *([self._name(near)] if near else [])]
                if name in first and rest:
                    target = rest[0] if len(rest) == 1 else f"({' | '.join(rest)})"
                    choices.append(f"{_quote(literal(name))} {between} {target}")
        return self._rule("pair", " | ".join(choices)) if choices else None

    def _name(self, names: Sequence[str]) -> str:
        """A rule for one of these names."""
        return self._rule("name", " | ".join(_quote(literal(name)) for name in names))

    def _rule(self, kind: str, body: str) -> str:
        """A rule of this kind; the same body, the same rule."""
        if body not in self._known:
            self._known[body] = f"{kind}-{len(self.rules)}"
            self.rules.append(f"{self._known[body]} ::= {body}")
        return self._known[body]


def _affordances(item: SceneObject) -> frozenset[str]:
    return frozenset(dict(item.properties).get("affordances", "").split())


def _can_be(parameter: Parameter) -> bool:
    """Whether there is anything it may be, apart from the scene."""
    return parameter.role != "word" or bool(parameter.words)


def _quote(text: str) -> str:
    """The text as a GBNF literal."""
    shown = (_ESCAPES.get(character, character) for character in text)
    return f'"{"".join(shown)}"'


_ESCAPES = {'"': '\\"', "\\": "\\\\", "\n": "\\n", "\r": "\\r", "\t": "\\t"}
