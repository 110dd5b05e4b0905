"""A use or a look of a thing → the words of somebody who has no name for it."""

import re
from random import Random

_DOES = (
    ("something that {does}", "thing that {does}"),
    ("the thing that {does}", "thing that {does}"),
    ("the one that {does}", "one that {does}"),
    ("what {does}", "thing that {does}"),
    ("that thing which {does}", "thing which {does}"),
    ("the object that {does}", "object that {does}"),
    ("something for {doing}", "thing for {doing}"),
    ("the thing for {doing}", "thing for {doing}"),
    ("something to {do} with", "thing to {do} with"),
    ("what i {do} with", "thing i {do} with"),
    ("the thing you {do} with", "thing you {do} with"),
    ("the gadget for {doing}", "gadget for {doing}"),
    ("the tool that {does}", "tool that {does}"),
)
_IS = (
    ("something {being}", "thing {being}"),
    ("the thing {being}", "thing {being}"),
    ("what is {being}", "thing that is {being}"),
)
_LOOKS = (
    ("the {look}", "{look}"),
    ("the {look}", "{look}"),
    ("that {look}", "{look}"),
    ("my {look}", "{look}"),
    ("this {look}", "{look}"),
)
_STATES = ("needed", "used", "worn", "made", "eaten", "kept", "put", "held", "drunk", "given")


def described(rng: Random, phrase: str) -> tuple[str, str]:
    """As it stands in a sentence, and as a sketch has it."""
    first, _, rest = phrase.partition(" ")
    if first.endswith(("ed", "wn")) or first in _STATES:
        said, kept = rng.choice(_IS)
        return said.format(being=phrase), kept.format(being=phrase)
    if not first.endswith("s") or first.endswith("ss") or not rest:
        said, kept = rng.choice(_LOOKS)
        return said.format(look=phrase), kept.format(look=phrase)
    verb = _plain(first)
    forms = {"does": phrase, "do": f"{verb} {rest}", "doing": f"{_present(verb)} {rest}"}
    said, kept = rng.choice(_DOES)
    return said.format(**forms), kept.format(**forms)


def _plain(verb: str) -> str:
    """``opens`` → ``open``."""
    if verb in ("is", "has", "does", "goes"):
        return {"is": "be", "has": "have", "does": "do", "goes": "go"}[verb]
    if verb.endswith("ies") and len(verb) > 4:
        return f"{verb[:-3]}y"
    if verb.endswith(("shes", "ches", "sses", "xes", "zzes")):
        return verb[:-2]
    return verb[:-1]


def _present(verb: str) -> str:
    """``cut`` → ``cutting``."""
    if verb.endswith("e") and not verb.endswith(("ee", "be")):
        return f"{verb[:-1]}ing"
    short = re.fullmatch(r"[^aeiou]*[aeiou][bdgmnpt]", verb)
    return f"{verb}{verb[-1]}ing" if short else f"{verb}ing"
