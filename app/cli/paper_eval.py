"""``progprompt eval paper``: the paper's tables, regenerated beside the printed figures."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import click

from app.cli.attempts import EXISTING, FOLDER, JOBS, finish, run
from app.evaluation.household_data import read_household
from app.evaluation.paper import NOTE, Plan, paper_charts, paper_tables
from app.evaluation.paper import units as units_of
from app.evaluation.suites import Suite, find_suite
from app.evaluation.tables import markdown, wrong
from app.evaluation.writing import write_files


@click.command()
@click.option(
    "--household-data",
    type=EXISTING,
    help="Folder of the paper's tasks; without it our own homes stand in for them.",
)
@click.option("--out", type=FOLDER, default=Path("paper"), show_default=True)
@click.option(
    "--model",
    "models",
    multiple=True,
    default=("default", "small"),
    show_default=True,
    help="Backbones; the first one carries the ablations, the baselines and the sweep.",
)
@click.option("--runs", default=1, show_default=True, type=click.IntRange(1, 100))
@click.option("--temperature", default=0.0, show_default=True, type=click.FloatRange(0, 2))
@click.option("--layouts", default=1, show_default=True, type=click.IntRange(1, 100))
@click.option("--minutes", default=85.0, show_default=True, help="Begin nothing after so long.")
@click.option("--quick", is_flag=True, help="A few tasks and methods only.")
@click.option("--jobs", default=JOBS, show_default=True, type=click.IntRange(1, 64))
def paper(
    household_data: Path | None,
    out: Path,
    minutes: float,
    jobs: int,
    **chosen: Any,  # noqa: ANN401
) -> None:
    """The paper's four tables beside its printed figures, and the sweep over examples."""
    own = household_data is None
    suite = _own_homes() if household_data is None else read_household(household_data)
    plan = Plan(household=suite, own=own, **chosen)
    units = units_of(plan)
    made = run(units, out, jobs, 60 * minutes)
    results = made.results
    found = paper_tables(plan, results)
    note = NOTE if plan.temperature == 0 else ""
    if own:
        note = f"The household tasks are our own, not the paper's. {note}"
    charts = paper_charts(plan, results)
    title = "ProgPrompt: the paper's tables"
    write_files(out, title, [*found, wrong(results)], results, charts=charts, note=note)
    click.echo(markdown(found))
    finish(out, made, len({unit.key for unit in units}))


def _own_homes() -> Suite:
    """Ten tasks of each of our homes, evenly chosen of the half that is for measuring."""
    every = find_suite("household")
    tasks = [
        task
        for home in sorted({task.environment for task in every.tasks})
        for task in replace(
            every, tasks=tuple(t for t in every.tasks if t.environment == home and t.goal)
        )
        .chosen(split="test", limit=10)
        .tasks
    ]
    return replace(every, tasks=tuple(tasks))
