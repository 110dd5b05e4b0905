"""Verb benchmark: one verb on random tables."""

import math
import statistics
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from app.domain.errors import ActionFailure
from app.domain.perception import Perception
from app.domain.program import Argument
from app.evaluation.intervals import wilson
from app.evaluation.verb_cases import Case, draw_case
from app.worlds.actions.tabletop.push import DIRECTIONS
from app.worlds.tabletop import DEFAULT_PERCEPTION, Tabletop, TabletopWorld

CLOSE = 0.05
"""An object that was put at a place is so close to it in the end [m]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class VerbTrial:
    """One call on one table."""

    call: str
    seed: int
    failure: str | None
    """Stage and reason, or what did not hold in the end; None if it succeeded."""
    attempts: int
    cpu_seconds: float
    """Of perceiving, planning and simulating the call, without building the scene [s]."""
    sim_seconds: float


@dataclass(frozen=True, slots=True, kw_only=True)
class VerbReport:
    """What came of all layouts. Rates are in [0, 1], their intervals Wilson's at 95 %."""

    verb: str
    layouts: int
    seed: int
    successes: int
    success: float
    success_interval: tuple[float, float]
    first_attempt: float
    cpu_seconds_median: float
    sim_seconds_median: float
    failures: dict[str, int]
    failed: tuple[VerbTrial, ...]


def bench_verb(
    verb: str,
    layouts: int,
    seed: int,
    *,
    perception: Perception = DEFAULT_PERCEPTION,
    on_trial: Callable[[VerbTrial], None] = lambda _: None,
) -> VerbReport:
    """Run the benchmark; the same seed, the same layouts with the same results.

    Args:
        verb: one of ``verb_cases.CASES``.
        layouts: how many; layout k depends on the seed and on k alone.
        seed: of everything that is drawn.
        perception: how the robot sees.
        on_trial: told each result as it comes in.
    """
    trials: list[VerbTrial] = []
    for index in range(layouts):
        trials.append(run_trial(verb, seed, index, perception))
        on_trial(trials[-1])
    succeeded = [trial for trial in trials if trial.failure is None]
    return VerbReport(
        verb=verb,
        layouts=layouts,
        seed=seed,
        successes=len(succeeded),
        success=len(succeeded) / max(1, layouts),
        success_interval=wilson(len(succeeded), layouts),
        first_attempt=sum(trial.attempts == 1 for trial in succeeded) / max(1, layouts),
        cpu_seconds_median=statistics.median([trial.cpu_seconds for trial in trials] or [0.0]),
        sim_seconds_median=statistics.median([trial.sim_seconds for trial in trials] or [0.0]),
        failures=dict(Counter(trial.failure for trial in trials if trial.failure is not None)),
        failed=tuple(trial for trial in trials if trial.failure is not None),
    )


def run_trial(
    verb: str, seed: int, index: int, perception: Perception = DEFAULT_PERCEPTION
) -> VerbTrial:
    """The layout of (seed, index)."""
    case = draw_case(verb, np.random.default_rng((seed, index)))
    world = Tabletop().open(case.scene, case.seed, perception)
    if case.toppled is not None:
        _topple(world, str(case.arguments[0]), case.toppled)
    attempts, failure, started, began = 1, None, time.process_time(), world.time
    try:
        for action, arguments in case.before:
            _perform(world, action, arguments)
        started, began = time.process_time(), world.time
        attempts = _perform(world, verb, case.arguments)
    except ActionFailure as error:
        failure = str(error)
    cpu_seconds = time.process_time() - started
    return VerbTrial(
        call=f"{verb}({', '.join(map(str, case.arguments))})",
        seed=case.seed,
        failure=failure or _missing(case, world),
        attempts=attempts,
        cpu_seconds=cpu_seconds,
        sim_seconds=world.time - began,
    )


def _topple(world: TabletopWorld, name: str, bearing: float) -> None:
    """Lay an object on its side with its top pointing in a direction [rad]."""
    physics, body = world.physics, world.physics.bodies[name]
    x, y = world.place(name)
    turn = np.array([np.sqrt(0.5), -np.sin(bearing), np.cos(bearing), 0.0])
    turn[1:3] *= np.sqrt(0.5)
    along = np.array([np.cos(bearing), np.sin(bearing)]) * body.height / 2
    place = (x - along[0], y - along[1], body.footprint_radius / np.sqrt(2) + 0.002)
    physics.data.qpos[body.qpos_address : body.qpos_address + 7] = (*place, *turn)
    world.settle()


def _perform(world: TabletopWorld, action: str, arguments: tuple[Argument, ...]) -> int:
    """Carry out one call; how many attempts it took."""
    return max([stage.attempt for stage in world.perform(action, arguments)] or [1])


def _missing(case: Case, world: TabletopWorld) -> str | None:
    """What should be true, and is not."""
    if not any(relation.name == "held" for relation in case.wanted):
        world.settle()
        held = [str(fact) for fact in world.facts() if fact.name == "held"]
        if held:
            return f"in the end, {held[0]}"
    for relation in case.wanted:
        if not world.holds(relation):
            return f"in the end, not {relation.name}"
    return _misplaced(case, world)


def _misplaced(case: Case, world: TabletopWorld) -> str | None:
    """How the first object is not where it should be."""
    if case.place is not None:
        x, y = world.place(str(case.arguments[0]))
        away = math.hypot(x - case.place[0], y - case.place[1])
        if away > CLOSE:
            return f"in the end, {away:.2f} m away"
    if case.beyond is not None:
        item, direction = (str(argument) for argument in case.arguments)
        short = (np.array(case.beyond) - world.place(item)) @ DIRECTIONS[direction]
        if short > 0:
            return "in the end, pushed too little"
    return None
