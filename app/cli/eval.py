"""``progprompt eval``: measure planners and models on suites of tasks."""

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import click
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, TextColumn
from rich.progress import Progress as Bar

from app.domain.errors import ProgPromptError
from app.evaluation import paper
from app.evaluation.attempt import Unit
from app.evaluation.cells import make_cells
from app.evaluation.comparison import compare
from app.evaluation.household_data import Part, read_household
from app.evaluation.linter import lint
from app.evaluation.metrics import BY_NAME, METRICS
from app.evaluation.results import Result, Verdict, read_results, write_result
from app.evaluation.runs import RESULTS, Evaluation, OpenModels, Progress, evaluate_units
from app.evaluation.suites import Suite, find_suite, read_suite, suites
from app.evaluation.tables import markdown, tables, wrong
from app.evaluation.writing import FILES, write_files
from app.main.models import llm_config
from app.settings import Settings
from app.worker.models import Models

Folder = click.Path(file_okay=False, path_type=Path)
EXISTING = click.Path(exists=True, file_okay=False, path_type=Path)


class Suites(click.Group):
    """Every suite is a sub-command, beside the few that are none."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """The shipped suites, then the rest."""
        return [*suites(), *super().list_commands(ctx)]

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """The command of this name; one that measures on the suite of this name, or in this file."""
        known = super().get_command(ctx, cmd_name)
        if known is not None:
            return known
        if cmd_name in suites() or Path(cmd_name).is_file():
            return _suite_command(cmd_name)
        return None


command = Suites("eval", help="Measure planners and models on a suite, shipped or in a file.")


def open_models() -> OpenModels:
    """What opens models in each process of an evaluation."""
    settings = Settings.from_environment()
    return partial(Models, llm_config(settings), settings.model)


def run(units: Sequence[Unit], out: Path, jobs: int, seconds: float | None) -> list[Result]:
    """Make all attempts under a bar that tells the time left; an interrupt leaves what is there.

    Raises:
        click.ClickException: the evaluation cannot be made, with the reason.
    """
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn())
    with Bar(*columns, TextColumn("{task.fields[left]}"), console=Console(stderr=True)) as bar:
        shown = bar.add_task("evaluating", total=None, left="")

        def tell(progress: Progress) -> bool:
            left = (
                "" if progress.seconds_left is None else f"{_minutes(progress.seconds_left)} left"
            )
            bar.update(shown, completed=progress.done, total=progress.total, left=left)
            return False

        try:
            return evaluate_units(
                units, open_models(), out, jobs=jobs, seconds=seconds, report=tell
            )
        except KeyboardInterrupt:
            known = {result.key: result for result in read_results(out / RESULTS)}
            return [known[unit.key] for unit in units if unit.key in known]
        except ProgPromptError as error:
            raise click.ClickException(str(error)) from error


def finish(out: Path, results: Sequence[Result], total: int) -> None:
    """Say what there is and where."""
    if len(results) < total:
        click.echo(f"{total - len(results)} of {total} attempts are left; run it again to go on.")
    click.echo("\n".join(str(out / name) for name in FILES))


def _suite_command(name: str) -> click.Command:
    @click.command(name, help=f"Measure on the suite {Path(name).stem}.")
    @click.option("--planner", "planners", multiple=True, help="Several compare. [default: best]")
    @click.option("--model", "models", multiple=True, default=("default",), show_default=True)
    @click.option("--runs", default=1, show_default=True, type=click.IntRange(1, 100))
    @click.option("--out", type=Folder, default=Path("evaluation"), show_default=True)
    @click.option("--seed", default=0, show_default=True, type=click.IntRange(0))
    @click.option("--examples", type=click.IntRange(0, 50), help="Programs shown in the prompt.")
    @click.option("--cue/--no-cue", default=None, help="Functions named after instructions.")
    @click.option("--comments/--no-comments", default=None)
    @click.option("--feedback/--no-feedback", default=None, help="Assertions with recoveries.")
    @click.option("--constrained/--unconstrained", default=None, help="Decode under a grammar.")
    @click.option("--affordances/--no-affordances", default=None, help="In that grammar.")
    @click.option("--temperature", type=click.FloatRange(0, 2))
    @click.option("--objects", type=click.Choice(["local", "global", "properties"]))
    @click.option("--choice", type=click.Choice(["fixed", "random", "similar"]))
    @click.option("--repair/--no-repair", default=None, help="Insert missing preconditions.")
    @click.option("--max-replans", type=click.IntRange(0, 10))
    @click.option("--physics", is_flag=True, help="Carry out in physics as well (SR).")
    @click.option("--split", type=click.Choice(["all", "train", "test"]), default="all")
    @click.option("--category", "categories", multiple=True, help="Only tasks of these.")
    @click.option("--task", "names", multiple=True, help="Only these tasks.")
    @click.option("--limit", type=click.IntRange(1), help="So many tasks, evenly chosen.")
    @click.option("--language", "languages", multiple=True, default=("en",), show_default=True)
    @click.option("--minutes", type=click.FloatRange(min=0), help="Begin nothing after so long.")
    @click.option(
        "--household-data", type=EXISTING, help="Take the paper's tasks from this folder instead."
    )
    @click.option(
        "--part",
        type=click.Choice(["test", "train"]),
        default="test",
        show_default=True,
        help="Which of the paper's tasks.",
    )
    @click.option("--jobs", default=1, show_default=True, type=click.IntRange(1, 64))
    def measure(  # noqa: PLR0913 - one parameter per option
        planners: tuple[str, ...],
        models: tuple[str, ...],
        runs: int,
        out: Path,
        split: str,
        categories: tuple[str, ...],
        names: tuple[str, ...],
        limit: int | None,
        languages: tuple[str, ...],
        minutes: float | None,
        physics: bool,
        household_data: Path | None,
        part: Part,
        jobs: int,
        **switches: Any,  # noqa: ANN401 - the options of the planner
    ) -> None:
        suite = read(name, household_data, part).chosen(
            split=split, categories=categories, names=names, limit=limit
        )
        if not suite.tasks:
            raise click.ClickException("no task is left; choose fewer options")
        given = {key: value for key, value in switches.items() if value is not None}
        try:
            cells = make_cells(suite, planners, models, given)
        except ProgPromptError as error:
            raise click.ClickException(str(error)) from error
        evaluation = Evaluation(
            suite=suite,
            cells=cells,
            runs=runs,
            languages=languages,
            physics=physics,
            seconds=None if minutes is None else 60 * minutes,
        )
        units = evaluation.units()
        results = run(units, out, jobs, evaluation.seconds)
        found = tables(results)
        write_files(out, f"Evaluation on {suite.name}", found, results)
        click.echo(markdown(found[:1]))
        finish(out, results, len(units))

    return measure


def read(name: str, household_data: Path | None = None, part: Part = "test") -> Suite:
    """A shipped suite, one in a file or, of the household's name and data, the paper's.

    Raises:
        click.ClickException: it cannot be read, with the reason.
    """
    try:
        if household_data is not None:
            return read_household(household_data, part)
        return read_suite(Path(name)) if Path(name).is_file() else find_suite(name)
    except ProgPromptError as error:
        raise click.ClickException(str(error)) from error


@command.command("paper")
@click.option(
    "--household-data",
    type=EXISTING,
    help="Folder of the paper's tasks; without it our own homes stand in for them.",
)
@click.option("--out", type=Folder, default=Path("paper"), show_default=True)
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
@click.option("--jobs", default=1, show_default=True, type=click.IntRange(1, 64))
def measure_paper(
    household_data: Path | None,
    out: Path,
    minutes: float,
    jobs: int,
    **chosen: Any,  # noqa: ANN401
) -> None:
    """The paper's four tables beside its printed figures, and the sweep over examples."""
    own = household_data is None
    try:
        suite = _own_homes() if household_data is None else read_household(household_data)
    except ProgPromptError as error:
        raise click.ClickException(str(error)) from error
    plan = paper.Plan(household=suite, own=own, **chosen)
    units = paper.units(plan)
    results = run(units, out, jobs, 60 * minutes)
    found = paper.paper_tables(plan, results)
    note = paper.NOTE if plan.temperature == 0 else ""
    if own:
        note = f"The household tasks are our own, not the paper's. {note}"
    charts = paper.paper_charts(plan, results)
    title = "ProgPrompt: the paper's tables"
    write_files(out, title, [*found, wrong(results)], results, charts=charts, note=note)
    click.echo(markdown(found))
    finish(out, results, len({unit.key for unit in units}))


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


