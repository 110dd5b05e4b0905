"""Plants that get a drink, and what is poured for something: "give the fern a splash from the jug".

What is given is what comes out of the vessel, so that a model of this size takes the plant for what
is moved: the sentence that it reads says what is poured on what.
"""

import re
from collections.abc import Sequence

from app.programs.knowledge.bearing import VESSELS, stands_for
from app.programs.knowledge.classes import normal
from app.programs.sketches.mentions import mentions
from app.programs.sketches.things import Thing

_DRINK = (
    r"(?:a (?:little )?bit of )?(?:an?|some|another|its|their)(?: \w+){0,2}? (?:of )?"
    r"(?:drink|splash|drop|sip|soak|soaking|watering|water|sprinkle|sprinkling|shower|drench|drenching|dousing|top[- ]?up|glug|dribble)"
    r"(?: of (?:the )?(?P<liquid>\w+))?"
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
_ASKED = re.compile(
    r"(?:^|[.,;:!?]|\b(?:and|then|please|just|now|kindly|(?:can|could|would|will) you))\s*$", re.I
)
"""Before an order: "I'll water the ferns" is none."""
_NEEDING = re.compile(
    rf"\b{_WHO} (?:needs?|wants?|could do with) (?:an? )?(?:good |little |quick )?(?:watering|water|drink|splash|soak)"
    r"(?: (?:from|with) (?:the )?(?P<vessel>[\w -]+?))?(?=[.!?,;]|$)",
    re.I,
)
_WITH = re.compile(rf"\bpour {_WHO} with (?:the )?(?P<vessel>[\w -]+?){_END}", re.I)
_EACH = re.compile(
    rf"\bpour (?:some |a (?:little|bit|drop)(?: of)? )?(?:the )?(?P<what>[\w' -]+?) (?P<link>in|into|on|onto|over) "
    rf"(?:each|every one)(?: one)? of (?P<each>(?:the|my|our|these|those) [\w' -]+?){_END}",
    re.I,
)
"""Nothing is shared out where something is poured: every glass gets of the one bottle."""
_USING = r"^[.!?,;]*\s*(?:please )?(?:use|take|with)(?: the| my)? {}(?: please)?(?=[.!?,;]|$)"
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
    r"^(?:(?:all|each|every|both)(?: one)?(?: of)? )?(?:it|them|those|these|each|all)(?: both| all)?$",
    re.I,
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
    if match := _EACH.search(sentence):
        told = f"pour the {match['what']} {match['link']} all {match['each']}"
        return f"{sentence[: match.start()]}{told}{sentence[match.end() :]}"
    for pattern in (_GIVEN, _POURED, _WATERED, _ROUND, _WITH, _NEEDING):
        match = pattern.search(sentence)
        if match and _is_meant(match):
            return _told(match, things) or sentence
    return sentence


def _is_meant(match: re.Match[str]) -> bool:
    if match.re is _WATERED:
        return bool(_ASKED.search(match.string[: match.start()]))
    return match.re not in (_ROUND, _WITH) or _is_vessel(match["vessel"])


def _told(match: re.Match[str], things: Sequence[Thing]) -> str | None:
    before, after = match.string[: match.start()], match.string[match.end() :]
    vessel = match["vessel"] or _liquid(match, things) or _vessel(before, after, things)
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
    after = re.sub(_USING.format(re.escape(vessel)), "", after, flags=re.I)
    return f"{before}pour the {vessel} on {who[0].lower()}{who[1:]}{after}"


def _bare(text: str) -> str:
    return re.sub(r"^(?:the|my|our|your|that|this|those|these) ", "", text, flags=re.I)


def _several(noun: str) -> str:
    return noun if normal(noun) != noun.lower() else f"{noun}s"


def _liquid(match: re.Match[str], things: Sequence[Thing]) -> str | None:
    """What a splash is of, where the scene has it: the milk of a ``milk carton``."""
    said = normal(match.groupdict().get("liquid") or "")
    there = any(thing.unmarked == said or stands_for(thing.name, said) for thing in things)
    return said if said and there else None


def _vessel(before: str, after: str, things: Sequence[Thing]) -> str | None:
    """The vessel that somebody is told to take; any other that is spoken of, or the watering can."""
    spoken = " ".join(f"{before} | {after}".split())
    named = [each for each in mentions(spoken, things) if _is_vessel(each.name)]
    taken = [each for each in named if _TAKEN.search(spoken.lower()[: each.start])]
    found = {each.name for each in taken or named}
    found = found or {each.name for each in things if each.unmarked == _CAN}
    return found.pop() if len(found) == 1 else None


def _is_vessel(name: str) -> bool:
    return normal(name).split()[-1] in VESSELS
