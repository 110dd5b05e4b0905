"""Whole sentences with their sketches, read from ``static/training/sentences``.

They say what no template reaches: asides, corrections, fragments, things told by what they are for.
A line reads ``sentence => PUT('x', 'y'); STACK('z', 'x')``; ``#`` begins a remark. Beside these two
there are ``OPEN('x')``, ``CLOSE('x')`` and ``POUR('x', 'y')``.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache

from app.domain.program import literal
from app.training.steps import Step
from app.training.words import FOLDER, plural

_PHRASE = re.compile(r"(?:where=|order=|same\()'[^']+'|'((?:[^'\\]|\\.)+)'")
"""Words for things, but neither a superlative nor what things share."""
_CALL = re.compile(r"(PUT|STACK|OPEN|CLOSE|POUR)\((.*)\)")


@dataclass(frozen=True, slots=True)
class Sentence:
    """One line."""

    text: str
    steps: tuple[Step, ...]

    def about(self, name: Callable[[], str]) -> "Sentence":
        """The same of other things, or as it is where it speaks of them in other words."""
        phrases = dict.fromkeys(
            _bare(each)
            for step in self.steps
            for each in _PHRASE.findall(" ".join(step.given.values()))
            if each
        )
        within = any(each != other and each in other for each in phrases for other in phrases)
        if within or not all(_stands(each, self.text) for each in phrases):
            return self
        others = {each: plural(name()) if each.endswith("s") else name() for each in phrases}

        def put(match: re.Match[str]) -> str:
            return others[match[0].lower()]

        def rename(match: re.Match[str]) -> str:
            return literal(others[_bare(match[1])]) if match[1] else match[0]

        longest = sorted(map(re.escape, others), key=len, reverse=True)
        text = re.sub(rf"\b(?:{'|'.join(longest)})\b", put, self.text, flags=re.I)
        steps = tuple(
            replace(
                step,
                given={role: _PHRASE.sub(rename, said) for role, said in step.given.items()},
            )
            for step in self.steps
        )
        return Sentence(text, steps)


def _bare(phrase: str) -> str:
    return phrase.replace("\\'", "'")


def _stands(phrase: str, text: str) -> bool:
    return len(re.findall(rf"\b{re.escape(phrase)}\b", text, re.I)) > 0 and len(phrase.split()) < 4


@cache
def sentences() -> tuple[Sentence, ...]:
    """All of them, file by file."""
    files = sorted((FOLDER / "sentences").glob("*.txt"))
    lines = (line for file in files for line in file.read_text(encoding="utf-8").splitlines())
    return tuple(_sentence(line) for line in lines if line and not line.startswith("#"))


def _sentence(line: str) -> Sentence:
    text, _, sketch = line.rpartition(" => ")
    return Sentence(text, tuple(_step(call.strip()) for call in sketch.split("; ")))


def _step(call: str) -> Step:
    match = _CALL.fullmatch(call)
    if match is None:
        raise ValueError(f"a step reads PUT('x', 'y'), OPEN('x') or the like, not {call!r}")
    roles = "x" if match[1] in ("OPEN", "CLOSE") else "xy"
    return Step(
        match[1], dict(zip(roles, _arguments(match[2]), strict=True)), on=match[1] == "STACK"
    )


def _arguments(inner: str) -> list[str]:
    """The arguments, apart at the commas that are in no bracket and no quotes."""
    found, depth, quoted = [""], 0, False
    for place, letter in enumerate(inner):
        quoted ^= letter == "'" and inner[place - 1 : place] != "\\"
        if not quoted:
            depth += (letter in "([") - (letter in ")]")
        if letter == "," and not depth and not quoted:
            found.append("")
        else:
            found[-1] += letter
    return [each.strip() for each in found]
