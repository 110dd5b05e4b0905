"""The events of a plan and of its rollout as one tagged union of past-tense facts."""

from dataclasses import dataclass
from typing import Literal

from app.domain.condition import Condition, Relation
from app.domain.pose import Pose
from app.domain.program import Argument


@dataclass(frozen=True, slots=True, kw_only=True)
class PlanningStarted:
    """A planner took up the instruction."""

    planner: str
    model: str | None
    kind: Literal["planning_started"] = "planning_started"


@dataclass(frozen=True, slots=True, kw_only=True)
class PromptWritten:
    """The prompt is complete and goes to the model."""

    characters: int
    kind: Literal["prompt_written"] = "prompt_written"


@dataclass(frozen=True, slots=True, kw_only=True)
class CompletionGrew:
    """The model wrote some more of the program."""

    text: str
    kind: Literal["completion_grew"] = "completion_grew"


@dataclass(frozen=True, slots=True, kw_only=True)
class CompletionContinued:
    """The model ran into its limit of tokens; it is asked to go on with what it wrote so far.

    Of the completion told so far the first ``kept`` characters stand; the rest is told anew.
    """

    kept: int
    tokens: int
    """Written so far."""
    kind: Literal["completion_continued"] = "completion_continued"


@dataclass(frozen=True, slots=True, kw_only=True)
class ProgramGrounded:
    """The completion was parsed and grounded in the scene."""

    steps: int
    rejected: int
    kind: Literal["program_grounded"] = "program_grounded"


@dataclass(frozen=True, slots=True, kw_only=True)
class PlanningFailed:
    """No program came of it."""

    reason: str
    kind: Literal["planning_failed"] = "planning_failed"


@dataclass(frozen=True, slots=True, kw_only=True)
class ExecutionStarted:
    """The scene stands as described and the first step is about to run."""

    facts: tuple[Relation, ...]
    kind: Literal["execution_started"] = "execution_started"


@dataclass(frozen=True, slots=True, kw_only=True)
class CommentReached:
    """The plan came to a comment: the sub-task it names is now under way."""

    line: int
    text: str
    time: float
    """Simulated time since the rollout began [s], here and below."""
    kind: Literal["comment_reached"] = "comment_reached"


@dataclass(frozen=True, slots=True, kw_only=True)
class ActionStarted:
    """An action began."""

    line: int
    action: str
    arguments: tuple[Argument, ...]
    time: float
    kind: Literal["action_started"] = "action_started"


@dataclass(frozen=True, slots=True, kw_only=True)
class StageReached:
    """An action came to its next stage: ``look``, ``reach``, ``grasp``, ``lift`` and so on."""

    line: int
    stage: str
    attempt: int
    time: float
    kind: Literal["stage_reached"] = "stage_reached"


@dataclass(frozen=True, slots=True, kw_only=True)
class ActionPerformed:
    """An action succeeded."""

    line: int
    attempts: int
    time: float
    kind: Literal["action_performed"] = "action_performed"


@dataclass(frozen=True, slots=True, kw_only=True)
class ActionFailed:
    """An action did not succeed; the plan goes on."""

    line: int
    stage: str
    reason: str
    pose: Pose | None = None
    """Where the gripper should have gone, where that is what failed."""
    time: float
    kind: Literal["action_failed"] = "action_failed"


@dataclass(frozen=True, slots=True, kw_only=True)
class CallSkipped:
    """A rejected call's turn came; nothing was done."""

    line: int
    text: str
    reason: str
    time: float
    kind: Literal["call_skipped"] = "call_skipped"


@dataclass(frozen=True, slots=True, kw_only=True)
class AssertionChecked:
    """An assertion was decided against the world as it stands."""

    line: int
    condition: Condition
    holds: bool
    decider: str
    """Who decided: ``world``, ``model``, or ``both``, where the world's word counts."""
    by_world: bool | None = None
    """What the world says, where it was asked; here and below."""
    by_model: bool | None = None
    """What the language model says, where it was asked."""
    agree: bool | None = None
    """Whether the two say the same, where both were asked."""
    time: float
    kind: Literal["assertion_checked"] = "assertion_checked"


@dataclass(frozen=True, slots=True, kw_only=True)
class BranchDecided:
    """The plan came to an ``if``, and goes on with the side that is told."""

    line: int
    condition: Condition
    holds: bool
    decider: str
    by_world: bool | None = None
    by_model: bool | None = None
    agree: bool | None = None
    time: float
    kind: Literal["branch_decided"] = "branch_decided"


@dataclass(frozen=True, slots=True, kw_only=True)
class RecoveryTaken:
    """A false assertion's recovery is about to run."""

    line: int
    calls: int
    time: float
    kind: Literal["recovery_taken"] = "recovery_taken"


@dataclass(frozen=True, slots=True, kw_only=True)
class GoalChecked:
    """A goal condition was read from the world after it had come to rest."""

    condition: Condition
    holds: bool
    time: float
    kind: Literal["goal_checked"] = "goal_checked"


@dataclass(frozen=True, slots=True, kw_only=True)
class ExecutionFinished:
    """The plan is through and the world is at rest."""

    facts: tuple[Relation, ...]
    time: float
    kind: Literal["execution_finished"] = "execution_finished"


PlanningEvent = (
    PlanningStarted
    | PromptWritten
    | CompletionGrew
    | CompletionContinued
    | ProgramGrounded
    | PlanningFailed
)
ExecutionEvent = (
    ExecutionStarted
    | CommentReached
    | ActionStarted
    | StageReached
    | ActionPerformed
    | ActionFailed
    | CallSkipped
    | AssertionChecked
    | BranchDecided
    | RecoveryTaken
    | GoalChecked
    | ExecutionFinished
)
Event = PlanningEvent | ExecutionEvent


@dataclass(frozen=True, slots=True, kw_only=True)
class Checkpoint:
    """A step of the plan is through: an execution restored here goes on with ``next_step``."""

    next_step: int
    """Index into the plan's steps."""


@dataclass(frozen=True, slots=True)
class Tick:
    """Some simulated time has passed: the moment to drain frames and to look for cancellation."""


Happening = ExecutionEvent | Checkpoint | Tick
"""What an execution yields; only its events are kept."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Frame:
    """How everything stood at one moment of a rollout."""

    time: float
    """Simulated time since the rollout began [s]."""
    positions: tuple[float, ...]
    """The simulator's generalized coordinates (qpos), shape (nq,), [m] and [rad]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Trace:
    """All events of one execution, in order."""

    events: tuple[ExecutionEvent, ...] = ()
