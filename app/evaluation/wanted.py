"""Wanted: what an evaluation is to measure, as a document that can be stored and read again."""

from dataclasses import asdict, dataclass, field
from typing import Any

from pydantic import TypeAdapter

from app.domain.errors import Fault, Refused
from app.domain.planner import PlannerOptions
from app.evaluation.cells import name_cells
from app.evaluation.runs import Evaluation
from app.evaluation.suites import find_suite
from app.evaluation.tasks import ENGLISH


@dataclass(frozen=True, slots=True, kw_only=True)
class Wanted:
    """The request for an evaluation, with every default filled in."""

    suite: str
    methods: tuple[PlannerOptions, ...]
    runs: int = 1
    languages: tuple[str, ...] = (ENGLISH,)
    physics: bool = False
    split: str = "all"
    categories: tuple[str, ...] = ()
    tasks: tuple[str, ...] = ()
    limit: int | None = None
    document: dict[str, Any] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        document = {
            name: getattr(self, name) for name in self.__slots__ if name not in ("document",)
        }
        document["methods"] = [asdict(method) for method in self.methods]
        object.__setattr__(self, "document", document)

    def evaluation(self) -> Evaluation:
        """What it amounts to.

        Raises:
            UnknownName: there is no such suite or planner.
            Refused: no task is left.
        """
        suite = find_suite(self.suite).chosen(
            split=self.split, categories=self.categories, names=self.tasks, limit=self.limit
        )
        if not suite.tasks:
            raise Refused(Fault(field="tasks", message="no task of the suite is left"))
        return Evaluation(
            suite=suite,
            cells=name_cells(self.methods),
            runs=self.runs,
            languages=self.languages,
            physics=self.physics,
        )


_WANTED: TypeAdapter[Wanted] = TypeAdapter(Wanted)


def read_wanted(document: dict[str, Any]) -> Wanted:
    """The request that a document describes."""
    return _WANTED.validate_python(document)
