"""Scaling: how many pick-and-places a second more worker processes give."""

import multiprocessing
import os
import time
from dataclasses import dataclass
from functools import partial
from multiprocessing.synchronize import Barrier

from app.domain.perception import Perception
from app.evaluation.pick import CAMERAS, run_episode
from app.evaluation.processes import processes

WARM_UP = 1
"""Episodes run by each process before the clock starts: modules are loaded, models cached."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ScalingRow:
    """What so many workers did."""

    workers: int
    episodes: int
    wall_seconds: float
    episodes_per_second: float
    speedup: float
    """Over one worker."""
    efficiency: float
    """Speed-up per worker, but never for more workers than there are cores."""
    realtime_factor: float
    """Simulated seconds per second of wall time, over all workers."""


def bench_parallel(
    episodes: int, seed: int, most_workers: int, perception: Perception = CAMERAS
) -> list[ScalingRow]:
    """The same episodes over 1, 2, 4 … worker processes.

    Args:
        episodes: how many of ``bench pick``.
        seed: of everything that is drawn.
        most_workers: the last row's number of processes.
        perception: what the robot is told of the objects.
    """
    counts = [count for count in (1, 2, 4, 8, 16, 32, 64) if count < most_workers] + [most_workers]
    rows: list[ScalingRow] = []
    for workers in counts:
        wall, simulated = _timed(episodes, seed, workers, perception)
        alone = rows[0].wall_seconds if rows else wall
        rows.append(
            ScalingRow(
                workers=workers,
                episodes=episodes,
                wall_seconds=wall,
                episodes_per_second=episodes / wall,
                speedup=alone / wall,
                efficiency=alone / wall / min(workers, os.cpu_count() or 1),
                realtime_factor=simulated / wall,
            )
        )
    return rows


def _timed(episodes: int, seed: int, workers: int, perception: Perception) -> tuple[float, float]:
    """Wall time and simulated time of all episodes [s]."""
    start = multiprocessing.get_context("spawn").Barrier(workers + 1)
    with processes(workers, partial(_warm_up, start)) as pool:
        tasks = [(seed, index) for index in range(episodes)]
        running = [pool.submit(run_episode, task, perception=perception) for task in tasks]
        start.wait()
        started = time.perf_counter()
        simulated = sum(future.result().sim_seconds for future in running)
        return time.perf_counter() - started, simulated


def _warm_up(start: Barrier) -> None:
    for index in range(WARM_UP):
        run_episode((0, index))
    start.wait()
