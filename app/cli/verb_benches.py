"""What ``progprompt bench`` measures of the verbs and of the object kinds."""

import dataclasses
import json

import click
from rich.console import Console
from rich.progress import Progress

from app.cli.bench_options import AS_JSON, PERCEPTION, SEED, Source
from app.domain.perception import Perception
from app.evaluation.pairs import bench_pairs, every_pair
from app.evaluation.tower import Tower, bench_tower
from app.evaluation.verb import VerbReport, VerbTrial, bench_verb
from app.evaluation.verb_cases import CASES


@click.command()
@click.argument("name", type=click.Choice(sorted(CASES)))
@click.option("--layouts", default=20, show_default=True, type=click.IntRange(min=1))
@SEED
@PERCEPTION
@AS_JSON
def verb(name: str, layouts: int, seed: int, source: Source, as_json: bool) -> None:
    """One verb on random tables."""
    with Progress(console=Console(stderr=True)) as progress:
        bar = progress.add_task(name, total=layouts)

        def tell(trial: VerbTrial) -> None:
            progress.advance(bar)
            if trial.failure:
                line = f"{trial.call}, scene seed {trial.seed}: {trial.failure}"
                progress.console.print(line, highlight=False)

        sight = Perception(source=source)
        report = bench_verb(name, layouts, seed, perception=sight, on_trial=tell)
    click.echo(json.dumps(dataclasses.asdict(report)) if as_json else _text(report))


@click.command()
@click.option("--towers", default=20, show_default=True, type=click.IntRange(min=1))
@SEED
@PERCEPTION
@AS_JSON
def tower(towers: int, seed: int, source: Source, as_json: bool) -> None:
    """Five blocks stacked on one another."""
    with Progress(console=Console(stderr=True)) as progress:
        bar = progress.add_task("stacking", total=towers)

        def tell(built: Tower) -> None:
            progress.advance(bar)
            if built.failure:
                line = f"seed {built.seed}, {built.height} high: {built.failure}"
                progress.console.print(line, highlight=False)

        report = bench_tower(towers, seed, perception=Perception(source=source), on_tower=tell)
    if as_json:
        click.echo(json.dumps(dataclasses.asdict(report)))
        return
    low, high = report.success_interval
    click.echo(
        f"{report.blocks} blocks high  {report.success:.1%} of {report.towers} "
        f"(95 % interval {low:.1%} to {high:.1%}), {report.mean_height:.2f} blocks on average"
    )


@click.command()
def pairs() -> None:
    """Every object kind let down into every container: nothing may fly, sink in or jitter."""
    every = list(every_pair())
    with Progress(console=Console(stderr=True)) as progress:
        bar = progress.add_task("letting down", total=len(every))
        tried = bench_pairs(iter(every), lambda _: progress.advance(bar))
    faults = [pair for pair in tried if pair.fault]
    for pair in faults:
        click.echo(f"{pair.item} into {pair.container} {pair.fault}")
    click.echo(f"{len(tried) - len(faults)} of {len(tried)} pairs hold")


def _text(report: VerbReport) -> str:
    low, high = report.success_interval
    lines = [
        f"{report.verb}: {report.successes} of {report.layouts} layouts (seed {report.seed})",
        f"success             {report.success:.1%} (95 % interval {low:.1%} to {high:.1%})",
        f"at first attempt    {report.first_attempt:.1%}",
        f"CPU per call        {report.cpu_seconds_median:.2f} s (median)",
        f"simulated per call  {report.sim_seconds_median:.1f} s (median)",
    ]
    return "\n".join([*lines, *(f"{n:4d} x  {why}" for why, n in report.failures.items())])
