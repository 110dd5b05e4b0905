"""Of the things a noun fits, those with the properties, sizes and places that are asked for."""

from collections.abc import Iterable

from app.programs.knowledge.classes import LIVELY, classes, normal
from app.programs.knowledge.membership import belonging
from app.programs.knowledge.names import plain, words
from app.programs.knowledge.properties import typical_size
from app.programs.sketches.description import Description
from app.programs.sketches.matching import COUNTS
from app.programs.sketches.phrase import read_description
from app.programs.sketches.things import LIKELY, Thing

Fits = list[tuple[Thing, float]]
"""Things, each with how well it fits."""


AXES = {"left_of": (1, 1), "right_of": (1, -1), "behind": (0, 1), "in_front_of": (0, -1)}


def has_properties(thing: Thing, described: Description) -> float:
    """How surely it has the colours and materials asked for."""
    checks = [
        max(thing.has_colour(colour) for colour in described.colours)
        for _ in range(bool(described.colours))
    ]
    checks += [
        max(thing.has_material(material) for material in described.materials)
        for _ in range(bool(described.materials))
    ]
    found = min(checks, default=1.0)
    return LIKELY if 0.8 <= found < LIKELY else found


def sized(kept: Fits, described: Description, many: bool) -> Fits:
    """Those whose name or description tells the size asked for, else the larger or smaller ones."""
    wanted = max(described.sizes, key=abs)
    told = [(t, s) for t, s in kept if t.told_size() is not None]
    if told:
        alike = [(t, s) for t, s in told if _sign(t.told_size() or 0) == _sign(wanted)]
        if len(alike) > 1 and abs(wanted) == 2:
            alike = [(t, s) for t, s in alike if abs(t.told_size() or 0) == 2] or alike
        return alike
    measured = [(t, s, m) for t, s in kept if (m := t.measured()) is not None]
    if len(measured) < 2:
        return kept
    ordered = sorted(measured, key=lambda each: each[2])
    if not many:
        place = -1 if wanted > 0 else 0 if wanted < 0 else len(ordered) // 2
        return [ordered[place][:2]]
    middle = (ordered[0][2] * ordered[-1][2]) ** 0.5
    return [(t, s) for t, s, m in measured if _sign(m - middle) == _sign(wanted)]


def extreme(kept: Fits, described: Description, many: bool) -> Fits:
    """The one at the side, of the size or of the number in the row that is asked for."""
    if len(kept) < 2:
        return kept
    if described.superlative:
        return _most(kept, described.superlative)
    if described.ordinal:
        return _numbered(kept, described)
    return _at_side(kept, described.side or "", many)


