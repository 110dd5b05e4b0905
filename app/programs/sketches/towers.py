"""The order of a tower as its sentence tells it: what stands on what, read from the words alone.

Language models of this size mix up top and bottom; the words that tell are few: "on the", "at the
bottom", "highest", "from top to bottom". Where they do not tell it plainly, nothing is said here.
"""

import itertools
import re
from collections.abc import Sequence

from app.programs.knowledge.classes import normal
from app.programs.sketches.crowning import crown
from app.programs.sketches.mentions import Mention, mentions
from app.programs.sketches.qualities import is_container
from app.programs.sketches.things import Thing

Pair = tuple[str, str]
"""A thing and what it stands on, by their names."""
FEWEST = 3
"""Things of a tower; of two, only what is at the bottom and what on top is told here: one word alone
tells it as well, which a model reads well."""
_PILING = re.compile(
    r"\b(?:stack|pile|piled|tower|heap|build|burger|sandwich|cairn|top|bottom|start from|start with)\b",
    re.I,
)
_ON = re.compile(r"\b(?:on|onto|atop|over)(?: top of)?(?: the| a| an| my| that| this)? $", re.I)
_NEXT_CLAUSE = re.compile(
    r"\.|[,;:] (?:and |then |while |but )?(?:(?:put|place|set|stand|lay) )?(?:the|a|an|my|all|any|every|some|each)\b.*\bon"
)
"""Between two things, where the second belongs to what is said next of a third one."""
_ON_IT = re.compile(r" (?:on|onto|atop|over)(?: top of)? (?:it|that|this)\b(?! all)", re.I)
_UNDER = re.compile(
    r"\b(?:under|underneath|below|beneath|supports|carries)(?: the| a| an| my| that| this)? $", re.I
)
_THEN = re.compile(
    r"\b(?:on|onto|atop|above|over)(?: top of)? (?:which|it|that|this)\b(?! all)[^.;,]{0,30}$", re.I
)
"""Between a thing and the one that comes onto it: "the plate, on top of which goes the cup"."""
_START = re.compile(r"\bstart(?:ing)? (?:from|with)(?: the| a| an| my| that| this)? $", re.I)
_DOWN = re.compile(r"top to bottom|from the top\b|top down|from above|downwards", re.I)
_UP = re.compile(r"bottom to top|bottom up|from the bottom|ground up|upwards", re.I)
_LOWEST = re.compile(
    r"\b(?:bottom|lowest|base|below|undermost|underneath|foundation|floor of|foot of)\b",
    re.I,
)
_MIDDLE = re.compile(r"\b(?:in[- ]between|between|in the (?:middle|cent(?:re|er)))\b", re.I)
_IN_TURN = re.compile(
    r"\b(?:stack|pile|heap|build|tower|burger|sandwich|cairn|start)\b.*\b(?:then|next|last|finally)\b",
    re.I,
)
"""A tower that is told piece by piece is told from below."""
_ALL_OF_THEM = re.compile(
    r"\b(?:them|everything|(?:all|the) (?:(?:the|of the|three|four|five|six) )?"
    r"(?:blocks|cubes|bricks|\w+s))\b",
    re.I,
)
_HIGHEST = re.compile(
    r"\b(?:highest|uppermost|topmost|crown(?:s|ing|ed)?)\b|\bon top of (?:it all|everything|them all|all)\b|"
    r"\b(?:finish|top|cap)(?:ing)? (?:it|them|everything|the \w+)(?: all)?(?: off)? with\b|"
    r"\b(?:on|at|to)(?: the)?(?: very)? top\b(?! of)",
    re.I,
)


_NOT_OF_IT = re.compile(
    r"(?: (?:block|one|book|box))?,? (?:is|does|should|must|will|need|can)(?:n't|not| not)\b",
    re.I,
)
"""After a thing that the sentence only says is no part of the tower."""


_NONE_OF_IT = re.compile(
    r"\b(?:no|without|hold(?: the)?|skip(?: the)?|leave (?:out|off)(?: the)?|leaving (?:out|off)(?: the)?|not|minus(?: the)?)"
    r" (?:(?:any|the) )?(?:[\w-]+,? (?:[\w-]+,? )?(?:or|and|nor) (?:the |any )?)?$",
    re.I,
)
"""Before a thing that is left out of it: "no salad or gherkin for me"."""


def tower(sentence: str, things: Sequence[Thing]) -> list[Pair] | None:
    """What is put on what, the lowest first; None where no tower is told, or not plainly."""
    text = " ".join(sentence.lower().split())
    things = _stackable(things, text)
    found = [
        m
        for m in mentions(sentence, things)
        if not _NOT_OF_IT.match(text[m.end :]) and not _NONE_OF_IT.search(text[: m.start])
    ]
    told = _by_relation(sentence, found)
    return told or (_by_place(sentence, found, things) if _PILING.search(sentence) else None)


def _stackable(things: Sequence[Thing], text: str) -> list[Thing]:
    """Without containers that the sentence has no word for: towers of "red" and "green" are of blocks."""
    said = set(re.findall(r"\w+", text))
    kept = [
        t
        for t in things
        if not is_container(t) or (t.core and normal(t.core[-1]) in map(normal, said))
    ]
    return kept if _PILING.search(text) else list(things)


