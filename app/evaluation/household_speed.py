"""How fast the household is: one action, and a whole plan with its assertions, without any model."""

import statistics
import time
from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass

from app.domain.errors import ActionFailure
from app.domain.goal import Goal
from app.domain.plan import GroundedAssertion, GroundedCall, Plan
from app.domain.scene import Scene
from app.execution.interpreter import execute
from app.programs.examples import load_examples
from app.programs.grounding import ground
from app.worlds import worlds

WORLD = "household"
ENVIRONMENTS = ("env0", "env1", "env2")
LONG = 12
"""Steps from which on a plan is a long one: calls and assertions."""
TIMES = 5
"""Every plan is carried out so often, each time from the beginning."""


@dataclass(frozen=True, slots=True, kw_only=True)
class HouseholdSpeed:
    """Medians and 95 % quantiles of wall time."""

    actions: int
    action_seconds: tuple[float, float]
    """Of one action [s]."""
    plans: int
    steps: float
    """Calls and assertions of a plan, median."""
    plan_seconds: tuple[float, float]
    """Of a plan of ``LONG`` steps and more, from its first event to its last [s]."""


def bench_household() -> HouseholdSpeed:
    """Carry out the example programs in every home that has what they name."""
    actions: list[float] = []
    plans: list[float] = []
    steps: list[int] = []
    for plan, scene in _plans():
        count = sum(isinstance(each, GroundedCall | GroundedAssertion) for each in plan.steps)
        for _ in range(TIMES):
            actions += _timed_actions(plan, scene)
            world = worlds[WORLD].open_perfect(scene, 0)
            started = time.perf_counter()
            deque(execute(plan, world, goal=Goal()), maxlen=0)
            if count >= LONG:
                plans.append(time.perf_counter() - started)
                steps.append(count)
    return HouseholdSpeed(
        actions=len(actions),
        action_seconds=_spread(actions),
        plans=len(plans),
        steps=statistics.median(steps),
        plan_seconds=_spread(plans),
    )


def _plans() -> Iterator[tuple[Plan, Scene]]:
    world = worlds[WORLD]
    for environment in ENVIRONMENTS:
        scene = world.complete(Scene(world=WORLD, environment=environment), 0)
        for program in load_examples(WORLD):
            plan = ground(program, scene, world.actions, world.relations)
            if not plan.rejected:
                yield plan, scene


def _timed_actions(plan: Plan, scene: Scene) -> Iterator[float]:
    world = worlds[WORLD].open_perfect(scene, 0)
    for step in plan.steps:
        if not isinstance(step, GroundedCall):
            continue
        started = time.perf_counter()
        try:
            deque(world.perform(step.action, step.arguments), maxlen=0)
        except ActionFailure:
            continue  # Without its assertions, a plan may lack a precondition.
        yield time.perf_counter() - started


def _spread(seconds: list[float]) -> tuple[float, float]:
    return statistics.median(seconds), statistics.quantiles(seconds, n=20)[-1]
