"""What a person at home is told where something is not there, or is nothing that can be done."""

import difflib
import re
from collections.abc import Sequence

from app.domain.scene import SceneObject
from app.programs.knowledge.compounds import apart
from app.programs.knowledge.names import words
from app.programs.sketches.meaning import Judge

MOST = 3
"""Things named instead."""
SPELT_ALIKE = 0.75
MEANT_ALIKE = 0.5
"""Likeness of meaning from which a thing is worth naming."""
_EVERYDAY = re.compile(
    r"\b(?:take|bring|carry|put|move|place|lay|fetch|open|close|shut|turn|switch)\b", re.I
)
"""Verbs of what is done at home; what they are said of can be told from the home itself."""
_EXAMPLES = (
    (("milk", "kitchentable"), "bring the milk to the kitchen table"),
    (("apple", "fridge"), "put the apple in the fridge"),
    (("towel", "washingmachine"), "wash the towel in the washing machine"),
    (("salmon", "microwave"), "heat the salmon"),
    (("chicken", "microwave"), "heat the chicken"),
    (("pie", "microwave"), "heat the pie"),
    (("tv",), "turn on the tv"),
    (("curtains",), "open the curtains"),
)
MOST_EXAMPLES = 4


def nearest_things(text: str, names: Sequence[str], judge: Judge | None) -> list[str]:
    """Names spelt much like the text, else those nearest to it in meaning; perhaps none."""
    spelt = difflib.get_close_matches(text.lower(), names, MOST, SPELT_ALIKE)
    if spelt or judge is None:
        return spelt
    scores = judge(text, [[name] for name in names])
    ranked = sorted(zip(scores, names, strict=True), key=lambda pair: -pair[0])
    return [name for score, name in ranked[:MOST] if score >= MEANT_ALIKE]


def not_to_be_done(objects: Sequence[SceneObject]) -> str:
    """What can be asked for instead, by examples of this very home."""
    there = {item.name for item in objects}
    fitting = [f"{said!r}" for things, said in _EXAMPLES if there.issuperset(things)]
    instead = f", such as {', '.join(fitting[:MOST_EXAMPLES])}" if fitting else ""
    return (
        "this is nothing that can be done here: things can be brought, put away, washed, heated, "
        f"opened, closed, switched on and off{instead}"
    )


def plainly_possible(objects: Sequence[SceneObject], sentence: str) -> bool:
    """Whether an everyday verb is said of two things that are there: it is no case for declining."""
    said = f" {' '.join(words(sentence))} "
    names = {item.name: {f" {item.name} ", f" {apart(item.name)} "} for item in objects}
    named = [name for name, spoken in names.items() if any(each in said for each in spoken)]
    return bool(_EVERYDAY.search(sentence)) and len(named) > 1
