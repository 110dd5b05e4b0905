"""Attempt: one task planned, carried out by the perfect executor and, if asked for, in physics."""

import hashlib
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

from app.domain.errors import (
    CompletionFailed,
    ModelError,
    ModelUnavailable,
    ProgramRefused,
    TaskDeclined,
)
from app.domain.instruction import Instruction
from app.domain.llm import Completion, LanguageModel
from app.domain.plan import Plan
from app.domain.planner import Planner, Report, Task, Turn
from app.domain.scene import Scene
from app.domain.trace import ActionFailed, CallSkipped, ExecutionEvent
from app.domain.world import World
from app.evaluation.judging import Judged, Witness, is_certain, movable, without_goal
from app.evaluation.mistakes import mistakes
from app.evaluation.results import Cell, Result, Status
from app.evaluation.tasks import ENGLISH, SuiteTask
from app.execution.assertion import state_check
from app.planners import planners
from app.rollout import Planned, offered, plan_task
from app.worlds import worlds

OpenModel = Callable[[str, str], LanguageModel]
"""The model of a name; ``default`` is the second argument, the planner's own choice."""


@dataclass(frozen=True, kw_only=True)
class Unit:
    """One attempt that is to be made."""

    task: SuiteTask
    cell: Cell
    run: int = 0
    language: str = ENGLISH
    physics: bool = False

    @cached_property
    def key(self) -> str:
        """What the attempt is stored under.

        A digest stands for whatever the names do not tell: with other switches, another model or
        another scene under the same name, it is another attempt.
        """
        told = repr((self.cell.options, self.task, self.physics))
        digest = hashlib.sha256(told.encode()).hexdigest()[:8]
        return f"{self.cell.name} | {self.task.name} | {self.language} | {self.run} | {digest}"

    @property
    def start(self) -> str:
        """What the beginning of the prompt depends on: the method and the environment."""
        return f"{self.cell.name} | {self.task.environment}"

    @property
    def seed(self) -> int:
        """Of the decoding and of the world's chances; the layout has the task's own."""
        return self.cell.options.seed + self.run


def attempt(unit: Unit, open_model: OpenModel, report: Report = lambda _: False) -> Result:
    """Plan the task, carry it out and judge it; what goes wrong is part of the result.

    Raises:
        ModelUnavailable: there is no model to ask.
        Cancelled: ``report`` asked for it.
    """
    planner = planners[unit.cell.options.name]
    model = open_model(unit.cell.options.model, planner.model)
    told = _Planning(unit, planner, model, report)
    world = worlds[unit.task.scene.world]
    scene = world.complete(unit.task.scene, unit.task.seed)
    perfect = world.open_perfect(scene, unit.task.seed)
    allowed = movable(unit.task, perfect)
    plan = told.carry_out(perfect, allowed, _from_facts)
    physics = None
    if unit.physics and not is_certain(perfect):
        again = _Planning(unit, planner, model, report, first=told.first)
        physics = again.carry_out(world.open(scene, unit.seed), allowed, _from_physics)
    return replace(
        given_up(unit, told.reason),
        model=model.name,
        status=told.status,
        program=told.program,
        tries=told.tries,
        seconds=sum(each.seconds for each in told.completions),
        prompt_tokens=sum(each.prompt_tokens for each in told.completions),
        completion_tokens=sum(each.completion_tokens for each in told.completions),
        plan=plan,
        physics=physics,
        symbolic=is_certain(perfect),
        mistakes=mistakes(unit.task, told.status, plan, physics),
    )


def given_up(unit: Unit, reason: str) -> Result:
    """The result of an attempt that could not be made."""
    nothing = Judged(scores={"sr": 0.0, "gcr": 0.0}, strict=False, success=False)
    task = unit.task
    return Result(
        key=unit.key,
        task=task.name,
        language=unit.language,
        category=task.category,
        split=task.split,
        environment=task.environment,
        instruction=task.spoken(unit.language),
        steps=task.steps,
        impossible=not task.goal,
        cell=unit.cell.name,
        planner=unit.cell.options.name,
        model=unit.cell.options.model,
        run=unit.run,
        seed=unit.seed,
        status="failed",
        reason=reason,
        plan=nothing,
        mistakes=mistakes(task, "failed", nothing),
    )


