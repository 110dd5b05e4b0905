"""Scene + actions → a GBNF grammar of a function's body: every call of it parses and grounds.

What it binds: the actions on offer with the number and kinds of their arguments, the scene's own
object names as Python literals, a container where a container is wanted (as far as the scene has
any), never an object into itself, and at most ``MAX_STEPS`` steps, so that no text is endless.
"""

from collections.abc import Iterable, Sequence

from app.domain.action import ActionSignature
from app.domain.program import literal
from app.domain.scene import Scene

INDENT = "    "
MAX_STEPS = 40
MAX_COMMENT = 100
"""Characters."""
NUMBER = r'number ::= "-"? [0-9]{1,4} ("." [0-9]{1,4})?'


def program_grammar(
    scene: Scene, actions: Iterable[ActionSignature], *, comments: bool, feedback: bool
) -> str:
    """The grammar of everything after the cue: indented lines, then an empty one.

    With ``comments`` a comment may stand before each call and at the end; with ``feedback``
    assertions with recoveries, as the paper writes them, may stand between the calls.
    """
    words = _Words(scene)
    calls = [rule for action in actions if (rule := words.call(action))]
    remark = "comment? " if comments else ""
    declined = f'declined ::= {remark}{_quote(INDENT)} "pass\\n"'
    rules: list[str] = []
    if calls:
        kinds = ['call "\\n"', *(words.assertions() if feedback else ())]
        rules += [
            f"step ::= {remark}{_quote(INDENT)} ({' | '.join(kinds)})",
            f"call ::= {' | '.join(calls)}",
            f'recovery ::= {_quote(f"{INDENT * 2}else: ")} call "\\n"',
        ]
    steps = f"step{{1,{MAX_STEPS}}} {remark}| " if calls else ""
    if comments:
        rules.append(
            f'comment ::= {_quote(f"{INDENT}# ")} [^\\x00-\\x1f\\x7f]{{1,{MAX_COMMENT}}} "\\n"'
        )
    return "\n".join([f'root ::= ({steps}declined) "\\n"', declined, *rules, *words.rules]) + "\n"


class _Words:
    """The rules for what may stand between a call's brackets."""

    def __init__(self, scene: Scene) -> None:
        self.names = scene.names
        holders = tuple(item.name for item in scene.objects if item.container)
        self.holders = holders or scene.names
        self.rules: list[str] = []

    def call(self, action: ActionSignature) -> str | None:
        """The name of a rule for calls of this action, or None where none can be made."""
        rule = f"call-{len(self.rules)}"
        roles = [parameter.role for parameter in action.parameters]
        body = self._pairs(roles, _quote(", ")) if _is_pair(roles) else self._separate(roles)
        if body is None:
            return None
        self.rules.append(f"{rule} ::= {_quote(f'{action.name}(')} {body} {_quote(')')}")
        return rule

    def assertions(self) -> tuple[str, ...]:
        """The name of a rule for assertions of where a thing is, in the paper's form, if any can be.

        One to three recoveries stand below each.
        """
        pair = self._pairs(("object", "container"), f"({_quote(' in ')} | {_quote(' on ')})")
        if pair is None:
            return ()
        self.rules.append(f'assertion ::= "assert(" {pair} ")\\n" recovery{{1,3}}')
        return ("assertion",)

    def _separate(self, roles: Sequence[str]) -> str | None:
        parts: list[str] = []
        for role in roles:
            choices = self.holders if role == "container" else self.names
            if role != "number" and not choices:
                return None
            parts.append(self._number() if role == "number" else self._name(choices))
        return f" {_quote(', ')} ".join(parts) if parts else '""'

    def _pairs(self, roles: Sequence[str], between: str) -> str | None:
        """Two different objects: the first decides which are left for the second."""
        second = self.holders if roles[1] == "container" else self.names
        first = self.holders if roles[0] == "container" else self.names
        choices: list[str] = []
        free = [name for name in first if name not in second]
        if free and second:
            choices.append(f"{self._name(free)} {between} {self._name(second)}")
        for name in first:
            rest = [other for other in second if other != name]
            if name in second and rest:
                choices.append(f"{_quote(literal(name))} {between} {self._name(rest)}")
        return f"({' | '.join(choices)})" if choices else None

    def _name(self, names: Sequence[str]) -> str:
        """A rule for one of these names; the same names, the same rule."""
        choices = " | ".join(_quote(literal(name)) for name in names)
        for rule in self.rules:
            known, _, body = rule.partition(" ::= ")
            if body == choices:
                return known
        self.rules.append(f"name-{len(self.rules)} ::= {choices}")
        return f"name-{len(self.rules) - 1}"

    def _number(self) -> str:
        if NUMBER not in self.rules:
            self.rules.append(NUMBER)
        return "number"


def _is_pair(roles: Sequence[str]) -> bool:
    return len(roles) == 2 and "number" not in roles


def _quote(text: str) -> str:
    """The text as a GBNF literal."""
    shown = (_ESCAPES.get(character, character) for character in text)
    return f'"{"".join(shown)}"'


_ESCAPES = {'"': '\\"', "\\": "\\\\", "\n": "\\n", "\r": "\\r", "\t": "\\t"}
