"""Pick benchmark: random objects from random tables into random containers."""

import statistics
import time
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from app.domain.condition import Relation
from app.domain.errors import ActionFailure, SceneRefused
from app.domain.perception import Perception
from app.domain.scene import Scene, SceneObject
from app.domain.world import ObjectKind
from app.evaluation.intervals import wilson
from app.evaluation.processes import processes
from app.worlds.simulators.mujoco.arms import DEFAULT_ARM
from app.worlds.simulators.mujoco.objects import kinds
from app.worlds.tabletop import Tabletop

TABLETOP = Tabletop()
ACTION = "grab_and_putin"
CAMERAS = Perception()
MOST_DISTRACTORS = 4
SMALLEST_CONTAINER = 0.14
"""Containers narrower than this, mugs and cups, take only some objects and are left out [m]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Episode:
    """One pick on one table."""

    seed: int
    item: str
    container: str
    distractors: int
    failure: str | None
    """Stage and reason, or None if it succeeded; the simulator decides, whatever the robot saw."""
    attempts: int
    cpu_seconds: float
    """Of perceiving, planning and simulating the pick, without building the scene [s]."""
    sim_seconds: float
    ready_seconds: float
    """Of CPU, to build the scene and let it come to rest [s]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PickReport:
    """What came of all episodes. Rates are in [0, 1], their intervals Wilson's at 95 %."""

    episodes: int
    seed: int
    robot: str
    perception: Perception
    success: float
    success_interval: tuple[float, float]
    first_attempt: float
    """Share of the episodes that succeeded at the first attempt."""
    first_attempt_interval: tuple[float, float]
    cpu_seconds_median: float
    sim_seconds_median: float
    ready_seconds_median: float
    realtime_factor: float
    """Simulated seconds per second of CPU, over all picks."""
    failures: dict[str, int]
    """How often each stage and reason ended an episode."""
    failed: tuple[Episode, ...]
    retried: tuple[Episode, ...]
    """Those that succeeded, but not at the first attempt."""


def bench_pick(
    episodes: int,
    seed: int,
    *,
    robot: str | None = None,
    perception: Perception = CAMERAS,
    workers: int = 1,
    on_episode: Callable[[Episode], None] = lambda _: None,
) -> PickReport:
    """Run the benchmark; the same seed, the same episodes with the same results.

    Args:
        episodes: how many; episode k depends on the seed and on k alone.
        seed: of everything that is drawn.
        robot: which arm picks; None for the usual one.
        perception: what the robot is told of the objects.
        workers: processes to spread them over.
        on_episode: told each result as it comes in, in order.
    """
    results: list[Episode] = []
    tasks = [(seed, index) for index in range(episodes)]
    for result in _results(tasks, robot, perception, workers):
        results.append(result)
        on_episode(result)
    return _report(results, seed, robot or DEFAULT_ARM, perception)


def _results(
    tasks: list[tuple[int, int]], robot: str | None, perception: Perception, workers: int
) -> Iterator[Episode]:
    run = partial(run_episode, robot=robot, perception=perception)
    if workers == 1:
        yield from map(run, tasks)
        return
    with processes(workers) as pool:
        yield from pool.map(run, tasks)


def run_episode(
    task: tuple[int, int], robot: str | None = None, perception: Perception = CAMERAS
) -> Episode:
    """The episode of (seed, index)."""
    rng = np.random.default_rng(task)
    scene, seed = _draw_scene(rng)
    scene = replace(scene, robot=robot)
    item, container = scene.names[:2]
    started_cpu = time.process_time()
    world = TABLETOP.open(scene, seed, perception)
    ready = time.process_time() - started_cpu
    started_cpu, started_sim = time.process_time(), world.time
    attempts, failure = 1, None
    try:
        for stage in world.perform(ACTION, (item, container)):
            attempts = max(attempts, stage.attempt)
    except ActionFailure as error:
        failure = str(error)
    cpu, sim = time.process_time() - started_cpu, world.time - started_sim
    if failure is None and not world.holds(Relation("in", (item, container))):
        failure = "unnoticed: the robot takes it to be there, and it is not"
    return Episode(
        seed=seed,
        item=item,
        container=container,
        distractors=len(scene.objects) - 2,
        failure=failure,
        attempts=attempts,
        cpu_seconds=cpu,
        sim_seconds=sim,
        ready_seconds=ready,
    )


def _draw_scene(rng: np.random.Generator) -> tuple[Scene, int]:
    """An object, a container and distractors, all of different kinds, that fit on the table."""
    catalogue = TABLETOP.catalogue()
    items = [kind.name for kind in catalogue if not kind.container]
    containers = [kind.name for kind in catalogue if _is_wide(kind)]
    while True:
        item, container = str(rng.choice(items)), str(rng.choice(containers))
        others = [name for name in items if name != item]
        count = int(rng.integers(1, MOST_DISTRACTORS + 1))
        distractors = rng.choice(others, count, replace=False).tolist()
        names = [item, container, *distractors]
        objects = tuple(SceneObject(name=name, kind=name) for name in names)
        seed = int(rng.integers(2**31))
        scene = Scene(world="tabletop", objects=objects)
        try:
            return TABLETOP.complete(scene, seed), seed
        except SceneRefused:  # no room for all of them: drawn again
            continue


def _is_wide(kind: ObjectKind) -> bool:
    """Whether it is a container that is open wide enough for all items; what has a lid is not."""
    lidded = kinds[kind.name].articulation(kind.size) is not None
    return kind.container and not lidded and min(kind.size[:2]) >= SMALLEST_CONTAINER


def _report(results: list[Episode], seed: int, robot: str, perception: Perception) -> PickReport:
    total = len(results)
    succeeded = [result for result in results if result.failure is None]
    first = [result for result in succeeded if result.attempts == 1]
    cpu = [result.cpu_seconds for result in results]
    sim = [result.sim_seconds for result in results]
    return PickReport(
        episodes=total,
        seed=seed,
        robot=robot,
        perception=perception,
        success=len(succeeded) / max(1, total),
        success_interval=wilson(len(succeeded), total),
        first_attempt=len(first) / max(1, total),
        first_attempt_interval=wilson(len(first), total),
        cpu_seconds_median=statistics.median(cpu) if cpu else 0.0,
        sim_seconds_median=statistics.median(sim) if sim else 0.0,
        ready_seconds_median=statistics.median(r.ready_seconds for r in results)
        if results
        else 0.0,
        realtime_factor=sum(sim) / sum(cpu) if sum(cpu) else 0.0,
        failures=dict(Counter(r.failure for r in results if r.failure is not None)),
        failed=tuple(result for result in results if result.failure is not None),
        retried=tuple(result for result in succeeded if result.attempts > 1),
    )