class _Planning:
    """Plans, and plans again where the execution failed, and remembers what came of it."""

    def __init__(
        self,
        unit: Unit,
        planner: Planner,
        model: LanguageModel,
        report: Report,
        *,
        first: Planned | None = None,
    ) -> None:
        self._unit = unit
        self._planner = planner
        self._model = model
        self._report = report
        self.first = first
        self.status: Status = "planned"
        self.reason = ""
        self.program = ""
        self.tries = 0
        self.completions: list[Completion] = []

    def carry_out(self, world: World, allowed: frozenset[str], rehearsal: "Rehearsal") -> Judged:
        """Have programs written and run until one goes through, and judge what came of them all."""
        decider = state_check(self._unit.cell.options.state_check, self._model)
        witness = Witness(self._unit.task, world, allowed, decider)
        failed: Turn | None = None
        events: list[ExecutionEvent] = []
        for _ in range(self._unit.cell.options.max_replans + 1):
            planned = self._planned(world, failed, rehearsal)
            if planned is None:
                break
            try:
                events = witness.carry_out(planned.plan)
            except CompletionFailed as error:  # the model was to decide an assertion
                self.reason = str(error)
                break
            failed = _turn(self._unit, planned, events)
            if failed is None:
                break
        if not events:
            events = witness.carry_out(Plan())
        judged = witness.judged(events)
        return without_goal(judged) if self.status == "failed" else judged

    def _planned(self, world: World, failed: Turn | None, rehearsal: "Rehearsal") -> Planned | None:
        """The next program, or None where none came; then the status says why."""
        if failed is None and self.first is not None:
            return self.first
        try:
            planned = self._ask(world, failed, rehearsal)
        except TaskDeclined as declined:
            self._none("declined", declined.reason, declined)
            return None
        except ModelUnavailable:
            raise
        except (ModelError, ProgramRefused) as error:
            self._none("failed", str(error), error)
            return None
        self.tries += 1
        self.completions.append(planned.draft.completion)
        if failed is None:
            self.first, self.program = planned, planned.text
        else:
            self.program += "\n" + planned.text
        return planned

    def _none(self, status: Status, reason: str, error: Exception) -> None:
        completion = getattr(error, "completion", None)
        if isinstance(completion, Completion):
            self.completions.append(completion)
        if self.tries == 0:
            self.status, self.program = status, completion.text if completion else ""
        self.reason = reason
        self.tries += 1

    def _ask(self, world: World, failed: Turn | None, rehearsal: "Rehearsal") -> Planned:
        unit, scene = self._unit, world.scene
        options = unit.cell.options
        description = worlds[scene.world]
        task = Task(
            scene=scene,
            actions=offered(description, scene),
            instruction=Instruction(unit.task.spoken(unit.language)),
            options=replace(options, seed=unit.seed),
            facts=world.facts(),
            failed=failed,
        )
        state = world.save()
        return plan_task(
            task,
            self._planner,
            self._model,
            lambda: rehearsal(scene, unit.task.seed, state),
            self._report,
        )


Rehearsal = Callable[[Scene, int, bytes], World]
"""Opens a perfect executor that stands where a saved world did."""


def _from_facts(scene: Scene, seed: int, state: bytes) -> World:
    world = worlds[scene.world].open_perfect(scene, seed)
    world.restore(state)
    return world


def _from_physics(scene: Scene, seed: int, state: bytes) -> World:
    return worlds[scene.world].open_perfect(scene, seed, state)


def _turn(unit: Unit, planned: Planned, events: list[ExecutionEvent]) -> Turn | None:
    """What the planner may learn of a failed try, never the goal; None where no step failed."""
    failures = [event for event in events if isinstance(event, ActionFailed | CallSkipped)]
    if not failures:
        return None
    return Turn(
        instruction=unit.task.spoken(unit.language),
        program=planned.text,
        outcome="; ".join(f"line {event.line}: {event.reason}" for event in failures),
    )
