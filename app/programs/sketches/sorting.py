"""What is sorted among containers that tell what they hold: "sort the rubbish into the compost and the recycling bin".

Which of it goes where is a matter of knowledge, not of reading: the sentence that the model reads has
each thing with its container.
"""

import re
from collections.abc import Sequence

from app.programs.knowledge.classes import VAGUE, normal
from app.programs.knowledge.names import words
from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.mentions import mentions
from app.programs.sketches.naming import Naming, spoken
from app.programs.sketches.qualities import is_container
from app.programs.sketches.selection import Selection
from app.programs.sketches.things import Thing

_RIGHTLY = (
    r"(?: (?:in )?(?:the (?:proper|right|correct) way|properly|correctly|as (?:appropriate|you should|they should(?: be)?|is right)|"
    r"accordingly|by (?:type|kind|material|what (?:it is|they are))|where (?:it|they|each)(?: \w+)? belongs?|so (?:that )?(?:it|they|each)[^.;!?]*))"
)
_SORTED = re.compile(
    r"\b(?P<deed>sort|separate|divide|split|distribute|share)(?: out| up)? (?P<what>(?:all )?(?:of )?(?:the|my|our|this|these|that) [\w' -]+?)(?: out| up)?(?P<before> properly| correctly| neatly)? "
    r"(?:between|into|among|amongst|in|to|across) "
    r"(?P<places>them(?: both)?|both|the two(?: of them)?|(?:the|their) (?:right|proper|correct) (?:\w+ )?\w+|(?:the|my|our) [\w' ,-]+?)"
    rf"(?P<rightly>{_RIGHTLY})?(?=\s*(?:[.;:!?]|$)|, (?!(?:and )?(?:the|my|our)\b)| please\b)",
    re.I,
)
_WASTE = word_list("waste")
_STORING = word_list("storing")


def sorted_out(sentence: str, selection: Selection) -> str:
    """The sentence with each thing and the container of its kind; as it is where that does not come out."""
    match = _SORTED.search(sentence)
    if match is None:
        return sentence
    plainly = match["deed"].lower() in ("sort", "separate") or match["rightly"] or match["before"]
    places = _places(match, selection) if plainly else []
    if len(places) < 2:
        return sentence
    # By themselves, "recycling" is no part of the box's name.
    naming = Naming(Selection(selection.things, selection.facts, ""))
    shares = _shares(match["what"], places, naming)
    if not shares:
        return sentence
    # Every thing with its place: of lists, a small model loses the end.
    told = ", ".join(
        f"{spoken([thing])} in {spoken([place])}"
        for place, share in zip(places, shares, strict=True)
        for thing in share
    )
    return f"{sentence[: match.start()]}put {told}{sentence[match.end() :]}"


def _places(match: re.Match[str], selection: Selection) -> list[Thing]:
    """The containers that are named in it, or before it, or that are there."""
    by_name = {each.name: each for each in selection.things if is_container(each)}
    for text in (match["places"], match.string[: match.start()]):
        named = dict.fromkeys(each.name for each in mentions(text, selection.things))
        if len(found := [by_name[name] for name in named if name in by_name]) > 1:
            return found
    said = normal(match["places"]).split()[-1]
    free = [each for each in by_name.values() if _kind(each)]
    storing = [each for each in free if normal(each.words[-1]) in _STORING]
    return [each for each in free if normal(each.words[-1]) == said] or storing


def _kind(place: Thing) -> str:
    """What its name says that it is for: ``recycling`` of a recycling box."""
    return " ".join(place.words[:-1])


def _shares(what: str, places: Sequence[Thing], naming: Naming) -> list[list[Thing]]:
    """What goes into each of them; nothing where one gets nothing, or something fits nowhere."""
    held = {place.name: naming.all(_kind(place), *places) for place in places if _kind(place)}
    noun = re.sub(r"^(?:all )?(?:of )?(?:the|my|our|this|these|that) ", "", what, flags=re.I)
    members = naming.all(noun, *places)
    if set(words(noun)) <= _WASTE | VAGUE:
        members += [each for found in held.values() for each in found if each not in members]
    taken: dict[str, list[Thing]] = {place.name: [] for place in places}
    for thing in members:
        fitting = [name for name, found in held.items() if thing in found]
        if not fitting:
            return []
        taken[min(fitting, key=lambda name: len(held[name]))].append(thing)
    return list(taken.values()) if all(taken.values()) else []
