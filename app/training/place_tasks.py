"""Tasks about where things stand: left and right, and one on top of another."""

import itertools

from app.training.phrases import NounPhrase, Speaker, plural
from app.training.scenes import Item, Setting
from app.training.tasks import PUT, Answered, Step, answer, put, stated, task_kind

WORDS = {
    "left": (
        "the {n} on the left",
        "the left {n}",
        "the leftmost {n}",
        "the {n} on the left side",
        "the left-hand {n}",
        "the {n} to the left",
        "the {n} furthest to the left",
    ),
    "right": (
        "the {n} on the right",
        "the right {n}",
        "the rightmost {n}",
        "the {n} on the right side",
        "the right-hand {n}",
        "the {n} to the right",
        "the {n} furthest to the right",
    ),
    "center": (
        "the {n} in the middle",
        "the middle {n}",
        "the {n} in the center",
        "the central {n}",
        "the {n} between the others",
    ),
}
SIDES = {
    "left": (
        "everything on the left",
        "all the things on the left side",
        "what is on the left",
        "the things on the left of the table",
    ),
    "right": (
        "everything on the right",
        "all the things on the right side",
        "what is on the right",
        "the things on the right of the table",
    ),
    "center": ("everything in the middle", "what stands in the middle", "the things in the center"),
}


@task_kind("left and right")
def one_side(say: Speaker, scene: Setting) -> Answered | None:
    """One of several look-alikes, told by where it stands, or all that stands on a side."""
    if "position" not in scene.shown:
        return None
    side = say.rng.choice(("left", "right", "left", "right", "center"))
    holder = say.rng.choice(scene.holders)
    there = [item for item in scene.listed(scene.things) if item.properties["position"] == side]
    if there and say.rng.random() < 0.25:
        sentence = say.move(NounPhrase(say.choose(SIDES[side]), True), holder)
        return answer(say.dress(sentence), [stated(f"on the {side}", there), *put(there, holder)])
    alone = [
        item
        for item in there
        if sum(o.noun == item.noun for o in there) == 1
        and sum(o.noun == item.noun for o in scene.things) > 1
    ]
    if not alone:
        return None
    item = say.rng.choice(alone)
    what = say.choose(WORDS[side]).format(n=item.noun)
    return answer(
        say.dress(say.move(NounPhrase(what), holder)),
        [stated(f"{side} {item.noun}", [item]), *put([item], holder)],
    )


@task_kind("side of a place")
def holder_side(say: Speaker, scene: Setting) -> Answered | None:
    """The place is told by its side."""
    sides = [h for h in scene.holders if h.name.split()[0] in ("left", "right")]
    if not sides:
        return None
    holder, item = say.rng.choice(sides), say.rng.choice(scene.things)
    side = holder.name.split()[0]
    at = say.choose(
        (
            f"the {holder.noun} on the {side}",
            f"the {side} {holder.noun}",
            f"the {side}-hand {holder.noun}",
            f"the {holder.noun} on the {side} side",
        )
    )
    sentence = say.choose(
        (
            "put {x} {p} {h}",
            "{x} goes {p} {h}",
            "move {x} {p} {h}",
            "i want {x} {p} {h}",
            "place {x} {p} {h}",
            "{p} {h} goes {x}",
            "drop {x} {p} {h}",
        )
    )
    return answer(
        say.dress(sentence.format(x=say.the(item).text, p=holder.preposition, h=at)),
        put([item], holder),
    )