@command.command("compare")
@click.argument("first", type=EXISTING)
@click.argument("second", type=EXISTING)
@click.option("--metric", type=click.Choice([m.name for m in METRICS]), default="strict")
def compare_folders(first: Path, second: Path, metric: str) -> None:
    """Compare the results in two folders, task by task."""
    ours, theirs = (read_results(folder / RESULTS) for folder in (first, second))
    found = compare(ours, theirs, BY_NAME[metric], (first.name, second.name))
    click.echo(
        f"{found.pairs} pairs, {BY_NAME[metric].title}: {found.second} minus {found.first} is "
        f"{found.difference:+.3f} (95 % interval {found.low:+.3f} to {found.high:+.3f}); "
        f"better in {found.only_second}, worse in {found.only_first}, p = {found.p:.3g}: "
        f"{found.verdict}"
    )


@command.command("lint")
@click.argument("name", metavar="SUITE")
def lint_suite(name: str) -> None:
    """Tell what is wrong with the goals of a suite, before it is used."""
    suite = read(name)
    findings = lint(suite.tasks)
    for finding in findings:
        click.echo(f"{finding.task}: {finding.code}: {finding.message}")
    click.echo(f"{len(suite.tasks)} tasks, {len(findings)} findings")
    raise SystemExit(1 if findings else 0)


@command.command("verdict")
@click.argument("folder", type=EXISTING)
@click.argument("key")
@click.option("--success/--failure", required=True, default=None)
@click.option("--note", default="")
def give_verdict(folder: Path, key: str, success: bool, note: str) -> None:
    """Keep a person's verdict on one result beside the automatic one; SR then follows it."""
    results = {result.key: result for result in read_results(folder / RESULTS)}
    if key not in results:
        raise click.ClickException(f"there is no result {key!r} in {folder}")
    judged = replace(results[key], verdict=Verdict(success=success, note=note))
    with (folder / RESULTS).open("a", encoding="utf-8") as file:
        write_result(file, judged)


def _minutes(seconds: float) -> str:
    return f"{seconds / 60:.0f} min" if seconds >= 90 else f"{seconds:.0f} s"
