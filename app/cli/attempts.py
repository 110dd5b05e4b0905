"""The attempts of an evaluation, made under a bar that tells the time left."""

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import click
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, TextColumn
from rich.progress import Progress as Bar

from app.cli.endings import INTERRUPTED, interrupted
from app.domain.errors import ProgPromptError
from app.evaluation.attempt import Unit
from app.evaluation.results import Result, read_results
from app.evaluation.runs import RESULTS, OpenModels, Progress, evaluate_units
from app.evaluation.writing import FILES
from app.main.models import llm_config, open_models
from app.settings import Settings

FOLDER = click.Path(file_okay=False, path_type=Path)
BATCH = 128
"""Tokens of a prompt read at once: half as dear again in smaller portions, and nobody waits here."""
JOBS = min(2, os.cpu_count() or 1)
"""One thread each writes more than one process with all of them; a 1.5B model takes 1.9 GB in each."""
EXISTING = click.Path(exists=True, file_okay=False, path_type=Path)


def opening(jobs: int) -> OpenModels:
    """What opens models in each of so many processes of an evaluation, which share the threads."""
    settings = Settings.from_environment()
    config = llm_config(settings)
    config = replace(config, threads=max(1, config.threads // jobs), batch=BATCH)
    return partial(open_models, config, settings.model)


@dataclass(frozen=True, slots=True)
class Made:
    """What came of the attempts."""

    results: list[Result]
    interrupted: bool = False


def run(units: Sequence[Unit], out: Path, jobs: int, seconds: float | None) -> Made:
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
            with interrupted():
                return Made(
                    evaluate_units(
                        units, opening(jobs), out, jobs=jobs, seconds=seconds, report=tell
                    )
                )
        except KeyboardInterrupt:
            known = {result.key: result for result in read_results(out / RESULTS)}
            return Made([known[unit.key] for unit in units if unit.key in known], interrupted=True)
        except ProgPromptError as error:
            raise click.ClickException(str(error)) from error


def finish(out: Path, made: Made, total: int) -> None:
    """Say what there is and where; after an interrupt the command ends as interrupted ones do."""
    done = len(made.results)
    if done < total:
        click.echo(f"{total - done} of {total} attempts are left; run it again to go on.")
    click.echo("\n".join(str(out / name) for name in FILES))
    if made.interrupted:
        raise SystemExit(INTERRUPTED)


def _minutes(seconds: float) -> str:
    return f"{seconds / 60:.0f} min" if seconds >= 90 else f"{seconds:.0f} s"
