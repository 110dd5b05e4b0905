"""What everyday things are for and what they are like, in the words people use for want of a name.

``static/knowledge/uses.json``: a noun, and phrases for it that do not name it.
"""

import json
from functools import cache
from pathlib import Path

from app.programs.knowledge.classes import HOLDERS, normal
from app.programs.knowledge.membership import endings, head_first

_DOSES = frozenset(("tablet", "pill", "capsule", "drop", "cream"))
FILE = Path(__file__).parents[3] / "static" / "knowledge" / "uses.json"


def uses(name: str) -> tuple[str, ...]:
    """Phrases for the thing of this name, by its longest ending that is known.

    A desk lamp's are those of a lamp where none are known of its own, a honey jar's are honey's.
    """
    table = _table()
    core = head_first(name)
    held = (normal(" ".join(core[:-1])),) if core and normal(core[-1]) in HOLDERS | _DOSES else ()
    for ending in (normal(name), *held, *endings(core)):
        if found := table.get(ending) or table.get(ending.replace(" ", "")):
            return found
    return ()


@cache
def phrases() -> tuple[str, ...]:
    """Every phrase once, in the file's order."""
    return tuple(dict.fromkeys(phrase for found in _table().values() for phrase in found))


@cache
def _table() -> dict[str, tuple[str, ...]]:
    entries: dict[str, str] = json.loads(FILE.read_text(encoding="utf-8"))
    return {
        normal(noun): tuple(phrase.strip() for phrase in told.split(";"))
        for noun, told in entries.items()
    }
