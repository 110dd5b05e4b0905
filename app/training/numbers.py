"""Numbers as they are spoken and as they are written in a call."""

from app.training.said import Said
from app.training.words import Words

SPOKEN = ("one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")


def shown(words: Words, number: int) -> str:
    """Mostly its word."""
    return SPOKEN[number - 1] if words.chance(0.8) else str(number)


def number(words: Words) -> Said:
    """A small number on its own."""
    found = words.rng.choice((1, 2, 2, 2, 3, 3, 4, 5))
    return Said(shown(words, found), (), forms={"digit": str(found)}, plural=found > 1)
