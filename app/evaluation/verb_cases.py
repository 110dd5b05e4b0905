"""Cases for measuring verbs: random tables on which one call of a verb must succeed."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from app.domain.condition import Relation
from app.domain.errors import SceneRefused
from app.domain.program import Argument
from app.domain.scene import Scene, SceneObject
from app.worlds import worlds
from app.worlds.actions.aims import TOWARDS
from app.worlds.actions.tabletop.push import DIRECTIONS, DISTANCE
from app.worlds.simulators.mujoco.placement import REACH

DISTRACTORS = 2
FLAT_TOPS = ("block", "book", "cracker_box", "can", "neutral")
"""Kinds another object can be stacked on."""
FURNITURE = ("drawer", "hinged_box", "door_cabinet")
BESIDE = 0.13
"""The place so far beside a reference is within reach [m]."""
TALL = ("can", "bottle", "cup", "candle", "battery", "salt_shaker")
"""Kinds that may lie on their side."""
STACKED = ("block", "can", "cup", "neutral")
SUPPORTS = ("book", "plate", "tray", "cracker_box")
POURED_INTO = ("bowl", "box", "basket")
WIPED = ("plate", "tray", "book", "cracker_box")
SMALLEST_CONTAINER = 0.14
"""Narrower ones, mugs and cups, take only some objects [m]."""
Rng = np.random.Generator
Draw = Callable[[Rng], "Case"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Case:
    """One call on one table."""

    scene: Scene
    seed: int
    arguments: tuple[Argument, ...]
    before: tuple[tuple[str, tuple[Argument, ...]], ...] = ()
    """Calls that must have been made before it."""
    wanted: tuple[Relation, ...]
    """What must hold afterwards."""
    place: tuple[float, float] | None = None
    """Where the first object must then be [m], if anywhere."""
    toppled: float | None = None
    """Before it, the first object is laid on its side, its top in this direction [rad]."""
    beyond: tuple[float, float] | None = None
    """Which line, across the way it was pushed, the first object must have passed [m]."""


def _items(*, container: bool = False) -> list[str]:
    return [kind.name for kind in worlds["tabletop"].catalogue() if kind.container == container]


def _wide() -> list[str]:
    kinds = worlds["tabletop"].catalogue()
    return [k.name for k in kinds if k.container and min(k.size[:2]) >= SMALLEST_CONTAINER]


def _table(rng: Rng, *kinds: str, spare: int = DISTRACTORS) -> tuple[Scene, int, tuple[str, ...]]:
    """A table with one object of each kind, then distractors; its seed and the objects' names.

    Raises:
        SceneRefused: they do not fit.
    """
    names = [
        f"{kind} {index}" if kinds.count(kind) > 1 else kind for index, kind in enumerate(kinds)
    ]
    others = [name for name in _items() if name not in kinds]
    drawn = rng.choice(others, spare, replace=False).tolist()
    objects = tuple(
        SceneObject(name=name, kind=kind, properties=(("state", "open"),))
        for name, kind in zip([*names, *drawn], [*kinds, *drawn], strict=True)
    )
    scene = Scene(world="tabletop", objects=objects, actions=EVERY)
    seed = int(rng.integers(2**31))
    return worlds["tabletop"].complete(scene, seed), seed, tuple(names)


EVERY = tuple(action.name for action in worlds["tabletop"].actions)


def _pick(rng: Rng) -> Case:
    scene, seed, (item,) = _table(rng, str(rng.choice(_items())), spare=3)
    return Case(scene=scene, seed=seed, arguments=(item,), wanted=(Relation("held", (item,)),))


def _handover(rng: Rng) -> Case:
    scene, seed, (item,) = _table(rng, str(rng.choice(_items())), spare=3)
    wanted = (Relation("handed_over", (item,)),)
    return Case(scene=scene, seed=seed, arguments=(item,), wanted=wanted)


def _home(rng: Rng) -> Case:
    scene, seed, (item,) = _table(rng, str(rng.choice(_items())), spare=3)
    return Case(scene=scene, seed=seed, arguments=(), before=(("pick", (item,)),), wanted=())


def _onto(items: Callable[[], list[str]], targets: Callable[[], list[str]], relation: str) -> Draw:
    def draw(rng: Rng) -> Case:
        kinds = str(rng.choice(items())), str(rng.choice(targets()))
        scene, seed, (item, target) = _table(rng, *kinds)
        wanted = (Relation(relation, (item, target)),)
        return Case(scene=scene, seed=seed, arguments=(item, target), wanted=wanted)

    return draw


def _beside(side: str) -> Draw:
    def draw(rng: Rng) -> Case:
        kinds = str(rng.choice(_items())), str(rng.choice(_items(container=bool(rng.integers(2)))))
        scene, seed, (item, reference) = _table(rng, *kinds)
        there = np.array(scene.objects[1].position)[:2] + BESIDE * TOWARDS[side]
        if not REACH[0] < float(np.hypot(*there)) < REACH[1]:
            return draw(rng)
        wanted = tuple(Relation(name, (item, reference)) for name in (side, "near"))
        return Case(scene=scene, seed=seed, arguments=(item, reference), wanted=wanted)

    return draw


def _at(rng: Rng) -> Case:
    """To a place that is free: one where another such object would have stood."""
    kind = str(rng.choice(_items()))
    scene, seed, (item, spare) = _table(rng, kind, kind, spare=3)
    (x, y, _), scene = _without(scene, spare)
    return Case(scene=scene, seed=seed, arguments=(item, x, y), wanted=(), place=(x, y))


def _pour(rng: Rng) -> Case:
    """A cup of beads, and something wider to pour them into."""
    scene, seed, (source, target) = _table(rng, "cup", str(rng.choice(POURED_INTO)))
    filled = replace(scene.objects[0], properties=(("contents", "beads"),))
    scene = replace(scene, objects=(filled, *scene.objects[1:]))
    wanted = (Relation("poured", (source, target)), Relation("upright", (source,)))
    return Case(scene=scene, seed=seed, arguments=(source, target), wanted=wanted)


def _wipe(rng: Rng) -> Case:
    """Something with a level top, and a sponge, which must be put back."""
    scene, seed, (item, tool) = _table(rng, str(rng.choice(WIPED)), "sponge")
    wanted = (Relation("wiped", (item,)), Relation("upright", (item,)))
    return Case(scene=scene, seed=seed, arguments=(item, tool), wanted=wanted)


def _push(rng: Rng) -> Case:
    """In a direction in which there is room."""
    while True:
        scene, seed, (item,) = _table(rng, str(rng.choice(_items())))
        word = str(rng.choice(list(DIRECTIONS)))
        start = np.array(scene.objects[0].position)[:2]
        end = start + DISTANCE * DIRECTIONS[word]
        others = [np.array(other.position)[:2] for other in scene.objects[1:]]
        apart = min(float(np.linalg.norm(end - other)) for other in others)
        if REACH[0] + 0.02 < float(np.hypot(*end)) < REACH[1] - 0.02 and apart > 0.16:
            least = end - 0.6 * DISTANCE * DIRECTIONS[word]
            return Case(
                scene=scene,
                seed=seed,
                arguments=(item, word),
                wanted=(Relation("upright", (item,)),) if item in TALL else (),
                beyond=tuple(least),
            )


def _shutting(relation: str) -> Draw:
    """A drawer, a box with a lid or a cabinet that is not yet so."""
    state = {"open": "closed", "closed": "open"}[relation]

    def draw(rng: Rng) -> Case:
        scene, seed, (item,) = _table(rng, str(rng.choice(FURNITURE)))
        first = replace(scene.objects[0], properties=(("state", state),))
        scene = replace(scene, objects=(first, *scene.objects[1:]))
        wanted = (Relation(relation, (item,)),)
        return Case(scene=scene, seed=seed, arguments=(item,), wanted=wanted)

    return draw


def _upright(rng: Rng) -> Case:
    """Something tall that was toppled before the call."""
    scene, seed, (item,) = _table(rng, str(rng.choice(TALL)))
    wanted = (Relation("upright", (item,)),)
    turn = float(rng.uniform(-np.pi, np.pi))
    return Case(scene=scene, seed=seed, arguments=(item,), wanted=wanted, toppled=turn)


def _without(scene: Scene, name: str) -> tuple[tuple[float, float, float], Scene]:
    (gone,) = [item for item in scene.objects if item.name == name]
    assert gone.position is not None
    kept = tuple(item for item in scene.objects if item.name != name)
    return gone.position, replace(scene, objects=kept)


CASES: dict[str, Callable[[Rng], Case]] = {
    "pick": _pick,
    "home": _home,
    "handover": _handover,
    "place_on": _onto(
        lambda: ["block", "can", "cup", "lime", "sponge"], lambda: list(SUPPORTS), "on"
    ),
    "place_in": _onto(_items, _wide, "in"),
    "stack": _onto(lambda: list(STACKED), lambda: list(FLAT_TOPS), "on"),
    "grab_and_putin": _onto(_items, _wide, "in"),
    "place_at": _at,
    "pour": _pour,
    "push": _push,
    "wipe": _wipe,
    "upright": _upright,
    "open": _shutting("open"),
    "close": _shutting("closed"),
    **{f"place_{side}": _beside(side) for side in ("left_of", "right_of", "in_front_of", "behind")},
}


def draw_case(verb: str, rng: Rng) -> Case:
    """A case of the verb whose objects fit on the table."""
    while True:
        try:
            return CASES[verb](rng)
        except SceneRefused:  # no room for all of them: drawn again
            continue
