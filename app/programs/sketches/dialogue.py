"""What earlier turns of a dialogue mean for this one: "it", "undo that", "put it back"."""

import re
from collections.abc import Collection, Sequence

from app.domain.action import ActionSignature
from app.domain.condition import Relation
from app.domain.errors import ProgramRefused, TaskDeclined
from app.domain.planner import Task, Turn
from app.domain.program import ActionCall, Comment, Statement
from app.programs.knowledge.names import plain
from app.programs.parser import parse_program
from app.programs.sketches.verbs import place_of

_UNDO = re.compile(
    r"(?:(?:no|oh|oops|sorry|wait|hmm|ok|okay|please|now|then|can you|could you|actually|and)[,.! ]+)*"
    r"(?:undo(?: (?:that|this|it|the last (?:step|move|one|action)|(?P<all>everything|all(?: of (?:that|it))?)))?"
    r"|(?:take|revert|reverse) (?:that|this|it|them) ?(?:back|off|out|down)?(?: of (?:there|it))?(?: again)?"
    r"|(?:put|bring|move|return) (?:it|them|that|those|everything|all|(?:the )?(?P<what>[\w' ]+?)) "
    r"back(?: (?:again|where (?:it|they) (?:was|were|came from)|to where (?:it|they) (?:was|were)|"
    r"in its place|please))*"
    r"|mach das rückgängig|rückgängig|stell? (?:es|ihn|sie|das) zurück|leg (?:es|ihn|sie|das) zurück"
    r"|annule(?: ça)?|remets-(?:le|la|les)(?: à sa place)?|deshaz(?:lo)?|devuélvelo|annulla|rimettilo a posto"
    r"|desfaz(?: isso)?|põe de volta|maak dat ongedaan|zet het terug)"
    r"(?:[,.! ]+(?:please|again|thanks|now|bitte))*[.! ]*",
    re.I,
)

BACK, THEN = "back to where it was", "and what was meant"
"""The comments over calls that take back, and over those that come instead."""


def moved_before(history: Sequence[Turn]) -> tuple[str, ...]:
    """Names of what the latest turn with a plan moved, in order, each once."""
    for turn in reversed(history):
        if calls := _own(turn.program):
            return tuple(dict.fromkeys(str(call.arguments[0]) for call in calls if call.arguments))
    return ()


def _own(program: str) -> list[ActionCall]:
    """The calls of a stored program without those that only took back what was wrong before it."""
    own: list[ActionCall] = []
    taking_back = False
    for each in _body(program):
        if isinstance(each, Comment):
            taking_back = each.text == BACK
        elif isinstance(each, ActionCall) and not taking_back:
            own.append(each)
    return own or calls_of(program)


def asks_to_undo(sentence: str) -> re.Match[str] | None:
    """Whether the whole sentence asks for the turn before to be taken back."""
    return _UNDO.fullmatch(sentence.strip())


def undo(task: Task, what: str | None = None, *, everything: bool = False) -> tuple[Statement, ...]:
    """The calls that bring back what the latest turn moved, the last one first.

    ``everything``: what any turn moved, to where it was at first.

    Raises:
        TaskDeclined: nothing was moved, or no verb on offer can bring it to where it was.
    """
    turns = [turn.program for turn in task.history if calls_of(turn.program)]
    if not turns:
        raise TaskDeclined("nothing was done yet that could be taken back", kind="impossible")
    wanted = plain(what) if what else None
    done = _own(turns[-1])
    if everything:
        done = [call for program in reversed(turns) for call in reversed(calls_of(program))]
        done = list({_thing(call): call for call in done}.values())[::-1]
    body: list[Statement] = [
        _inverse(call, turns, task)
        for call in reversed(done)
        if not wanted or wanted in plain(_thing(call))
    ]
    if not body:
        raise TaskDeclined(f"the turn before did not move the {what}", kind="impossible")
    return (Comment(text=BACK), *body)


def taken_back(task: Task, kept: Collection[str]) -> tuple[Statement, ...]:
    """The calls that bring back what the latest turn moved and this one does not, where it was moved.

    Raises:
        TaskDeclined: no verb on offer can bring it to where it was.
    """
    turns = [turn.program for turn in task.history if calls_of(turn.program)]
    wrong = [call for call in _own(turns[-1]) if _thing(call) not in kept and _was_done(call, task)]
    body = [_inverse(call, turns, task) for call in reversed(wrong)]
    return (Comment(text=BACK), *body) if body else ()


def _thing(call: ActionCall) -> str:
    return str(call.arguments[0]) if call.arguments else ""


def _was_done(call: ActionCall, task: Task) -> bool:
    """Whether things stand as the call leaves them, where that can be told."""
    if len(call.arguments) != 2 or not task.facts:
        return True
    names = tuple(map(str, call.arguments))
    return any(Relation(key, names) in task.facts for key in ("in", "on"))


def calls_of(program: str) -> list[ActionCall]:
    """The calls of a stored program; none where it cannot be read."""
    return [each for each in _body(program) if isinstance(each, ActionCall)]


def _body(program: str) -> tuple[Statement, ...]:
    try:
        return parse_program(program).body if program else ()
    except ProgramRefused:
        return ()


def _inverse(call: ActionCall, turns: Sequence[str], task: Task) -> ActionCall:
    thing = _thing(call)
    signatures = {action.name: action for action in task.actions}
    opposite = {"open": "close", "close": "open"}.get(call.action)
    if opposite is not None and opposite in signatures:
        return ActionCall(action=opposite, arguments=call.arguments)
    if before := _put_before(call, turns, signatures):
        return before
    item = next((each for each in task.scene.objects if each.name == thing), None)
    if "place_at" in signatures and item is not None and item.position is not None:
        x, y = round(item.position[0], 3), round(item.position[1], 3)
        return ActionCall(action="place_at", arguments=(thing, x, y))
    raise TaskDeclined(
        f"{thing or 'it'} stood on the bare table, and no action on offer "
        f"({', '.join(signatures)}) puts a thing there",
        kind="impossible",
        question=f"Where should {thing or 'it'} go?",
    )


def _put_before(
    call: ActionCall, turns: Sequence[str], signatures: dict[str, ActionSignature]
) -> ActionCall | None:
    """The earlier call that had put the thing to where this one took it from."""
    earlier = [each for program in turns for each in calls_of(program)]
    cut = next(i for i in range(len(earlier) - 1, -1, -1) if earlier[i] == call)
    for each in reversed(earlier[:cut]):
        signature = signatures.get(each.action)
        if signature and _thing(each) == _thing(call) and place_of(signature, ()) is not None:
            return each
    return None