def _by_relation(sentence: str, found: Sequence[Mention]) -> list[Pair] | None:
    """The pairs as they are told: "the saucer on the plate, the cup on the saucer"."""
    text = " ".join(sentence.lower().split())
    highest = crown(text, found)
    found = [each for each in found if each is not highest]
    pairs: list[Pair] = []
    for one, other in itertools.pairwise(found):
        between = text[one.end : other.start]
        if one.name == other.name:
            continue
        close = not _NEXT_CLAUSE.search(between)
        if close and _ON.search(between):
            pairs.append((one.name, other.name))
        elif (
            (close and _UNDER.search(between))
            or _ON_IT.match(text[other.end :])
            or _THEN.search(between)
        ):
            pairs.append((other.name, one.name))
    bare = all(" " not in text[each.start : each.end] for each in found)
    least = 1 if bare and _PILING.search(text) else FEWEST - 1  # "Stack red on green."
    if (
        len(pairs) + bool(highest) < least
        or not pairs
        or len({thing for thing, _ in pairs}) < len(pairs)
    ):
        return None
    if {name for pair in pairs for name in pair} != {each.name for each in found}:
        return None
    chain = _lowest_first(pairs)
    return [*chain, (highest.name, chain[-1][0])] if chain and highest else chain


def _lowest_first(pairs: list[Pair]) -> list[Pair] | None:
    """One chain from below; None where they are no chain."""
    below = dict(pairs)
    bases = [place for _, place in pairs if place not in below]
    if len(bases) != 1:
        return None
    above = {place: thing for thing, place in pairs}
    if len(above) != len(pairs):
        return None
    place = bases[0]
    ordered: list[Pair] = []
    while place in above:
        ordered.append((above[place], place))
        place = above[place]
    return ordered if len(ordered) == len(pairs) else None


def _unsaid(text: str, found: Sequence[Mention], things: Sequence[Thing]) -> list[Mention]:
    """The others of "them all", where only the lowest and the highest are told by name."""
    names = {each.name for each in found}
    ends = _marked(text, found, _LOWEST), _marked(text, found, _HIGHEST)
    if names != set(ends) or len(names) != 2 or not _ALL_OF_THEM.search(text):
        return []
    kinds = {thing.core[-1] for thing in things if thing.name in names and thing.core}
    alike = [t.name for t in things if t.core and t.core[-1] in kinds and t.name not in names]
    return [Mention(len(text), len(text), name) for name in alike] if len(kinds) == 1 else []


def _by_place(
    sentence: str, found: Sequence[Mention], things: Sequence[Thing]
) -> list[Pair] | None:
    """A list, and words for its ends: "red at the bottom, then blue, green on top"."""
    text = " ".join(sentence.lower().split())
    started = next((m for m in found if _START.search(text[: m.start])), None)
    base = started or next(
        (m for m in found if _ON.search(text[: m.start]) and _is_place(m, text)), None
    )
    found = [*found, *_unsaid(text, found, things)]
    listed = text.find(":", next((m.start() for m in _PILING.finditer(text)), 0))
    found = [m for m in found if m is base or m.start > listed]
    pieces = list(dict.fromkeys(m.name for m in found if m is not base))
    ends = {_marked(text, found, mark) for mark in (_LOWEST, _HIGHEST)}
    if (len(pieces) + bool(started) < FEWEST and ends != set(pieces)) or (
        base and base.name in pieces
    ):
        return None
    related = any(
        _ON.search(text[one.end : other.start])
        for one, other in itertools.pairwise(found)
        if base not in (one, other)
    )
    if related:
        return None
    order = _ordered(text, found, pieces)
    if order is None:
        return None
    chain = [base.name, *order] if base else order
    return [(thing, place) for place, thing in itertools.pairwise(chain)]


def _is_place(mention: Mention, text: str) -> bool:
    """Whether it is where the whole is built: "on the tray" before the list or after it."""
    return not re.match(r"[^,;.:]*\b(?:lowest|highest|bottom)\b", text[mention.end :])


def _ordered(text: str, found: Sequence[Mention], pieces: list[str]) -> list[str] | None:
    """The pieces from below; None where the words do not tell."""
    if _DOWN.search(text):
        return pieces[::-1]
    if _UP.search(text):
        return pieces
    lowest = _marked(text, found, _LOWEST)
    highest = _marked(text, found, _HIGHEST)
    if len(pieces) == FEWEST and (
        three := _three(pieces, lowest, _marked(text, found, _MIDDLE), highest)
    ):
        return three
    if lowest not in pieces and highest not in pieces:
        return pieces if _IN_TURN.search(text) and lowest is highest is None else None
    if lowest in pieces and highest in pieces and lowest != highest:
        inner = [each for each in pieces if each not in (lowest, highest)]
        return [lowest, *(inner if _before(pieces, lowest, highest) else inner[::-1]), highest]
    if lowest in pieces:
        return pieces if pieces[0] == lowest else pieces[::-1] if pieces[-1] == lowest else None
    return pieces if pieces[-1] == highest else pieces[::-1] if pieces[0] == highest else None


def _three(pieces: Sequence[str], *marked: str | None) -> list[str] | None:
    """Lowest, middle and highest, where two of them tell the third."""
    told = [each if each in pieces else None for each in marked]
    if told.count(None) > 1 or len(set(told)) < len(told):
        return None
    left = next((each for each in pieces if each not in told), "")
    return [each or left for each in told]


def _before(pieces: list[str], one: str, other: str) -> bool:
    return pieces.index(one) < pieces.index(other)


def _marked(text: str, found: Sequence[Mention], mark: re.Pattern[str]) -> str | None:
    """The one thing that is named in the clause of the mark."""
    for match in mark.finditer(text):
        start = max(text.rfind(each, 0, match.start()) for each in (",", ";", ".", ":", " and "))
        ends = [text.find(each, match.end()) for each in (",", ";", ".", " and ", " then ")]
        end = min((each for each in ends if each >= 0), default=len(text))
        inside = {m.name for m in found if start < m.start < end}
        if len(inside) == 1:
            return inside.pop()
    return None
