"""Readiness: how long it takes until a scene stands ready for its first action."""

import statistics
import time
from dataclasses import dataclass

import numpy as np

from app.domain.errors import SceneRefused
from app.domain.scene import Scene, SceneObject
from app.worlds.tabletop import Tabletop

TABLETOP = Tabletop()


@dataclass(frozen=True, slots=True, kw_only=True)
class ReadyReport:
    """Seconds of CPU from names to a settled scene."""

    objects: int
    scenes: int
    first_seconds: float
    """Of the first scene in a fresh process, which reads the arm's files [s]."""
    median_seconds: float
    slowest_seconds: float


def bench_scene(objects: int, scenes: int, seed: int) -> ReadyReport:
    """Open random scenes.

    Args:
        objects: how many are in each.
        scenes: how many are opened; scene k depends on the seed and on k alone.
        seed: of everything that is drawn.
    """
    seconds: list[float] = []
    for index in range(scenes):
        scene = _draw_scene(objects, np.random.default_rng((seed, index)), seed)
        started = time.process_time()
        TABLETOP.open(scene, seed)
        seconds.append(time.process_time() - started)
    return ReadyReport(
        objects=objects,
        scenes=scenes,
        first_seconds=seconds[0],
        median_seconds=statistics.median(seconds),
        slowest_seconds=max(seconds[1:], default=seconds[0]),
    )


def _draw_scene(objects: int, rng: np.random.Generator, seed: int) -> Scene:
    """Objects of different kinds, as many of which are containers as find room."""
    kinds = [kind.name for kind in TABLETOP.catalogue()]
    while True:
        names = rng.choice(kinds, min(objects, len(kinds)), replace=False).tolist()
        chosen = tuple(SceneObject(name=name, kind=name) for name in names)
        scene = Scene(world="tabletop", objects=chosen)
        try:
            TABLETOP.complete(scene, seed)
        except SceneRefused:  # no room for all of them: drawn again
            continue
        return scene
