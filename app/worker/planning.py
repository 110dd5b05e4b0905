"""Planning: the workflow that turns an instruction into a stored plan."""

import logging
from collections.abc import Callable
from dataclasses import fields
from typing import Any

from app.domain.errors import Cancelled, CompletionFailed, ProgPromptError, Refused
from app.domain.goal import Goal
from app.domain.instruction import Instruction
from app.domain.llm import Completion, LanguageModel
from app.domain.planner import PlannerOptions, Task
from app.domain.trace import PlanningFailed, ProgramGrounded
from app.planners import planners
from app.programs.conditions import parse_condition
from app.rollout import offered, rehearse, understand
from app.storage import plans
from app.storage.base import now
from app.storage.database import Database
from app.storage.documents import plan_columns, read_scene
from app.storage.handover import Handover
from app.storage.plans import PlanRow
from app.worker.planning_recorder import PlanningRecorder
from app.worlds import worlds

MAX_ATTEMPTS = 3
log = logging.getLogger(__name__)


class Planning:
    """What a worker of the planning queue does."""

    def __init__(
        self,
        database: Database,
        handover: Handover,
        open_model: Callable[[str], LanguageModel],
    ) -> None:
        self._database = database
        self._handover = handover
        self._open_model = open_model

    def __call__(self, plan_id: str, /) -> None:
        """Plan, and hand the plan on. Whatever goes wrong ends as a failed plan with its reason."""
        row = self._take(plan_id)
        if row is None:
            return
        recorder = PlanningRecorder(self._database, plan_id)
        try:
            if row.attempts > MAX_ATTEMPTS:
                raise ProgPromptError(
                    f"planning was given up: its worker died {MAX_ATTEMPTS} times"
                )
            self._plan(row, recorder)
        except Cancelled:
            recorder.flush()
            self._end(plan_id, status="cancelled")
        except Exception as error:
            reason = _reason(error)
            recorder.report(PlanningFailed(reason=reason))
            self._end(plan_id, status="failed", error=reason)

    def stopping(self, plan_id: str, /) -> None:
        """The worker stops in good order in the middle of this plan: not the plan's fault."""
        with self._database.transaction() as session:
            plans.change(session, plan_id, when=("planning",), attempts=PlanRow.attempts - 1)

    def _take(self, plan_id: str) -> PlanRow | None:
        with self._database.transaction() as session:
            taken = plans.change(
                session,
                plan_id,
                when=("queued", "planning"),
                status="planning",
                attempts=PlanRow.attempts + 1,
            )
            row = plans.get(session, plan_id)
            row.started_at = row.started_at or now()
        return row if taken else None

    def _plan(self, row: PlanRow, recorder: PlanningRecorder) -> None:
        task = _task(row)
        model = self._open_model(task.options.model)
        planner = planners[task.options.name]
        try:
            draft = planner.write_program(task, model, recorder.report)
        except CompletionFailed as failed:
            self._keep(row.id, failed.prompt, failed.completion)
            raise
        self._keep(row.id, draft.prompt, draft.completion, program=draft.program)
        world = worlds[task.scene.world]
        program, plan = understand(draft.program, task.scene, world)
        recorder.report(ProgramGrounded(steps=len(plan.calls), rejected=len(plan.rejected)))
        goal = Goal(tuple(parse_condition(text) for text in row.goal))
        scores = rehearse(plan, goal, world, task.scene, row.seed) if row.goal else None
        with self._database.transaction() as session:
            found = plans.get(session, row.id, lock=True)
            if found.cancel_requested:
                raise Cancelled
            for name, value in plan_columns(program, plan).items():
                setattr(found, name, value)
            found.plan_scores = scores
            self._handover.planned(session, found)

    def _keep(
        self,
        plan_id: str,
        prompt: str | None,
        completion: Completion | None,
        **values: Any,  # noqa: ANN401 - columns of a plan
    ) -> None:
        """Store what was sent and what came back, whatever it is worth."""
        values["prompt"] = prompt
        if completion is not None:
            values["completion"] = completion.text
            values["usage"] = {
                "model": completion.model,
                "prompt_tokens": completion.prompt_tokens,
                "completion_tokens": completion.completion_tokens,
                "seconds": completion.seconds,
                "finish": completion.finish,
            }
        with self._database.transaction() as session:
            plans.change(session, plan_id, when=("planning",), **values)

    def _end(self, plan_id: str, **values: Any) -> None:  # noqa: ANN401 - columns of a plan
        with self._database.transaction() as session:
            plans.change(session, plan_id, when=("planning",), finished_at=now(), **values)


def _task(row: PlanRow) -> Task:
    scene = read_scene(row.scene)
    switches = {field.name for field in fields(PlannerOptions)}
    given = {name: value for name, value in row.planner.items() if name in switches}
    options = PlannerOptions(**given, seed=row.seed)
    return Task(
        scene=scene,
        actions=offered(worlds[scene.world], scene),
        instruction=Instruction(row.instruction),
        options=options,
    )


def _reason(error: Exception) -> str:
    if isinstance(error, Refused):
        return f"the program cannot be used: {error}"
    if isinstance(error, ProgPromptError):
        return str(error)
    log.exception("planning failed unexpectedly")
    return f"unexpected {type(error).__name__}: {error}"
