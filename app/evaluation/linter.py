"""Linter: what is wrong with a task's goal, before anybody is measured by it."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Literal

from app.domain.condition import Relation, decide, relations
from app.domain.errors import ProgPromptError
from app.domain.goal import Goal
from app.domain.plan import RejectedCall
from app.domain.scene import SceneObject
from app.domain.trace import ActionFailed, ExecutionEvent
from app.domain.world import World
from app.evaluation.judging import ATTENDANT
from app.evaluation.tasks import SuiteTask
from app.programs.conditions import parse_condition, parse_goal, print_condition
from app.rollout import carry_out, collect, understand
from app.worlds import worlds

Code = Literal[
    "refused", "already true", "proximity only", "unreachable", "not reached", "undone", "no goal"
]
PROXIMITY = frozenset({"near", "close", "facing", "left_of", "right_of"})
"""Relations that standing in the right place brings about."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Finding:
    """One thing that is wrong with a task."""

    task: str
    code: Code
    message: str


def lint(tasks: Iterable[SuiteTask]) -> list[Finding]:
    """Everything found, task by task."""
    return [finding for task in tasks for finding in _lint(task)]


def _lint(task: SuiteTask) -> list[Finding]:
    if not task.goal:
        if task.decline:
            return []
        return [_finding(task, "no goal", "has no goal, and does not say why it cannot be done")]
    try:
        description = worlds[task.scene.world]
        scene = description.complete(task.scene, task.seed)
        known = replace(scene, objects=(*scene.objects, *map(_named, ATTENDANT - {*scene.names})))
        parse_goal((*task.goal, *task.order, *task.always), known, description.relations)
        world = description.open_perfect(scene, task.seed)
    except ProgPromptError as error:
        return [_finding(task, "refused", str(error))]
    found = [*_at_start(task, world), *_of_proximity(task), *_in_the_end(task, world)]
    return found


def _at_start(task: SuiteTask, world: World) -> list[Finding]:
    true = [text for text in task.goal if _holds(text, world)]
    if not true:
        return []
    every = "every condition is" if len(true) == len(task.goal) else f"{', '.join(true)} is"
    return [_finding(task, "already true", f"{every} true before anything is done")]


def _of_proximity(task: SuiteTask) -> list[Finding]:
    names = {relation.name for each in task.conditions for relation in relations(each)}
    if names <= PROXIMITY:
        return [_finding(task, "proximity only", "standing near things is enough to reach it")]
    return []


def _in_the_end(task: SuiteTask, world: World) -> list[Finding]:
    """Whether the verbs can bring the goal about: by the ground truth, or by any single call."""
    description = worlds[task.scene.world]
    if not task.truth:
        return _by_single_calls(task, world)
    try:
        _, plan = understand(task.program, world.scene, description)
    except ProgPromptError as error:
        return [_finding(task, "not reached", f"the ground truth cannot be read: {error}")]
    events: list[ExecutionEvent] = []
    carry_out(plan, Goal(), world, collect(events))
    failed = [step.reason for step in plan.steps if isinstance(step, RejectedCall)]
    failed += [event.reason for event in events if isinstance(event, ActionFailed)]
    if failed:
        return [_finding(task, "not reached", f"the ground truth fails: {'; '.join(failed)}")]
    unmet = [text for text in task.goal if not _holds(text, world)]
    if unmet:
        message = f"the ground truth does not bring about {', '.join(unmet)}"
        return [_finding(task, "not reached", message)]
    return []


def _by_single_calls(task: SuiteTask, world: World) -> list[Finding]:
    """Without a ground truth: relations that none of the world's actions ever changes."""
    known = {fact.name for fact in world.facts()} | {"in", "on", "held"}
    never = [
        print_condition(relation)
        for condition in task.conditions
        for relation in relations(condition)
        if relation.name not in known and not world.holds(relation)
    ]
    if never:
        message = f"no action on offer brings about {', '.join(never)}"
        return [_finding(task, "unreachable", message)]
    return []


def _holds(text: str, world: World) -> bool:
    condition = parse_condition(text)
    if isinstance(condition, Relation):
        return world.holds(condition)
    return decide(condition, world.holds)


def _named(name: str) -> SceneObject:
    return SceneObject(name=name)


def _finding(task: SuiteTask, code: Code, message: str) -> Finding:
    return Finding(task=task.name, code=code, message=message)
