"""Instruction: the sentence somebody typed, and the function name that cues the model."""

import re
import unicodedata
from dataclasses import dataclass

from app.domain.errors import Fault, InstructionRefused

MAX_CHARACTERS = 1000


@dataclass(frozen=True, slots=True)
class Instruction:
    """A task in plain language.

    Raises:
        InstructionRefused: the text is empty, longer than ``MAX_CHARACTERS``, or has no letter.
    """

    text: str

    def __post_init__(self) -> None:
        object.__setattr__(self, "text", " ".join(self.text.split()))
        if message := _fault(self.text):
            raise InstructionRefused(Fault(field="instruction", message=message))

    @property
    def function_name(self) -> str:
        """The paper's cue: the sentence with underscores, an ASCII identifier."""
        plain = unicodedata.normalize("NFKD", self.text).encode("ascii", "ignore").decode().lower()
        name = re.sub(r"[^a-z0-9]+", "_", plain).strip("_")[:80].strip("_")
        return name if name[:1].isalpha() else f"task_{name}".strip("_")


def _fault(text: str) -> str | None:
    if not text:
        return "is empty; say what the robot should do, like 'put the banana in the bowl'"
    if len(text) > MAX_CHARACTERS:
        return f"has {len(text)} characters; at most {MAX_CHARACTERS} are taken"
    if any(unicodedata.category(character) in ("Cc", "Cs", "Co", "Cn") for character in text):
        return "has control or unassigned characters; plain text is wanted"
    if not any(character.isalpha() for character in text):
        return "has no letter in it; say what the robot should do"
    return None
