"""Cells: the methods of an evaluation, named by what sets them apart."""

from collections.abc import Mapping, Sequence
from dataclasses import fields, replace
from typing import Any

from app.domain.planner import PlannerOptions
from app.evaluation.results import Cell
from app.evaluation.suites import Suite
from app.planners import planners
from app.worlds import worlds


def make_cells(
    suite: Suite, names: Sequence[str], models: Sequence[str], switches: Mapping[str, Any]
) -> tuple[Cell, ...]:
    """Every planner with every model, under the same switches.

    Without a planner it is the one that does best in the suite's world or, where a model is named,
    the paper's.

    Raises:
        UnknownName: there is no such planner.
    """
    world = worlds[suite.tasks[0].scene.world]
    best = world.planner if set(models) == {"default"} else "progprompt"
    base = PlannerOptions(**{"feedback": world.feedback, **switches})
    return name_cells(
        [replace(base, name=name, model=model) for name in names or (best,) for model in models]
    )


def name_cells(options: Sequence[PlannerOptions]) -> tuple[Cell, ...]:
    """Methods called by their planner and by every switch in which they are not all alike.

    Raises:
        UnknownName: there is no planner of a name.
    """
    for each in options:
        assert planners[each.name]
    names = [field.name for field in fields(PlannerOptions) if field.name != "name"]
    differing = [name for name in names if len({getattr(each, name) for each in options}) > 1]
    cells: list[Cell] = []
    for each in dict.fromkeys(options):
        parts = [each.name, *(_said(name, getattr(each, name)) for name in differing)]
        cells.append(Cell(name=", ".join(parts), options=each))
    return tuple(cells)


def _said(name: str, value: object) -> str:
    if isinstance(value, bool):
        return name if value else f"no {name}"
    return str(value) if name == "model" else f"{name.replace('_', ' ')} {value}"
