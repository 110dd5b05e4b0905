"""Colours, materials and sizes: the words for them, and what is typical of a thing."""

import json
import re
from functools import cache
from pathlib import Path

from app.programs.knowledge.classes import FIGURES, classes, normal
from app.programs.knowledge.membership import belonging, endings, head_first
from app.programs.knowledge.names import words
from app.programs.knowledge.wordnet import nouns

FILE = Path(__file__).parents[3] / "static" / "knowledge" / "things.json"
COLOURS = {
    "red": (255, 0, 0),
    "blue": (0, 0, 255),
    "green": (0, 128, 0),
    "yellow": (255, 255, 0),
    "white": (255, 255, 255),
    "black": (0, 0, 0),
    "orange": (255, 165, 0),
    "purple": (128, 0, 128),
    "pink": (255, 192, 203),
    "brown": (139, 69, 19),
    "grey": (128, 128, 128),
    "turquoise": (64, 224, 208),
    "beige": (245, 245, 220),
}
"""Words for colours and where they lie in sRGB."""
COLOUR_WORDS = {
    **{colour: colour for colour in COLOURS},
    "gray": "grey",
    "violet": "purple",
    "lilac": "purple",
    "lavender": "purple",
    "magenta": "pink",
    "crimson": "red",
    "scarlet": "red",
    "maroon": "red",
    "navy": "blue",
    "cyan": "turquoise",
    "teal": "turquoise",
    "golden": "gold",
    "gold": "gold",
    "silver": "silver",
    "silvery": "silver",
    "tan": "beige",
    "cream": "beige",
    "lime": "green",
    "olive": "green",
    "rose": "pink",
    "reddish": "red",
    "bluish": "blue",
    "greenish": "green",
    "yellowish": "yellow",
    "burlywood": "brown",
}
FRUITY = frozenset(
    ("orange", "lime", "olive", "rose", "cream", "lavender", "gold", "silver", "tan")
)
"""Colour words that are things as well."""
MATERIALS = {
    "wood": "wood",
    "wooden": "wood",
    "oak": "oak",
    "bamboo": "bamboo",
    "birch": "birch",
    "beech": "beech",
    "teak": "teak",
    "mahogany": "mahogany",
    "plywood": "plywood",
    "metal": "metal",
    "metallic": "metal",
    "steel": "steel",
    "iron": "iron",
    "aluminum": "aluminium",
    "aluminium": "aluminium",
    "tin": "tin",
    "brass": "brass",
    "bronze": "bronze",
    "copper": "copper",
    "plastic": "plastic",
    "glass": "glass",
    "paper": "paper",
    "cardboard": "cardboard",
    "rubber": "rubber",
    "ceramic": "ceramic",
    "porcelain": "porcelain",
    "china": "porcelain",
    "clay": "clay",
    "terracotta": "clay",
    "leather": "leather",
    "fabric": "cloth",
    "cloth": "cloth",
    "textile": "cloth",
    "cotton": "cotton",
    "denim": "denim",
    "wool": "wool",
    "woolen": "wool",
    "woollen": "wool",
    "woolly": "wool",
    "silk": "silk",
    "stone": "stone",
    "foam": "foam",
    "wicker": "wicker",
    "bone": "bone",
    "ivory": "ivory",
    "pewter": "pewter",
    "chrome": "chrome",
    "zinc": "zinc",
    "titanium": "titanium",
    "granite": "granite",
    "slate": "slate",
}
SORTS_OF = {
    **dict.fromkeys(
        ("oak", "pine", "bamboo", "plywood", "birch", "beech", "teak", "mahogany"), "wood"
    ),
    **dict.fromkeys(
        (
            "steel",
            "iron",
            "aluminium",
            "tin",
            "brass",
            "bronze",
            "copper",
            "silver",
            "gold",
            "pewter",
            "chrome",
            "zinc",
            "titanium",
        ),
        "metal",
    ),
    **dict.fromkeys(("porcelain", "clay"), "ceramic"),
    **dict.fromkeys(("cotton", "denim", "linen", "felt", "wool", "silk"), "cloth"),
    **dict.fromkeys(("marble", "granite", "slate"), "stone"),
}
"""What a material is a sort of."""
MADE_OF = {
    "wood": "wooden object",
    "metal": "metal object",
    "plastic": "plastic object",
    "glass": "glass object",
    "paper": "paper product",
    "cardboard": "cardboard object",
    "rubber": "rubber object",
    "ceramic": "ceramic object",
    "leather": "leather object",
    "cloth": "cotton object",
    "cotton": "cotton object",
    "wool": "wool object",
    "stone": "stone object",
}
SURELY = 0.5
"""From which share of its meanings on a compound is a kind of what it ends with."""
SIZES = {
    "small": -1,
    "little": -1,
    "tiny": -2,
    "mini": -1,
    "short": -1,
    "medium": 0,
    "mid": 0,
    "middle-sized": 0,
    "large": 1,
    "big": 1,
    "huge": 2,
    "giant": 2,
    "tall": 1,
    "long": 1,
    "jumbo": 2,
}
"""How words order sizes."""
SUPERLATIVES = {
    "largest": 1,
    "biggest": 1,
    "tallest": 1,
    "longest": 1,
    "heaviest": 1,
    "widest": 1,
    "smallest": -1,
    "littlest": -1,
    "tiniest": -1,
    "shortest": -1,
    "lightest": -1,
    "thinnest": -1,
    "bigger": 1,
    "larger": 1,
    "smaller": -1,
    "taller": 1,
    "shorter": -1,
    "longer": 1,
    "heavier": 1,
    "lighter": -1,
}