def _at_side(kept: Fits, side: str, many: bool) -> Fits:
    said = {"left": ("left", "leftmost"), "right": ("right", "rightmost")}.get(
        side, (side, "center", "centre") if side == "middle" else (side,)
    )
    named = [pair for pair in kept if set(said) & set(pair[0].words)]
    if named:
        return named
    placed = [pair for pair in kept if is_placed(pair[0])]
    if len(placed) < 2 or side in ("top", "bottom"):
        return kept
    axis = 1 if side in ("left", "right", "middle", "outer") else 0
    ordered = sorted(placed, key=lambda pair: stands(pair[0])[axis])
    if side in ("middle", "outer") and many:
        return _inner(ordered, inside=side == "middle")
    if side == "middle":
        return [ordered[len(ordered) // 2]]
    if side == "outer":
        return [ordered[0], ordered[-1]]
    if many:
        middle = (stands(ordered[0][0])[axis] + stands(ordered[-1][0])[axis]) / 2
        up = side in ("left", "far")
        sign = 1 if up else -1
        return [pair for pair in placed if sign * (stands(pair[0])[axis] - middle) > 0]
    return [ordered[-1 if side in ("left", "far") else 0]]


def _inner(ordered: Fits, *, inside: bool) -> Fits:
    """Those in the middle third of the row, or those beside it; of a row from right to left."""
    first, last = (stands(ordered[place][0])[1] for place in (0, -1))
    third = (last - first) / 6
    kept = [p for p in ordered if (abs(stands(p[0])[1] - (first + last) / 2) <= third) == inside]
    return kept or ([ordered[len(ordered) // 2]] if inside else ordered)


def _most(kept: Fits, sign: int) -> Fits:
    told = [(t, s) for t, s in kept if t.told_size() is not None]
    if told and len({t.told_size() for t, _ in kept}) > 1:
        best = max(sign * (t.told_size() or 0) for t, _ in kept)
        return [(t, s) for t, s in kept if sign * (t.told_size() or 0) == best]
    measured = [(t, s, m) for t, s in kept if (m := t.measured()) is not None]
    if not measured:
        return kept
    best = max(sign * m for _, _, m in measured)
    return [(t, s) for t, s, m in measured if sign * m == best]


def _numbered(kept: Fits, described: Description) -> Fits:
    placed = [pair for pair in kept if is_placed(pair[0])]
    if len(placed) == len(kept):
        left = described.ordinal_from == "left"
        kept = sorted(placed, key=lambda pair: stands(pair[0])[1], reverse=left)
    else:
        kept = sorted(kept, key=lambda pair: pair[0].words)
    place = described.ordinal - 1 if described.ordinal > 0 else -1
    return [kept[place]] if place < len(kept) else []


def ordered(things: Iterable[Thing], order: str | None) -> list[Thing]:
    """The things in the order that is asked for; the scene's where none is, or none can be told."""
    found = list(things)
    if not order:
        return found
    said = read_description(f"{order} x")
    wanted = plain(order)
    if "left to right" in wanted or "right to left" in wanted:
        reverse = wanted.index("left") < wanted.index("right")
        return sorted(found, key=lambda t: stands(t)[1], reverse=reverse)
    sign = said.superlative or max(said.sizes, default=0, key=abs)
    if not sign:
        return found
    if all(thing.told_size() is not None for thing in found):
        return sorted(found, key=lambda t: -sign * (t.told_size() or 0))
    if any(thing.told_size() is not None for thing in found):
        return sorted(found, key=lambda t: -sign * (t.told_size() or 0))
    if all(thing.measured() is not None for thing in found):
        return sorted(found, key=lambda t: -sign * (t.measured() or 0.0))
    return found


SIDES = {
    "left": (0.0, 1.0), "right": (0.0, -1.0), "center": (0.0, 0.0), "centre": (0.0, 0.0),
    "middle": (0.0, 0.0), "front": (-1.0, 0.0), "near": (-1.0, 0.0), "back": (1.0, 0.0),
    "rear": (1.0, 0.0), "behind": (1.0, 0.0),
}  # fmt: skip
"""Where the words of a declared position are, x and y [of no unit]."""


def stands(thing: Thing) -> tuple[float, float, float]:
    """Where it is: as somebody said in words, else as it was measured."""
    return _said_place(thing) or thing.item.position or (0.0, 0.0, 0.0)


def is_placed(thing: Thing) -> bool:
    """Whether anything is known of where it is."""
    return bool(thing.item.position or _said_place(thing))


def _said_place(thing: Thing) -> tuple[float, float, float] | None:
    said = dict(thing.item.properties).get("position", "")
    found = [SIDES[word] for word in words(said) if word in SIDES]
    if not found:
        return None
    reach = 2.0 if "far" in words(said) else 1.0
    return reach * sum(x for x, _ in found), reach * sum(y for _, y in found), 0.0


def distance(thing: Thing, here: tuple[float, float, float]) -> float:
    x, y, _ = stands(thing)
    return (x - here[0]) ** 2 + (y - here[1]) ** 2


def _sign(value: float) -> int:
    return (value > 0) - (value < 0)


def far_larger(thing: Thing, target: Thing) -> bool:
    """Whether it cannot fit inside the target: by its measures and by what is typical."""
    mine, theirs = typical_size(thing.name), typical_size(target.name)
    if thing.item.size and target.item.size:
        # A world measures what it does not know as a neutral box: the names have to say so too.
        smaller = mine is None or theirs is None or mine <= theirs
        return not smaller and sorted(thing.item.size)[1] > 1.2 * max(target.item.size)
    if not (mine and theirs and mine > MISFIT * theirs):
        return False
    return mine <= FURNITURE or (is_tiny(target) and not _maybe_toy(thing))


FURNITURE, MISFIT = 40.0, 3.5
"""Up to which typical size [cm], and by which factor, names alone tell that it cannot fit."""
TINY = 7.0
"""Up to which typical size [cm] hardly anything fits."""


def is_tiny(target: Thing) -> bool:
    """Whether it holds small things only, as a rule: a thimble, a cup."""
    size = typical_size(target.name)
    return size is not None and size <= TINY


def _maybe_toy(thing: Thing) -> bool:
    """Whether a thing of this name is as likely a toy, on a table."""
    if (thing.told_size() or 0) > 0:
        return False
    return any(
        belonging(thing.name, classes().named(kind)) >= COUNTS
        for kind in LIVELY - {"musical instrument"}
    )


def affording(found: Fits, affordance: str | None) -> Fits:
    """Those that afford it, or all where none is told to; any of ``a|b`` will do."""
    if affordance is None:
        return found
    wanted = set(affordance.split("|"))
    kept = [(t, s) for t, s in found if wanted & set((t.property("affordances") or "").split())]
    return kept or found


def is_called(thing: Thing, described: Description) -> bool:
    """Whether all of the words, properties included, are its name."""
    if plain(thing.name).strip() == plain(described.text).strip():
        return True
    return normal(" ".join(described.whole)) in (normal(" ".join(thing.words)), thing.unmarked)


def is_container(thing: Thing) -> bool:
    """Whether things are put into or onto it as a rule."""
    if thing.item.container:
        return True
    return any(
        belonging(thing.name, classes().named(kind)) >= COUNTS
        for kind in ("container", "dish", "furniture", "cookware")
    )
