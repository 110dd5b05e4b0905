"""Executions as clients see them."""

from collections.abc import Sequence
from datetime import datetime
from typing import Any, Literal

from pydantic import Field

from app.api.schemas.base import Shown
from app.api.schemas.scenes import SceneShown
from app.domain.trace import ActionFailed, ActionPerformed, ActionStarted, CallSkipped, Event
from app.rollout import understand
from app.storage.documents import plan_columns, read_scene
from app.storage.executions import UNFINISHED, ExecutionRow, Status
from app.storage.plans import PlanRow
from app.worlds import worlds

STEP_KINDS = ("action_started", "action_performed", "action_failed", "call_skipped")
"""The kinds of events that tell what became of the steps."""


class StepOutcome(Shown):
    """What became of one action call."""

    line: int
    action: str | None
    arguments: list[str | float]
    outcome: Literal["pending", "running", "performed", "failed", "skipped", "stopped"] = Field(
        description="`stopped`: the execution ended, cancelled or given up, while it was running."
    )
    attempts: int | None = None
    stage: str | None = Field(
        default=None, description="Where it failed: `grounding`, `grasp`, `lift` …"
    )
    reason: str | None = Field(default=None, description="Why it failed or was skipped.")
    started: float | None = Field(default=None, description="Simulated time [s].")
    finished: float | None = Field(default=None, description="Simulated time [s].")


class FailureShown(Shown):
    """The first step that did not succeed."""

    line: int
    stage: str
    reason: str


class ExecutionShown(Shown):
    """One run of a plan in its world."""

    id: str
    plan_id: str
    status: Status
    seed: int
    scene: SceneShown = Field(description="As it was described, every gap filled in.")
    program: str = Field(description="The whole function it runs.")
    begins_after: str | None = Field(
        description="The execution whose world it took over; null for the scene as described."
    )
    begins_at_line: int | None = Field(
        description="It took over the state before this line, and runs from there."
    )
    options: dict[str, Any] = Field(
        description="What the robot perceived, and who decided assertions."
    )
    rerun_of: str | None = Field(description="The execution it repeats.")
    identical: bool | None = Field(
        description="Whether its trace is that of `rerun_of`, bit for bit."
    )
    what_if: bool = Field(
        description="Something was changed for it; like a repetition, it leaves the plan as it is."
    )
    steps: list[StepOutcome] = Field(
        description="Attempted calls in the order of their turns, recoveries included, then those to come."
    )
    scores: dict[str, float | None] | None = Field(description="`sr`, `gcr`, `exec`, `precision`.")
    final_state: list[str] | None = Field(description="The facts true at the end.")
    failure: FailureShown | None
    error: str | None = Field(description="Why it did not succeed.")
    created_at: datetime
    started_at: datetime | None
    finished_at: datetime | None


def show_execution(row: ExecutionRow, plan: PlanRow, events: Sequence[Event]) -> ExecutionShown:
    """The execution as clients see it; of its events those of ``STEP_KINDS`` are needed."""
    names = ExecutionShown.model_fields.keys() - {"steps"}
    return ExecutionShown.model_validate(
        {
            **{name: getattr(row, name) for name in names},
            "steps": _outcomes(_steps(row, plan), events, over=row.status not in UNFINISHED),
        }
    )


def _steps(row: ExecutionRow, plan: PlanRow) -> list[dict[str, Any]]:
    """The calls of its own program, which need not be the plan's latest."""
    steps = plan.steps
    if row.program != plan.program:
        scene = read_scene(row.scene)
        steps = plan_columns(*understand(row.program, scene, worlds[scene.world]))["steps"]
    return [step for step in steps if step["line"] >= (row.begins_at_line or 0)]


def _outcomes(
    steps: Sequence[dict[str, Any]], events: Sequence[Event], *, over: bool
) -> list[StepOutcome]:
    reached: list[StepOutcome] = []
    for event in events:
        match event:
            case ActionStarted(line=line, action=action, arguments=arguments, time=time):
                reached.append(
                    StepOutcome(
                        line=line,
                        action=action,
                        arguments=list(arguments),
                        outcome="running",
                        started=time,
                    )
                )
            case ActionPerformed(attempts=attempts, time=time):
                _update(reached, outcome="performed", attempts=attempts, finished=time)
            case ActionFailed(stage=stage, reason=reason, time=time):
                _update(reached, outcome="failed", stage=stage, reason=reason, finished=time)
            case CallSkipped(line=line, reason=reason):
                reached.append(
                    StepOutcome(
                        line=line,
                        action=None,
                        arguments=[],
                        outcome="skipped",
                        stage="grounding",
                        reason=reason,
                    )
                )
            case _:
                pass
    if over and reached and reached[-1].outcome == "running":
        _update(reached, outcome="stopped")
    lines = {step.line for step in reached}
    to_come = [
        StepOutcome(
            line=step["line"],
            action=step["action"],
            arguments=step["arguments"],
            outcome="pending",
        )
        for step in steps
        if step["line"] not in lines
    ]
    return reached + to_come


def _update(reached: list[StepOutcome], **values: Any) -> None:  # noqa: ANN401
    if reached:
        reached[-1] = reached[-1].model_copy(update=values)
