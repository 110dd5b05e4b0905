"""What is poured, and where: not on the tea bag but into the mug that it was put into."""

import re
from collections.abc import Sequence

from app.domain.errors import TaskDeclined
from app.programs.knowledge.classes import classes
from app.programs.knowledge.membership import belonging
from app.programs.knowledge.solids import is_solid
from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.course import Course
from app.programs.sketches.matching import COUNTS
from app.programs.sketches.qualities import is_container
from app.programs.sketches.things import Thing

_POINTED = re.compile(
    r"\b(?:pour|tip|splash|empty|drizzle)\b[^.;!?]*? (?:on|onto|over|in|into|upon|to)(?: top of)? (?:it|them|that|there|this|both)\b|"
    r"\b(?:pour|tip|splash|empty)\b[^.;!?]*? (?:on top|over the top|in|on|over)(?=\s*(?:[.,;!?]|$))",
    re.I,
)
_TAKEN = re.compile(
    r"\b(?:grab|take|get|fetch|pick up|lift|reach for|find) (?P<what>(?:the|my|our|that|this) [\w' -]+?),? and (?:then )?"
    r"(?:(?P<pour>pour|empty|decant)|(?P<tip>tip)) (?P<all>it|all of it|it all|its contents|the contents|the lot)(?: out)? (?=(?:in|into|on|onto|over)\b)",
    re.I,
)
"""Grab the can and empty it into the pot."""
_TOPPED = re.compile(
    r"\b(?:top|fill) (?:(?P<what>it|them|that|(?:the|my|our|that|this) [\w' -]+?) (?:up|off)|up (?P<what2>(?:the|my|our|that) [\w' -]+?)) "
    r"(?:with|from)(?: (?:some|a (?:little|bit|splash|drop)) (?:of )?)? (?P<from>(?:the |my |our )?[\w' -]+?)(?=\s*(?:[.,;:!?]|$)| (?:and|then|please)\b)",
    re.I,
)
"""Top it up with the milk."""
_GRAINS = word_list("grains")
_WHOLE = ("furniture", "book", "musical instrument", "cutlery")
"""Classes of which nothing flows."""
POUR = "pour"


def poured_out(sentence: str, things: Sequence[Thing]) -> str:
    """The sentence with what is emptied elsewhere told at once."""
    sentence = _TOPPED.sub(
        lambda found: f"pour {found['from']} into {found['what'] or found['what2']}", sentence
    )
    match = _TAKEN.search(sentence)
    if match is None or not any(is_container(each) for each in things):
        return sentence
    return f"{sentence[: match.start()]}pour {match['what']} {sentence[match.end() :]}"


def poured_into(target: str, course: Course, sentence: str, things: Sequence[Thing]) -> str:
    """Where it is poured: what holds the thing that "it" stands for."""
    place = course.places.get(target)
    by_name = {each.name: each for each in things}
    if place is None or not _POINTED.search(sentence) or is_container(by_name[target]):
        return target
    head = re.escape(by_name[place].words[-1])
    within = rf"\b(?:in|into|inside)(?: (?:the|my|our|that|this|an?))?(?: [\w-]+)?? {head}\b"
    grows = belonging(target, classes().named("plant")) >= COUNTS
    return place if re.search(within, sentence, re.I) and not grows else target


def refuse_solid(name: str) -> None:
    """Let pass what flows or trickles, and what may hold something that does.

    Raises:
        TaskDeclined: it is one solid thing.
    """
    solid = is_solid(name) or any(belonging(name, classes().named(k)) >= COUNTS for k in _WHOLE)
    if solid and not _GRAINS & set(name.lower().split()) and not name.endswith("s"):
        raise TaskDeclined(f"the {name} is solid and cannot be poured", kind="impossible")