@task_kind("stacking")
def stacking(say: Speaker, scene: Setting) -> Answered | None:
    """Two to four things on top of one another, said from the bottom or from the top."""
    if len(scene.things) < 2:
        return None
    count = min(len(scene.things), say.rng.choice((2, 3, 3, 3, 4)))
    pile = say.rng.sample(scene.things, count)
    if (
        scene.marked == "size"
        and len({i.properties["size"] for i in scene.things}) > 1
        and say.rng.random() < 0.5
    ):
        return _by_size(say, scene)
    ground = say.rng.choice(scene.holders) if say.rng.random() < 0.35 else None
    where = f" {ground.preposition} {say.the(ground).text}" if ground else ""
    up = [say.the(item).text for item in pile]
    down = up[::-1]
    if count == 2:
        sentence = say.choose(
            (
                f"stack {down[0]} on {down[1]}",
                f"put {down[0]} on top of {down[1]}",
                f"{down[0]} goes on {down[1]}",
                f"balance {down[0]} on {down[1]}",
                f"pile {down[0]} onto {down[1]}",
                f"i want {down[1]} with {down[0]} on top of it",
                f"{down[1]} should have {down[0]} on top",
            )
        )
        return answer(say.dress(sentence), _pile(pile, None))
    listing_up, listing_down = _listing(up), _listing(down)
    sentence = say.choose(
        (
            f"stack{where}, from bottom to top: {listing_up}",
            f"build a tower{where}: {up[0]} at the bottom, then {', then '.join(up[1:])}",
            f"make a pile{where} of {listing_up}, with {up[0]} at the bottom and {up[-1]} on top",
            f"stack {listing_down}{where}, {up[-1]} on top and {up[0]} at the very bottom",
            f"build a stack{where} that reads from top to bottom {listing_down}",
            f"stack these{where} in order, starting at the bottom: {listing_up}",
            f"pile up{where} {listing_up}, in this order from the bottom",
            f"i want a tower{where}; from the top: {listing_down}",
            f"make a tower{where}. top: {up[-1]}, below it {', below that '.join(down[1:])}",
            f"stack them{where}, listed from top to bottom: {listing_down}",
            *(
                (
                    f"put {up[1]} on {up[0]} and then "
                    + " and then ".join(
                        f"{a} on {b}" for a, b in zip(up[2:], up[1:], strict=False)
                    ),
                )
                if not ground
                else (
                    f"put {up[0]}{where}, then "
                    + ", then ".join(f"{a} on {b}" for a, b in zip(up[1:], up, strict=False)),
                )
            ),
            *(
                (f"put {', '.join(f'{a} on {b}' for a, b in itertools.pairwise(down))}",)
                if not ground
                else ()
            ),
            *(
                (f"stack {' on top of '.join(down)}", f"{' on '.join(down)}")
                if not ground
                else (f"put {' on '.join(down)}, all of it{where}",)
            ),
        )
    )
    return answer(say.dress(sentence), _pile(pile, ground))


def _by_size(say: Speaker, scene: Setting) -> Answered | None:
    order = ("large", "medium", "small")
    nouns = sorted({item.noun for item in scene.things if not item.kind})
    noun = say.rng.choice(nouns)
    items = [item for item in scene.things if item.noun == noun]
    if len({item.properties["size"] for item in items}) != len(items) or len(items) < 2:
        return None
    pile = sorted(items, key=lambda item: order.index(item.properties["size"]))
    many = plural(noun)
    sentence = say.choose(
        (
            f"stack the {many} from largest to smallest",
            f"build a tower of the {many} with the biggest at the bottom",
            f"pile up the {many}, smallest on top",
            f"stack the {many} by size, the large one at the bottom",
        )
    )
    return answer(say.dress(sentence), _pile(pile, None))


def _pile(pile: list[Item], ground: Item | None) -> list[Step]:
    order = [*([ground] if ground else []), *pile]
    steps: list[Step] = [
        (PUT, upper.name, lower.name) for lower, upper in itertools.pairwise(order)
    ]
    return (
        [("#", f"from the bottom: {', '.join(item.name for item in order)}"), *steps]
        if len(order) > 2
        else steps
    )


def _listing(texts: list[str]) -> str:
    return f"{', '.join(texts[:-1])} and {texts[-1]}" if len(texts) > 2 else " and ".join(texts)
