"""What a sketch asks for and is not done: what can hurt somebody, what does not fit, what no verb does."""

import re
from collections.abc import Sequence

from app.domain.action import ActionSignature
from app.domain.errors import TaskDeclined
from app.domain.program import ActionCall
from app.programs.knowledge.hazards import hazard
from app.programs.knowledge.names import words
from app.programs.knowledge.solids import is_solid
from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.order import TOOLS
from app.programs.sketches.pouring import POUR, refuse_solid
from app.programs.sketches.qualities import far_larger, is_container, is_tiny
from app.programs.sketches.questions import MOST_CHOICES
from app.programs.sketches.selection import Selection
from app.programs.sketches.sketch import Phrase, SketchCall
from app.programs.sketches.verbs import HANDOVER, LITERAL, SPOKEN, place_of
from app.programs.sketches.whereabouts import spoken_of

_BESIDE_IT = re.compile(
    r"\b(?:beside|alongside|next to|near|close to|by) (?:(?:you|me|us)\b|"
    r"(?:it|them|that|this|those|these)\b[^,.;]* (?:in|on|into|onto|inside)\b)",
    re.I,
)
_IMMATERIAL = word_list("immaterial")
_WITHIN = r"\b(?:in(?! front)|on(?! the (?:left|right))|into|onto|inside|between)\b"
_WITHIN_VERB = frozenset(("putin", "in", "on", "stack", "pour"))
_STATES = frozenset(("open", "opened", "closed"))
_UNPLACED = frozenset((*LITERAL, HANDOVER, "pick", "upright", "place_at"))
"""Verbs that say nothing of a place by another thing."""
OPENING = ("open", "close")
"""Verbs of things that have an inside, and states that they leave."""
BESIDE = ("left_of", "right_of", "near", "behind", "in_front_of")


def refuse_harm(call: ActionCall, signature: ActionSignature, selection: Selection) -> None:
    """Let a call pass that hurts nobody and fits.

    Raises:
        TaskDeclined: it can hurt somebody, or one container goes into a far smaller one.
    """
    names = [each for each in call.arguments if isinstance(each, str)]
    if call.action == HANDOVER and (rule := hazard(names[0], "person")):
        raise TaskDeclined(
            f"{names[0]} handed to a person: {rule.reason}",
            kind="hazardous",
            question=f"Where on the table should the {names[0]} go instead?",
        )
    if call.action in OPENING and names:
        _refuse_solid(names[0], call.action, selection)
    place = place_of(signature, ())
    if place is None or len(names) != 2 or place > 1:
        return
    thing, target = names[1 - place], names[place]
    if call.action == POUR:
        refuse_solid(thing)
    if call.action not in LITERAL:
        _refuse_misfit(thing, target, selection)
    if rule := hazard(thing, target):
        raise TaskDeclined(
            f"{thing} in, on or at {target}: {rule.reason}",
            kind="hazardous",
            question=f"Where else should the {thing} go?",
        )


def refuse_ungrounded(call: ActionCall, signature: ActionSignature, selection: Selection) -> None:
    """Let a call pass whose things are all there.

    Raises:
        TaskDeclined: it puts something "away", or where nothing of the scene is.
    """
    for i, parameter in enumerate(signature.parameters):
        value = call.arguments[i]
        needs = i == 0 or parameter.role in ("container", "support") or parameter.name in TOOLS
        if parameter.role == "number" and not isinstance(value, float | int):
            raise TaskDeclined(
                f"no number tells the {parameter.name} of {call.action}", kind="impossible"
            )
        literal = parameter.name in SPOKEN or parameter.role in ("number", "word")
        if literal or not needs or selection.is_there(str(value)):
            continue
        thing = str(call.arguments[0])
        places = [t.name for t in selection.things if is_container(t) and t.name != thing]
        raise TaskDeclined(
            f"nothing here is called {str(value)!r}",
            kind="ambiguous" if i and places else "absent",
            question=f"Where should the {thing} go?"
            if i
            else f"What do you mean by {str(value)!r}?",
            choices=tuple(
                f"put the {thing} in the {place}" for place in places[:MOST_CHOICES] if i
            ),
        )


def _refuse_misfit(name: str, place: str, selection: Selection) -> None:
    by_name = {thing.name: thing for thing in selection.things}
    thing, target = by_name.get(name), by_name.get(place)
    said = set(words(selection.sentence))
    if thing is None or target is None or not said & {"in", "into", "inside"}:
        return
    holds = is_tiny(target) or (is_container(thing) and is_container(target))
    if holds and far_larger(thing, target):
        raise TaskDeclined(f"the {name} does not fit into the {place}", kind="impossible")


