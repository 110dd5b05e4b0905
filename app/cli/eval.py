"""``progprompt eval``: measure planners and models on suites of tasks."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import click

from app.cli.attempts import EXISTING, FOLDER, JOBS, finish, run
from app.cli.paper_eval import paper
from app.evaluation.cells import make_cells
from app.evaluation.comparison import compare
from app.evaluation.household_data import Part, read_household
from app.evaluation.linter import lint
from app.evaluation.metrics import BY_NAME, METRICS
from app.evaluation.results import Verdict, open_results, read_results, write_result
from app.evaluation.runs import RESULTS, Evaluation
from app.evaluation.suites import Suite, find_suite, read_suite, suites
from app.evaluation.tables import markdown, tables
from app.evaluation.writing import write_files


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


@click.group(cls=Suites)
def command() -> None:
    """Measure planners and models on a suite, shipped or in a file."""


command.add_command(paper)


def _nothing_left(suite: Suite) -> str:
    categories = ", ".join(sorted({task.category for task in suite.tasks}))
    return (
        f"no task is left of the {len(suite.tasks)} in {suite.name}; choose fewer options "
        f"(the categories are {categories})"
    )


def _suite_command(name: str) -> click.Command:
    @click.command(name, help=f"Measure on the suite {Path(name).stem}.")
    @click.option("--planner", "planners", multiple=True, help="Several compare. [default: best]")
    @click.option("--model", "models", multiple=True, default=("default",), show_default=True)
    @click.option("--runs", default=1, show_default=True, type=click.IntRange(1, 100))
    @click.option("--out", type=FOLDER, default=Path("evaluation"), show_default=True)
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
    @click.option("--jobs", default=JOBS, show_default=True, type=click.IntRange(1, 64))
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
            raise click.ClickException(_nothing_left(read(name, household_data, part)))
        given = {key: value for key, value in switches.items() if value is not None}
        cells = make_cells(suite, planners, models, given)
        evaluation = Evaluation(
            suite=suite,
            cells=cells,
            runs=runs,
            languages=languages,
            physics=physics,
            seconds=None if minutes is None else 60 * minutes,
        )
        units = evaluation.units()
        made = run(units, out, jobs, evaluation.seconds)
        found = tables(made.results)
        write_files(out, f"Evaluation on {suite.name}", found, made.results)
        click.echo(markdown(found[:1]))
        finish(out, made, len(units))

    return measure


def read(name: str, household_data: Path | None = None, part: Part = "test") -> Suite:
    """A shipped suite, one in a file or, of the household's name and data, the paper's.

    Raises:
        Refused: it cannot be read.
    """
    if household_data is not None:
        return read_household(household_data, part)
    return read_suite(Path(name)) if Path(name).is_file() else find_suite(name)


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
    with open_results(folder / RESULTS) as file:
        write_result(file, judged)
