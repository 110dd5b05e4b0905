"""Numbers as they are spoken and as they are written in a call."""

from random import Random

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


def figure(rng: Random) -> Said:
    """A number in digits: degrees, seconds, a share."""
    found = rng.choice(
        (
            str(rng.randint(1, 9)),
            str(rng.choice((10, 15, 20, 30, 45, 90, 180, 60))),
            f"0.{rng.randint(1, 9)}",
            f"0.{rng.randint(10, 99)}",
            f"-0.{rng.randint(1, 9)}",
        )
    )
    return Said(found, (), forms={"digit": found})
