"""Repetition: a model that has begun to write the same steps over and over."""

import re

ROUNDS = 3
"""So often in a row the same statements are written before it counts as a loop."""
LONGEST = 16
"""Statements of one round."""


def before_repetition(text: str) -> str | None:
    """What of a function's body comes before it repeats itself; None where it does not.

    Comments do not count, since they number the rounds; the first round is kept.
    """
    lines = re.findall(r"[^\n]*\n", text)
    places = [place for place, line in enumerate(lines) if _is_statement(line)]
    said = [lines[place].strip() for place in places]
    for size in range(1, min(LONGEST, len(said) // ROUNDS) + 1):
        last = said[-size:]
        if all(said[-size * (n + 1) : -size * n] == last for n in range(1, ROUNDS)):
            return _without_loose_end(lines[: places[-size * (ROUNDS - 1)]])
    return None


def _is_statement(line: str) -> bool:
    return bool(line.strip()) and not line.lstrip().startswith("#")


def _without_loose_end(lines: list[str]) -> str:
    """Neither the comment of the next round nor an assertion without its recoveries."""
    while lines and (not _is_statement(lines[-1]) or lines[-1].lstrip().startswith("assert")):
        lines = lines[:-1]
    return "".join(lines)
