"""Everyday words for colours."""

import re

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


def colour_word(colour: str) -> str:
    """The nearest everyday word for ``#rrggbb``; a name stays as it is."""
    if not re.fullmatch(r"#[0-9a-fA-F]{6}", colour):
        return colour.lower()
    rgb = [int(colour[i : i + 2], 16) for i in (1, 3, 5)]
    return min(
        COLOURS,
        key=lambda word: sum((a - b) ** 2 for a, b in zip(rgb, COLOURS[word], strict=True)),
    )
