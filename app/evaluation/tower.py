"""Tower benchmark: five blocks from random places stacked on one another."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.domain.perception import Perception
from app.domain.scene import Scene, SceneObject
from app.evaluation.intervals import wilson
from app.worlds.tabletop import DEFAULT_PERCEPTION, Tabletop

BLOCKS = 5


@dataclass(frozen=True, slots=True, kw_only=True)
class Tower:
    """One tower."""

    seed: int
    height: int
    """How many blocks stand on one another in the end."""
    failure: str | None
    cpu_seconds: float
    sim_seconds: float


@dataclass(frozen=True, slots=True, kw_only=True)
class TowerReport:
    """What came of all of them; rates in [0, 1], the interval Wilson's at 95 %."""

    towers: int
    blocks: int
    success: float
    success_interval: tuple[float, float]
    mean_height: float
    failed: tuple[Tower, ...]


def bench_tower(
    towers: int,
    seed: int,
    *,
    perception: Perception = DEFAULT_PERCEPTION,
    on_tower: Callable[[Tower], None] = lambda _: None,
) -> TowerReport:
    """Build towers on layouts ``seed``, ``seed`` + 1 and so on; same seed, same results."""
    built: list[Tower] = []
    for layout in range(seed, seed + towers):
        built.append(build_tower(layout, perception))
        on_tower(built[-1])
    whole = sum(tower.height == BLOCKS for tower in built)
    return TowerReport(
        towers=towers,
        blocks=BLOCKS,
        success=whole / max(1, towers),
        success_interval=wilson(whole, towers),
        mean_height=sum(tower.height for tower in built) / max(1, towers),
        failed=tuple(tower for tower in built if tower.height < BLOCKS),
    )


def build_tower(seed: int, perception: Perception = DEFAULT_PERCEPTION) -> Tower:
    """Stack the blocks of one layout and see how high they stand once all is at rest."""
    names = [f"block {number}" for number in range(1, BLOCKS + 1)]
    objects = tuple(SceneObject(name=name, kind="block") for name in names)
    scene = Scene(world="tabletop", objects=objects, actions=("stack",))
    world = Tabletop().open(scene, seed, perception)
    started, failure = time.process_time(), None
    try:
        for support, item in pairwise(names):
            for _ in world.perform("stack", (item, support)):
                pass
    except ActionFailure as error:
        failure = str(error)
    world.settle()
    height = 1
    while height < BLOCKS and world.holds(Relation("on", (names[height], names[height - 1]))):
        height += 1
    return Tower(
        seed=seed,
        height=height,
        failure=failure,
        cpu_seconds=time.process_time() - started,
        sim_seconds=world.time,
    )
