"""Evaluations as clients ask for them and see them."""

from datetime import datetime
from typing import Annotated, Any, Literal

from pydantic import Field

from app.api.schemas.base import Given, Seed, Shown, Text
from app.api.schemas.plans import PlannerGiven
from app.api.schemas.scenes import Name
from app.storage.base import now
from app.storage.evaluations import EvaluationRow, Status

Language = Annotated[str, Field(pattern=r"^[a-z]{2}$|^all$", max_length=3)]


class EvaluationGiven(Given):
    """Which tasks are to be measured, by which methods, and how often."""

    suite: Name = Field(description="A suite; `GET /evaluations/suites` lists them.")
    planners: list[PlannerGiven] = Field(
        default_factory=lambda: [PlannerGiven()],
        min_length=1,
        max_length=20,
        description="The methods to compare: each a planner with its switches and its model.",
    )
    runs: int = Field(
        default=1, ge=1, le=20, description="How often each task is attempted; run k has seed + k."
    )
    seed: Seed = 0
    languages: list[Language] = Field(
        default_factory=lambda: ["en"],
        min_length=1,
        max_length=20,
        description="Languages of the instructions; `all` for every one a task has.",
    )
    physics: bool = Field(
        default=False, description="Carry the plans out in physics as well, for SR."
    )
    split: Literal["all", "train", "test"] = Field(
        default="all", description="The half to develop on, the half to measure on, or both."
    )
    categories: list[Name] = Field(
        default_factory=list, max_length=50, description="Only tasks of these categories."
    )
    tasks: list[Name] = Field(
        default_factory=list, max_length=1000, description="Only the tasks of these names."
    )
    limit: int | None = Field(
        default=None, ge=1, le=10_000, description="So many tasks, evenly chosen."
    )
    lanes: int = Field(
        default=2, ge=1, le=64, description="Attempts that may be under way at the same time."
    )


class VerdictGiven(Given):
    """What a person makes of a result."""

    success: bool = Field(description="Whether the task was done. SR follows this, where given.")
    note: Text = Field(default="", max_length=2000, description="Why.")


class EvaluationShown(Shown):
    """An evaluation and how far it has come."""

    id: str
    status: Status
    suite: str
    request: dict[str, Any] = Field(description="What is measured, with every default filled in.")
    done: int = Field(description="Attempts there are results of.")
    total: int
    seconds_left: float | None = Field(description="Guessed from the attempts so far.")
    error: str | None
    created_at: datetime
    started_at: datetime | None
    finished_at: datetime | None


class SuiteShown(Shown):
    """A suite that can be measured on."""

    name: str
    tasks: int
    worlds: list[str]
    categories: list[str]
    languages: list[str]
    test: int = Field(description="Tasks of the half that is for measuring.")


class TablesShown(Shown):
    """All tables of an evaluation."""

    title: str
    tables: list[dict[str, Any]]


class ComparisonShown(Shown):
    """Two evaluations or methods, pair by pair; the second minus the first."""

    first: str
    second: str
    metric: str
    pairs: int
    only_first: int
    only_second: int
    difference: float
    low: float
    high: float
    p: float
    verdict: str


def show_evaluation(row: EvaluationRow, done: int) -> EvaluationShown:
    """An evaluation as clients see it."""
    left = None
    if row.started_at is not None and done and row.status == "running":
        left = (row.total - done) * (now() - row.started_at).total_seconds() / done
    return EvaluationShown(
        id=row.id,
        status=row.status,
        suite=row.suite,
        request=row.request,
        done=done,
        total=row.total,
        seconds_left=left,
        error=row.error,
        created_at=row.created_at,
        started_at=row.started_at,
        finished_at=row.finished_at,
    )
