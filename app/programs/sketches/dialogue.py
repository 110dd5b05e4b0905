"""What earlier turns of a dialogue mean for this one: "it", "undo that", "put it back"."""

import re
from collections.abc import Sequence

from app.domain.action import ActionSignature
from app.domain.errors import ProgramRefused, TaskDeclined
from app.domain.planner import Task, Turn
from app.domain.program import ActionCall, Comment, Statement
from app.programs.knowledge.names import plain
from app.programs.parser import parse_program
from app.programs.sketches.verbs import place_of

_UNDO = re.compile(
    r"(?:(?:no|oh|oops|sorry|wait|hmm|ok|okay|please|now|then|can you|could you|actually|and)[,.! ]+)*"
    r"(?:undo(?: (?:that|this|it|the last (?:step|move|one|action)|everything|all of (?:that|it)))?"
    r"|(?:take|revert|reverse) (?:that|this|it|them) ?(?:back)?"
    r"|(?:put|bring|move|return) (?:it|them|that|those|everything|all|(?:the )?(?P<what>[\w' ]+?)) "
    r"back(?: (?:again|where (?:it|they) (?:was|were|came from)|to where (?:it|they) (?:was|were)|"
    r"in its place|please))*"
    r"|mach das rückgängig|rückgängig|stell? (?:es|ihn|sie|das) zurück|leg (?:es|ihn|sie|das) zurück"
    r"|annule(?: ça)?|remets-(?:le|la|les)(?: à sa place)?|deshaz(?:lo)?|devuélvelo|annulla|rimettilo a posto"
    r"|desfaz(?: isso)?|põe de volta|maak dat ongedaan|zet het terug)"
    r"(?:[,.! ]+(?:please|again|thanks|now|bitte))*[.! ]*",
    re.I,
)


def moved_before(history: Sequence[Turn]) -> tuple[str, ...]:
    """Names of what the latest turn with a plan moved, in order, each once."""
    for turn in reversed(history):
        if calls := calls_of(turn.program):
            return tuple(dict.fromkeys(str(call.arguments[0]) for call in calls if call.arguments))
    return ()


def asks_to_undo(sentence: str) -> re.Match[str] | None:
    """Whether the whole sentence asks for the turn before to be taken back."""
    return _UNDO.fullmatch(sentence.strip())


def undo(task: Task, what: str | None = None) -> tuple[Statement, ...]:
    """The calls that bring back what the latest turn moved, the last one first.

    Raises:
        TaskDeclined: nothing was moved, or no verb on offer can bring it to where it was.
    """
    turns = [calls for turn in task.history if (calls := calls_of(turn.program))]
    if not turns:
        raise TaskDeclined("nothing was done yet that could be taken back", kind="impossible")
    wanted = plain(what) if what else None
    body: list[Statement] = []
    for call in reversed(turns[-1]):
        thing = str(call.arguments[0]) if call.arguments else ""
        if wanted and wanted not in plain(thing):
            continue
        body.append(_inverse(call, thing, turns, task))
    if not body:
        raise TaskDeclined(f"the turn before did not move the {what}", kind="impossible")
    return (Comment(text="back to where it was"), *body)


def calls_of(program: str) -> list[ActionCall]:
    """The calls of a stored program; none where it cannot be read."""
    if not program:
        return []
    try:
        parsed = parse_program(program)
    except ProgramRefused:
        return []
    return [each for each in parsed.body if isinstance(each, ActionCall)]


def _inverse(
    call: ActionCall, thing: str, turns: Sequence[Sequence[ActionCall]], task: Task
) -> ActionCall:
    signatures = {action.name: action for action in task.actions}
    opposite = {"open": "close", "close": "open"}.get(call.action)
    if opposite is not None and opposite in signatures:
        return ActionCall(action=opposite, arguments=call.arguments)
    before = _place_before(call, thing, turns, signatures)
    if before is not None and call.action in signatures:
        place = place_of(signatures[call.action], ())
        arguments = list(call.arguments)
        if place is not None and len(arguments) > place:
            arguments[place] = before
            return ActionCall(action=call.action, arguments=tuple(arguments))
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


def _place_before(
    call: ActionCall,
    thing: str,
    turns: Sequence[Sequence[ActionCall]],
    signatures: dict[str, ActionSignature],
) -> str | None:
    """Where an earlier call had put the thing."""
    earlier = [each for calls in turns for each in calls]
    cut = next(i for i in range(len(earlier) - 1, -1, -1) if earlier[i] is call)
    for each in reversed(earlier[:cut]):
        if each.arguments and str(each.arguments[0]) == thing and each.action in signatures:
            place = place_of(signatures[each.action], ())
            if place is not None and len(each.arguments) > place:
                return str(each.arguments[place])
    return None