def _refuse_solid(name: str, action: str, selection: Selection) -> None:
    """Let what has an inside be opened, or what the scene tells to be open or closed."""
    stated = {rel.arguments[0] for rel in selection.facts if rel.name in _STATES}
    if name in stated or not is_solid(name):
        return
    raise TaskDeclined(f"the {name} is nothing that one can {action}", kind="impossible")


def refuse_beside(call: SketchCall, sentence: str) -> None:
    """Let a call pass that puts things where the sentence says.

    Raises:
        TaskDeclined: "next to the cup" became "into the cup" for want of a verb.
    """
    if _BESIDE_IT.search(sentence):  # Where something was put before, or where somebody stands.
        return
    phrases = [each for each in call.arguments if isinstance(each, Phrase)]
    texts = {each.text for each in phrases}
    for phrase in phrases:
        for key, other in spoken_of(phrase, sentence).relations:
            if len(re.findall(rf"\b{re.escape(other)}\b", sentence, re.I)) > 1:
                continue  # "the block left of the bowl in the bowl" tells the place besides.
            if other in texts - {phrase.text} and key in BESIDE and key not in call.action:
                raise TaskDeclined(
                    f"{call.action} puts things in or on {other}, not {key.replace('_', ' ')} it",
                    kind="impossible",
                )


def refuse_immaterial(call: SketchCall, selection: Selection) -> None:
    """Let a call pass that is about things one can take hold of.

    Raises:
        TaskDeclined: it is about an echo, a shadow or the like of a thing.
    """
    first = call.arguments[0] if call.arguments else None
    found = words(first.text) if isinstance(first, Phrase) else ()
    if len(found) < 2 or call.action in LITERAL:
        return
    head = found[0] if "of" in found[1:-1] else found[-1] if found[0].endswith("'s") else ""
    head = found[-1] if any(each.endswith("'s") for each in found[:-1]) else head
    if head in _IMMATERIAL and not any(head in thing.words for thing in selection.things):
        raise TaskDeclined(f"nobody can take hold of {_text(first)}", kind="impossible")


def _text(argument: object) -> str:
    return argument.text if isinstance(argument, Phrase) else str(argument)


_TWO_PLACES = re.compile(
    r"\b(?:both )?(?:in|on|into|onto|inside) (?P<one>(?:the|my|that) [\w' -]+?),? and (?:also )?(?:in|on|into|onto|inside) "
    r"(?P<other>(?:the|my|that) [\w' -]+?),? (?:both )?(?:at the same time|at once|simultaneously|together|at one and the same time)\b",
    re.I,
)


def refuse_two_places(sentence: str) -> None:
    """Let a sentence pass that wants things in one place each.

    Raises:
        TaskDeclined: one thing is to be in two places at the same time.
    """
    if (match := _TWO_PLACES.search(sentence)) and match["one"] != match["other"]:
        raise TaskDeclined(
            f"nothing is in {match['one']} and in {match['other']} at the same time",
            kind="impossible",
            question=f"In {match['one']} or in {match['other']}?",
        )


_PUT_BESIDE = re.compile(
    r"^\s*(?:(?:please|now|then|can you|could you)[, ]+)*(?:put|move|place|set|bring|lay|stand) "
    rf"(?:(?!{_WITHIN}).)+? (?P<beside>(?:(?:to|on|at) )?(?:the )?(?P<side>left|right)(?:[- ]hand)?(?: side)? of|"
    rf"next to|beside|alongside|close to|near|(?P<behind>behind)|(?P<front>in front of)) (?:(?!{_WITHIN}).)+$",
    re.I,
)


def refuse_place_beside(sentence: str, actions: Sequence[ActionSignature]) -> None:
    """Let a sentence pass that verbs on offer can do, where all it asks for is a place beside a thing.

    Raises:
        TaskDeclined: all that is on offer puts things in or on others.
    """
    match = _PUT_BESIDE.match(sentence)
    if match is None or _BESIDE_IT.search(sentence):
        return
    told = [f"{side}_of" for side in ("left", "right") if side == (match["side"] or "").lower()]
    told += [key for key, said in (("behind", "behind"), ("front", "front")) if match[said]]
    wanted = told or [*BESIDE, "next", "beside"]
    names = [action.name for action in actions]
    if any(key in name for key in wanted for name in names):
        return
    if all(_WITHIN_VERB & set(words(name)) or name in _UNPLACED for name in names):
        raise TaskDeclined(
            f"the actions on offer ({', '.join(names)}) put nothing {match['beside']} another thing",
            kind="impossible",
        )


def into_itself(text: str) -> TaskDeclined:
    """Nothing goes into itself."""
    return TaskDeclined(f"the {text} cannot be put into itself", kind="impossible")
