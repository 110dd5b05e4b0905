"""Words for a thing or a set as they stand in a sentence, with what a sketch says for them."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field

from app.domain.program import literal

_FIELD = re.compile(r"\{(\w+)(?:\.(\w+)|\?([^|{}]*)\|([^{}]*))?\}")
_SINGULAR = {"it": "it", "they": "it", "it2": "it", "itthey": "it", "isnt": "isn't"}
_PLURAL = {"it": "them", "they": "they", "it2": "they", "itthey": "they", "isnt": "aren't"}


@dataclass(frozen=True, slots=True)
class Said:
    """One noun phrase."""

    text: str
    """In the sentence, with its article."""
    arguments: tuple[str, ...]
    """In the sketch; several where it names several things one by one."""
    words: str = ""
    """As a keyword's value: ``'banana'``, or a list of such."""
    plural: bool = False
    forms: Mapping[str, str] = field(default_factory=dict)
    """Other ways it may stand in a template: ``{h.in}`` is ``forms["in"]``."""
    kind: str = ""
    """``in`` or ``on`` for what holds things, else free."""

    def form(self, name: str) -> str:
        """``{x.name}`` of a template."""
        if name in self.forms:
            return self.forms[name]
        if name == "s":
            return f"{self.text}'" if self.text.endswith("s") else f"{self.text}'s"
        if name == "her":
            return "them" if self.plural else "it"
        if name in ("a", "bare"):
            return self.text
        if name == "nor":
            return f"not {self.text}"
        return (_PLURAL if self.plural else _SINGULAR)[name]


def one(text: str, phrase: str, **forms: str) -> Said:
    """Exactly one thing, by its words."""
    return Said(text, (literal(phrase),), literal(phrase), forms=forms)


def fill(template: str, slots: Mapping[str, Said]) -> str:
    """The template with its slots in place.

    ``{x}`` is the phrase, ``{x.it}`` one of its forms, ``{x?goes|go}`` agrees with its number.
    """

    def put(match: re.Match[str]) -> str:
        name, form, single, many = match.groups()
        said = slots[name]
        if form:
            return said.form(form)
        if single is not None:
            return many if said.plural else single
        return said.text

    return tidy(_FIELD.sub(put, template))


def arguments(template: str, slots: Mapping[str, Said]) -> list[str]:
    """The template of a sketch's argument, filled; one for each thing it names."""
    if len(found := _FIELD.findall(template)) == 1 and template == f"{{{found[0][0]}}}":
        return list(slots[found[0][0]].arguments)

    def put(match: re.Match[str]) -> str:
        said = slots[match.group(1)]
        if match.group(2) == "words":
            return said.words
        return said.forms[match.group(2)] if match.group(2) else said.arguments[0]

    return [_FIELD.sub(put, template)]


def tidy(text: str) -> str:
    """Single spaces, and none or one mark where two would meet."""
    text = " ".join(text.split())
    text = re.sub(r" +([,.;:?!])(?=\s|$)", r"\1", text)
    text = re.sub(r",\s*,", ",", text)
    return re.sub(r",\s*([.;?!:])", r"\1", text)
