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

    name: Name | None = Field(
        default=None,
        description="A planner of the catalogue; null for the one that does best in the scene's "
        "world or, where the service or the request names a model, `progprompt`.",
    )
    model: Name = Field(
        default="default",
        description="A model of the catalogue; `default` is the service's or, where that names "
        "none, the one with which the planner does best.",
    )
    cue: bool = Field(
        default=True,
        description="Functions are named after their instructions, the paper's cue; else they are "
        "all called `task` and a docstring tells what each is to do.",
    )
    comments: bool = Field(
        default=True, description="Comments for sub-tasks in the example programs."
    )
    feedback: bool | None = Field(
        default=None,
        description="Assertions with recoveries in the example programs; null for the world's "
        "own default: false on the tabletop, as on the paper's robot, true in the household.",
    )
    examples: int = Field(
        default=3, ge=0, le=7, description="Number of example programs in the prompt."
    )
    choice: Literal["fixed", "random", "similar"] = Field(
        default="fixed",
        description="Which examples: the first ones, drawn by the seed, or those nearest to the "
        "instruction.",
    )
    objects: Literal["local", "global", "properties"] | None = Field(
        default=None,
        description="The objects as a list inside the function, before the examples, or with "
        "their properties; null for the world's own form.",
    )
    constrained: bool = Field(
        default=True, description="Decode under a grammar of the scene's own actions and objects."
    )
    affordances: bool = Field(
        default=True,
        description="The grammar also binds objects to what can be done with them; the paper's "
        "prompt alone does without.",
    )
    temperature: float = Field(
        default=0.0, ge=0, le=2, description="Of the sampling; 0 takes the best."
    )
    max_replans: int = Field(
        default=0,
        ge=0,
        le=5,
        description="How often what is left is planned anew after a step has failed, from where "
        "everything then stands; the planner learns what was observed.",
    )
    repair: bool | None = Field(
        default=None,
        description="Insert what an action's missing precondition calls for, found by rehearsing "
        "the plan with the perfect executor; by default where the planner asks for it.",
    )
    state_check: Literal["world", "model", "both"] = Field(
        default="world",
        description="Who decides assertions: the world itself, the model by the paper's "
        "state-check prompt, or both side by side, where the world's word counts.",
    )


class PerceptionGiven(Given):
    """What the robot perceives; whether a plan succeeded is never told by it."""

    source: Literal["cameras", "privileged"] = Field(
        default="cameras",
        description="Depth cameras alone, or the simulator's own geometry and poses.",
    )
    noise: float = Field(
        default=0.002, ge=0, le=0.05, description="Standard deviation of a camera's depth [m]."
    )
    detector: Literal["segmentation", "vision"] = Field(
        default="segmentation",
        description="Who names what the cameras see: the simulator's segmentation, or a vision "
        "model that finds the objects in pictures by their names (`PROGPROMPT_VISION_URL`).",
    )
    confusion: float = Field(
        default=0.0,
        ge=0,
        le=1,
        description="The share of objects taken for another one, in pairs drawn by the seed.",
    )

    @model_validator(mode="after")
    def _by_cameras(self) -> Self:
        if self.detector == "vision" and self.source != "cameras":
            raise ValueError("detector: only cameras have one; leave it out, or source='cameras'")
        return self


class PlanGiven(Given):
    """An instruction in a scene; or, instead of a planner, a program written by hand."""

    scene: SceneGiven | None = Field(
        default=None, description="The scene; or name one by `scene_id`."
    )
    scene_id: Name | None = Field(default=None, description="A stored scene, instead of `scene`.")
    parent: Name | None = Field(
        default=None,
        description="A plan this one follows, instead of a scene: things stand as it left them, "
        "and the instruction may refer to it (`now the other one`, `put it back`).",
    )
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
    perception: PerceptionGiven = Field(
        default_factory=PerceptionGiven, description="What the robot is told of the objects."
    )
    approval: Literal["auto", "manual"] = Field(
        default="auto", description="`manual`: the plan waits for `POST /plans/{id}/approve`."
    )

    @model_validator(mode="after")
    def _one_scene(self) -> Self:
        if [self.scene, self.scene_id, self.parent].count(None) != 2:
            raise ValueError("scene: give either a scene, a scene_id or a parent")
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


class DeclinedShown(Shown):
    """Why there is no plan, and what would help."""

    kind: Literal["absent", "impossible", "ambiguous", "hazardous", "unsure"]
    reason: str
    question: str | None
    choices: list[str] = Field(description="Instructions that would have been clear.")


class TryShown(Shown):
    """An earlier program of a plan that was made anew."""

    program: str
    execution: str = Field(description="The execution that ended it.")
    outcome: str = Field(description="What was observed.")


class PlanShown(Shown):
    """A plan and everything that came of it so far."""

    id: str
    status: Status
    instruction: str
    scene: SceneShown
    given_scene: SceneShown = Field(
        description="The scene as it was asked for; what it leaves open, another seed draws anew."
    )
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
    parent: str | None = Field(description="The plan it follows.")
    confidence: float | None = Field(
        description="How sure the planner is, from 0 to 1, where it can tell."
    )
    declined: DeclinedShown | None = Field(
        description="Why the planner would not plan it; nothing was moved then."
    )
    replans: int = Field(description="How often it was planned anew.")
    tries: list[TryShown] = Field(description="The programs before this one, oldest first.")
    error: str | None = Field(description="Why it failed.")
    created_at: datetime
    started_at: datetime | None
    finished_at: datetime | None


class ExecutionGiven(Given):
    """Another execution of a plan: as it was asked for, or with something changed."""

    seed: Seed | None = Field(
        default=None,
        description="Another seed samples the positions the scene left open anew; default the plan's.",
    )
    program: Text | None = Field(
        default=None,
        max_length=MAX_PROGRAM,
        description="What if the program were this one? Default the plan's.",
    )
    after: Name | None = Field(
        default=None,
        description="An execution of the same plan whose world is taken over, in the state before "
        "`line` or, without it, at its end.",
    )
    line: int | None = Field(
        default=None,
        ge=1,
        le=MAX_PROGRAM,
        description="With `after`: the line of the program before which the state is taken over, "
        "and from which the program runs.",
    )

    @model_validator(mode="after")
    def _line_of_something(self) -> Self:
        if self.line is not None and self.after is None:
            raise ValueError("line: needs `after`, the execution whose state is taken over")
        return self


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
