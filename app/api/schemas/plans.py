"""Plans as clients ask for them and see them."""

from datetime import datetime
from typing import Annotated, Any, Literal, Self

from pydantic import Field, model_validator

from app.api.schemas.base import Given, Seed, Shown, Text
from app.api.schemas.scenes import Name, SceneGiven, SceneShown
from app.storage.plans import PlanRow, Status

MAX_PROGRAM = 100_000


class PlannerGiven(Given):
    """The switches of the planner, its prompt and its decoding."""

    name: Name = Field(default="progprompt", description="A planner of the catalogue.")
    model: Name = Field(default="default", description="A model of the catalogue.")
    comments: bool = Field(
        default=True, description="Comments for sub-tasks in the example programs."
    )
    feedback: bool | None = Field(
        default=None,
        description="Assertions with recoveries in the example programs; null for the world's "
        "own default, which is false on the tabletop, as on the paper's robot.",
    )
    examples: int = Field(
        default=3, ge=0, le=7, description="Number of example programs in the prompt."
    )
    constrained: bool = Field(
        default=True, description="Decode under a grammar of the scene's own actions and objects."
    )
    temperature: float = Field(
        default=0.0, ge=0, le=2, description="Of the sampling; 0 takes the best."
    )
    max_replans: int = Field(
        default=0,
        ge=0,
        le=5,
        description="How often to plan anew after a failed execution. Recorded only: plans are "
        "not made anew yet, and `replans` of the plan stays 0.",
    )
    state_check: Literal["world"] = Field(
        default="world", description="Who decides assertions: the world itself."
    )


class PlanGiven(Given):
    """An instruction in a scene; or, instead of a planner, a program written by hand."""

    scene: SceneGiven | None = Field(
        default=None, description="The scene; or name one by `scene_id`."
    )
    scene_id: Name | None = Field(default=None, description="A stored scene, instead of `scene`.")
    instruction: Text | None = Field(
        default=None,
        description="What the robot should do, in plain language. Only a `program` may lack it.",
    )
    program: Text | None = Field(
        default=None,
        max_length=MAX_PROGRAM,
        description="A program in the plan language, run as it stands; `planner` is not used then.",
    )
    execute: bool = Field(default=True, description="Carry the plan out once it is there.")
    seed: Seed = 0
    goal: list[Annotated[Text, Field(max_length=1000)]] = Field(
        default_factory=list,
        max_length=200,
        description="Conditions that should hold at the end, like `in(banana, bowl)`. The planner "
        "never sees them.",
    )
    planner: PlannerGiven = Field(default=PlannerGiven(), description="How to plan.")
    approval: Literal["auto", "manual"] = Field(
        default="auto", description="`manual`: the plan waits for `POST /plans/{id}/approve`."
    )

    @model_validator(mode="after")
    def _one_scene(self) -> Self:
        if (self.scene is None) == (self.scene_id is None):
            raise ValueError("scene: give either a scene or a scene_id")
        if self.instruction is None and self.program is None:
            raise ValueError("instruction: is missing; say what the robot should do")
        return self


class StepShown(Shown):
    """One action call of the program."""

    line: int = Field(description="Its line in the program, from 1.")
    action: str
    arguments: list[str | float]
    comment: str | None = Field(description="The comment it stands under.")


class RejectedShown(Shown):
    """A call that names what is not there; it is skipped, and lowers executability."""

    line: int
    text: str
    reason: str


class PlanShown(Shown):
    """A plan and everything that came of it so far."""

    id: str
    status: Status
    instruction: str
    scene: SceneShown
    scene_id: str | None
    seed: int
    execute: bool
    approval: str
    goal: list[str]
    planner: dict[str, Any] | None = Field(description="Null where the program was given.")
    prompt: str | None = Field(description="Sent to the model, unchanged.")
    completion: str | None = Field(description="What came back, unchanged.")
    program: str | None = Field(description="The whole function.")
    program_tree: list[dict[str, Any]] = Field(
        description="Its statements: comments, calls, assertions with their recoveries."
    )
    steps: list[StepShown] = Field(description="The action calls in source order.")
    rejected: list[RejectedShown]
    usage: dict[str, Any] | None = Field(description="Model, tokens and wall time [s].")
    plan_scores: dict[str, float | None] | None = Field(
        description="Scores with a perfect executor; `sr` is the paper's Plan SR. Null without a goal."
    )
    executions: list[str] = Field(description="Ids, oldest first.")
    replans: int
    error: str | None = Field(description="Why it failed.")
    created_at: datetime
    started_at: datetime | None
    finished_at: datetime | None


class ExecutionGiven(Given):
    """Another execution of a plan."""

    seed: Seed | None = Field(
        default=None,
        description="Another seed samples the positions the scene left open anew; default the plan's.",
    )


def show_plan(row: PlanRow, executions: list[str]) -> PlanShown:
    """The plan as clients see it."""
    names = PlanShown.model_fields.keys() - {"executions", "planner"}
    return PlanShown.model_validate(
        {
            **{name: getattr(row, name) for name in names},
            "executions": executions,
            "planner": row.planner or None,
        }
    )
