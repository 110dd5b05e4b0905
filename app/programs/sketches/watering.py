"""Plants that get a drink, and what is poured for something: "give the fern a splash from the jug".

What is given is what comes out of the vessel, so that a model of this size takes the plant for what
is moved: the sentence that it reads says what is poured on what.
"""

import re
from collections.abc import Sequence

from app.programs.knowledge.bearing import VESSELS
from app.programs.knowledge.classes import normal
from app.programs.sketches.mentions import mentions
from app.programs.sketches.things import Thing

_DRINK = (
    r"(?:a (?:little )?bit of )?(?:an?|some|another|its|their)(?: \w+){0,2}? (?:of )?"
    r"(?:drink|splash|drop|sip|soak|soaking|watering|water|sprinkle|sprinkling|shower|drench|drenching|dousing|top[- ]?up|glug|dribble)"
    r"(?: of (?:the )?\w+)?"
)
_WHO = r"(?P<who>(?:(?:all|each|every|both)(?: one)?(?: of)? )?(?:the|my|our|your|those|these|that|this|every|each|it|them|all)\b(?: [\w' -]+?)??)"
_VESSEL = (
    r"(?:,? (?:from|with|using|out of)(?: the| my| our| your| that| this)? (?P<vessel>[\w' -]+?))?"
)
_END = r"(?= please|,? (?:and|but|then|so|would|will|could|if|because|before)\b|\s*[.,;:!?]|$)"
_GIVEN = re.compile(rf"\b(?:give|get) {_WHO} {_DRINK}{_VESSEL}{_END}", re.I)
_POURED = re.compile(
    r"\b(?:pour|tip|splash|sprinkle|dribble|drizzle) (?:some|a (?:little|bit|drop|splash|dash|drizzle))"
    rf"(?: of it| water| more)? (?:on|onto|over|into|in) (?:to )?{_WHO}{_VESSEL}{_END}",
    re.I,
)
_WATERED = re.compile(rf"\b(?:water|douse|drench) {_WHO}{_VESSEL}{_END}", re.I)
_CAN = "watering can"
_ROUND = re.compile(
    rf"\b(?:go|come|pop) (?:round|around|over|along) {_WHO},? with(?: the| my| our)? (?P<vessel>[\w' -]+?){_END}",
    re.I,
)
_TAKEN = re.compile(
    r"\b(?:(?:go|come|pop) (?:round|around|along|over) with|take|grab|get|fetch|pick up|use|with)"
    r"(?: the| my| our| your| that| this)? $",
    re.I,
)
"""Before the vessel, where it is named ahead of who gets what is in it."""
_TAKING = (
    r"(?:,? so)?(?: |^)(?:please )?(?:(?:go|come|pop) (?:round|around|along|over) with|take|grab|get|fetch|pick up|use)"
    r"(?: the| my| our| your| that| this)? {},?(?: and| then| to)* ?$"
)
_POINTING = re.compile(
    r"^(?:(?:all|each|every|both)(?: one)?(?: of)? )?(?:it|them|those|these|each|all)$", re.I
)
_TOPIC = re.compile(
    r"(?:^|[.!?;] )(?P<what>(?P<all>(?:every|each|all(?: of)?(?: the| my| our| these| those)?) )?"
    r"(?:(?:the|my|our|your|that|this|those|these) )?[\w-]+(?: [\w-]+)??)"
    r"(?: (?:in|on|by|at) [\w' ]+?)?(?: (?:looks?|is|are|seems?|needs?|could do|wants?)|'s|'re)\b[^.!?;]*",
    re.I,
)
"""What is spoken of before: every plant in this lobby looks parched."""


def watered(sentence: str, things: Sequence[Thing]) -> str:
    """The sentence with what is poured on what; as it is where no vessel is told."""
    for pattern in (_GIVEN, _POURED, _WATERED, _ROUND):
        match = pattern.search(sentence)
        if match and (pattern is not _ROUND or _is_vessel(match["vessel"])):
            return _told(match, things) or sentence
    return sentence


def _told(match: re.Match[str], things: Sequence[Thing]) -> str | None:
    before, after = match.string[: match.start()], match.string[match.end() :]
    vessel = match["vessel"] or _vessel_before(before, things)
    if vessel is None:
        return None
    who = match["who"]
    if _POINTING.match(who):
        topic = next(iter(list(_TOPIC.finditer(before))[::-1]), None)
        if topic is None:
            return None
        whole = bool(topic["all"]) or bool(re.match(r"(?:all|each|every)\b", who, re.I))
        who = re.sub(r"^(?:every|each|all(?: of)?)(?: the| my)? ", "", topic["what"], flags=re.I)
        who = f"all the {_several(_bare(who))}" if whole else f"the {_bare(who)}"
        before = before[: topic.start("what")]
    else:
        before = re.sub(_TAKING.format(re.escape(vessel)), " ", before, flags=re.I).lstrip()
    return f"{before}pour the {vessel} on {who}{after}"


def _bare(text: str) -> str:
    return re.sub(r"^(?:the|my|our|your|that|this|those|these) ", "", text, flags=re.I)


def _several(noun: str) -> str:
    return noun if normal(noun) != noun.lower() else f"{noun}s"


def _vessel_before(before: str, things: Sequence[Thing]) -> str | None:
    """The vessel that somebody is told to take, ahead of the clause; any other that is spoken of."""
    spoken = " ".join(before.split())
    named = [each for each in mentions(spoken, things) if _is_vessel(each.name)]
    taken = [each for each in named if _TAKEN.search(spoken.lower()[: each.start])]
    found = {each.name for each in taken or named}
    found = found or {each.name for each in things if each.unmarked == _CAN}
    return found.pop() if len(found) == 1 else None


def _is_vessel(name: str) -> bool:
    return normal(name).split()[-1] in VESSELS
