"""Planning: the workflow that turns an instruction into a stored plan."""

import logging
from collections.abc import Callable
from typing import Any

from app.domain.errors import Cancelled, CompletionFailed, ProgPromptError, Refused, TaskDeclined
from app.domain.goal import Goal
from app.domain.llm import Completion, LanguageModel
from app.domain.trace import PlanningFailed, ProgramGrounded
from app.planners import planners
from app.programs.conditions import parse_condition
from app.rollout import Planned, plan_task, rehearse
from app.storage import plans
from app.storage.base import now
from app.storage.database import Database
from app.storage.documents import plan_columns
from app.storage.handover import Handover
from app.storage.plans import PlanRow
from app.worker.planning_recorder import PlanningRecorder
from app.worker.situation import Situation, situation_of
from app.worlds import worlds

MAX_ATTEMPTS = 3
log = logging.getLogger(__name__)


class Planning:
    """What a worker of the planning queue does."""

    def __init__(
        self,
        database: Database,
        handover: Handover,
        open_model: Callable[[str, str], LanguageModel],
    ) -> None:
        """A desk; ``open_model`` gets the name a plan asks for, and the planner's own choice."""
        self._database = database
        self._handover = handover
        self._open_model = open_model

    def __call__(self, plan_id: str, /) -> None:
        """Plan, and hand the plan on. Whatever goes wrong ends as a failed plan with its reason.

        A plan that is cancelled has ended already; here that is only noticed.
        """
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
            return
        except Exception as error:
            reason = _reason(error)
            recorder.report(PlanningFailed(reason=reason))
            self._end(plan_id, status="failed", error=reason, declined=_declined(error))

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
        with self._database.reading() as session:
            situation = situation_of(session, row)
        options = situation.task.options
        planner = planners[options.name]
        model = self._open_model(options.model, planner.model)
        try:
            planned = plan_task(
                situation.task, planner, model, situation.rehearsal, recorder.report
            )
        except (CompletionFailed, TaskDeclined) as failed:
            self._keep(row.id, failed.prompt, failed.completion)
            raise
        draft = planned.draft
        self._keep(row.id, draft.prompt, draft.completion, confidence=draft.confidence)
        steps, rejected = len(planned.plan.calls), len(planned.plan.rejected)
        recorder.report(ProgramGrounded(steps=steps, rejected=rejected))
        scores = _plan_scores(row, situation, planned)
        with self._database.transaction() as session:
            found = plans.get(session, row.id, lock=True)
            if found.status != "planning":
                raise Cancelled
            found.program = planned.text
            for name, value in plan_columns(planned.program, planned.plan).items():
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


def _plan_scores(
    row: PlanRow, situation: Situation, planned: Planned
) -> dict[str, float | None] | None:
    """The scores of the first plan under a perfect executor; a later one is only the rest of it."""
    if not row.goal or row.replans:
        return row.plan_scores
    goal = Goal(tuple(parse_condition(text) for text in row.goal))
    scene = situation.task.scene
    return rehearse(planned.plan, goal, worlds[scene.world], scene, row.seed, state=situation.state)


def _declined(error: Exception) -> dict[str, Any] | None:
    if not isinstance(error, TaskDeclined):
        return None
    return {
        "kind": error.kind,
        "reason": error.reason,
        "question": error.question,
        "choices": list(error.choices),
    }


def _reason(error: Exception) -> str:
    if isinstance(error, Refused):
        return f"the program cannot be used: {error}"
    if isinstance(error, ProgPromptError):
        return str(error)
    log.exception("planning failed unexpectedly")
    return f"unexpected {type(error).__name__}: {error}"
