"""What a sentence leaves out and the scene tells: where tools are put away, what a plate is wiped with."""

import re
from collections.abc import Sequence

from app.domain.action import ActionSignature
from app.domain.errors import TaskDeclined
from app.programs.knowledge.classes import normal
from app.programs.knowledge.names import words
from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.naming import Naming
from app.programs.sketches.qualities import is_container
from app.programs.sketches.questions import MOST_CHOICES
from app.programs.sketches.selection import PRONOUNS, Selection
from app.programs.sketches.things import Thing

POLITE = (
    r"(?:(?:please|now|then|ok|okay|can you|could you|would you|will you|let's|robot|hey)[, ]+)*"
)
END = r"(?:[, ]+(?:please|now|for me|thanks|thank you))*[\s.!?]*"
_WHAT = r"(?P<what>(?:(?!\b(?:in|into|inside|on|onto|to|with|using|except|but|and then|from)\b)[\w', -])+?)"
_ALL = re.compile(
    rf"{POLITE}(?:(?:tidy|clean|clear)(?: everything)? (?:up|away)(?: here| everything)?|"
    r"(?:clear|tidy|clean)(?: up| off)? (?:the|my|this) (?:table|tabletop|desk|counter|worktop|workbench|bench|place|mess))"
    rf"{END}",
    re.I,
)
_AWAY = re.compile(
    rf"{POLITE}(?:(?:put|pack|tidy|clear|stow|store)(?: away| up) {_WHAT}|"
    rf"(?:put|pack|tidy|clear|stow) {_WHAT.replace('what', 'what2')} away){END}",
    re.I,
)
_THROWN = re.compile(
    rf"{POLITE}(?:(?:throw|chuck|toss)(?: out| away) {_WHAT}|"
    rf"(?:throw|chuck|toss) {_WHAT.replace('what', 'what2')}(?: out| away)?|"
    rf"(?:bin|trash|discard|dispose of|get rid of) {_WHAT.replace('what', 'what3')}){END}",
    re.I,
)
_WIPED = re.compile(
    rf"(?P<said>{POLITE}(?:wipe|clean|scrub|polish|dust|mop|rub)(?: down| off)? {_WHAT}){END}", re.I
)
_WIPERS = frozenset(("sponge", "cloth", "rag", "towel", "wipe", "duster", "tissue", "dishcloth"))
_THE = r"^(?:all )?(?:(?:of )?(?:the|my|your|these|those|a|an) )?"
_BINS = frozenset(
    ("bin", "trash", "garbage", "rubbish", "waste", "dustbin", "wastebasket", "dumpster", "compost")
)
_NARROW = frozenset(("bottle", "mug", "cup", "glass", "can", "jar", "vase", "teapot", "kettle"))
"""Containers that nobody tidies things into where there is another one."""
_PUTTING = frozenset(("put", "putin", "place", "stow", "store", "move"))
_JOINING = frozenset(("and", "up", "of", "the", "it"))
"""Words in the names of verbs that tell no verb."""
_SEVERAL = frozenset(("everything", "all", "them", "these", "those", "things"))


def completed(sentence: str, selection: Selection, actions: Sequence[ActionSignature]) -> str:
    """The sentence with what it leaves out; as it is where it says all, or a verb on offer takes it so.

    Raises:
        TaskDeclined: several things would do, or nothing would; the question is which.
    """
    said, verbs = set(words(sentence)), {word for each in actions for word in words(each.name)}
    wipes = any(each.name == "wipe" and len(each.parameters) == 2 for each in actions)
    if wipes and (match := _WIPED.fullmatch(sentence)):
        return _wiped(match, selection)
    if said & (verbs - _PUTTING - _JOINING) or not verbs & _PUTTING:
        return sentence
    things = selection.things
    if _ALL.fullmatch(sentence):
        return _placed("everything", [each for each in things if is_container(each)])
    match, bins = _AWAY.fullmatch(sentence), False
    if match is None:
        match, bins = _THROWN.fullmatch(sentence), True
    if match is None:
        return sentence
    what = next(each for each in match.groups() if each)
    parts = [re.sub(_THE, "", each) for each in re.split(r",? and |, ", what)]
    named = [Naming(selection).all(each) for each in parts if each not in PRONOUNS | _SEVERAL]
    if not all(named):
        return sentence  # What is not there is told from the whole sentence.
    meant = {thing.name for found in named for thing in found}
    if bins and not _BINS & set(words(what)):  # "throw away the can" throws no trash can away.
        meant -= {thing.name for thing in things if _BINS & set(thing.words)}
    free = [thing for thing in things if is_container(thing) and thing.name not in meant]
    return _placed(what, [each for each in free if _BINS & set(each.words)] if bins else free, free)


def _placed(what: str, places: Sequence[Thing], others: Sequence[Thing] = ()) -> str:
    """What goes to the one place there is.

    Raises:
        TaskDeclined: there is none, or there are several.
    """
    places = [place for place in places if not _NARROW & set(place.words)] or places
    told = [f"put {what} in the {place.name}" for place in places or others]
    if len(places) == 1:
        return told[0]
    if not told:
        raise TaskDeclined(f"there is nothing here to put {what} into", kind="impossible")
    raise TaskDeclined(
        f"nothing tells where {what} should go",
        kind="ambiguous",
        question=f"Where should {'they' if _many(what) else 'it'} go?",
        choices=tuple(told[:MOST_CHOICES]),
    )


def _wiped(match: re.Match[str], selection: Selection) -> str:
    """Wiped with the one thing there is to wipe with.

    Raises:
        TaskDeclined: there is none, or there are several.
    """
    wipers = [t for t in selection.things if t.core and normal(t.core[-1]) in _WIPERS]
    told = [f"wipe {match['what']} with the {wiper.name}" for wiper in wipers]
    if len(told) == 1:
        return told[0]
    if not told:
        raise TaskDeclined(f"there is nothing here to wipe {match['what']} with", kind="impossible")
    question = f"What should {match['what']} be wiped with?"
    raise TaskDeclined(
        f"several things here could wipe {match['what']}",
        kind="ambiguous",
        question=question,
        choices=tuple(told[:MOST_CHOICES]),
    )


def _many(what: str) -> bool:
    found = words(what)
    many = set(found) & (_SEVERAL | {"and"}) or found[-1] in word_list("collective")
    return bool(many) or normal(found[-1]) != found[-1]