def colour_word(colour: str) -> str:
    """The nearest everyday word for ``#rrggbb``; a name is brought to its everyday word."""
    if not re.fullmatch(r"#[0-9a-fA-F]{6}", colour):
        for word in reversed(words(re.sub(r"(dark|light|medium|pale|deep)", r"\1 ", colour))):
            if word in COLOUR_WORDS:
                return COLOUR_WORDS[word]
        return colour.lower()
    rgb = [int(colour[i : i + 2], 16) for i in (1, 3, 5)]
    return min(
        COLOURS,
        key=lambda word: sum((a - b) ** 2 for a, b in zip(rgb, COLOURS[word], strict=True)),
    )


def colours_named(name: str) -> frozenset[str]:
    """The colours that a name tells of its thing; an orange tells none, an orange cup does."""
    found = head_first(name)
    return frozenset(
        COLOUR_WORDS[word]
        for place, word in enumerate(found)
        if word in COLOUR_WORDS and (place < len(found) - 1 or (word not in FRUITY))
    )


def materials_named(name: str) -> frozenset[str]:
    """The materials that a name tells of its thing: wood of a ``wooden spoon``."""
    found = head_first(name)
    return frozenset(MATERIALS[word] for word in found[:-1] if word in MATERIALS)


def size_named(name: str) -> int | None:
    """How large the name says it is, from -2 to 2."""
    for word in words(name):
        if word in SIZES:
            return SIZES[word]
    return None


def typical_colours(name: str) -> frozenset[str]:
    """The colours a thing of this name has as a rule."""
    return _typical("colours", name)


def typical_size(name: str) -> float | None:
    """About how many centimetres a thing of this name measures as a rule [cm]."""
    found = _typical("sizes", name)
    return max(map(float, found)) if found else None


def made_of(name: str, material: str) -> float:
    """How surely a thing of this name is made of the material as a rule."""
    kind = MADE_OF.get(material) or MADE_OF.get(SORTS_OF.get(material, ""))
    return belonging(name, classes().named(kind)) if kind else 0.0


def _typical(group: str, name: str) -> frozenset[str]:
    table = _things()[group]
    core = head_first(name)
    core = core[:-1] if len(core) > 1 and core[-1] in FIGURES else core
    for ending in endings(core):
        if ending in table:
            return table[ending]
        shorter = ending.partition(" ")[2]
        grown = group == "sizes" and shorter and nouns().kind_of(ending, shorter) >= SURELY
        if classes().knows(ending) and not grown:
            break  # A grand piano is at least as large as a piano, a doll's house no house.
    return frozenset()


@cache
def _things() -> dict[str, dict[str, frozenset[str]]]:
    entries = json.loads(FILE.read_text(encoding="utf-8"))
    return {group: _turned(values) for group, values in entries.items()}


def _turned(values: dict[str, str]) -> dict[str, frozenset[str]]:
    """From noun to its values."""
    found: dict[str, set[str]] = {}
    for value, listed in values.items():
        for noun in listed.split(","):
            found.setdefault(normal(noun), set()).add(value)
    return {noun: frozenset(each) for noun, each in found.items()}
