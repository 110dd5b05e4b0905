"""``progprompt bench``: measure parts of the system on this machine."""

import dataclasses
import json

import click
from rich.console import Console
from rich.progress import Progress

from app.evaluation.pick import Episode, PickReport, bench_pick

command = click.Group("bench", help="Measure parts of the system on this machine.")


@command.command()
@click.option("--episodes", default=50, show_default=True, type=click.IntRange(min=1))
@click.option("--seed", default=0, show_default=True, type=click.IntRange(min=0))
@click.option("--workers", default=1, show_default=True, type=click.IntRange(1, 64))
@click.option("--json", "as_json", is_flag=True, help="One JSON object on standard output.")
def pick(episodes: int, seed: int, workers: int, as_json: bool) -> None:
    """Pick random objects and put them into random containers; nothing else needs to run."""
    with Progress(console=Console(stderr=True)) as progress:
        bar = progress.add_task("picking", total=episodes)

        def tell(episode: Episode) -> None:
            progress.advance(bar)
            if episode.failure:
                what = f"{episode.item} to {episode.container}, scene seed {episode.seed}"
                progress.console.print(f"{what}: {episode.failure}", highlight=False)

        report = bench_pick(episodes, seed, workers=workers, on_episode=tell)
    click.echo(json.dumps(dataclasses.asdict(report)) if as_json else _text(report))


def _text(report: PickReport) -> str:
    def rate(value: float, interval: tuple[float, float]) -> str:
        return f"{value:.1%} (95 % interval {interval[0]:.1%} to {interval[1]:.1%})"

    lines = [
        f"episodes            {report.episodes} (seed {report.seed})",
        f"success             {rate(report.success, report.success_interval)}",
        f"at first attempt    {rate(report.first_attempt, report.first_attempt_interval)}",
        f"CPU per pick        {report.cpu_seconds_median:.2f} s (median)",
        f"simulated per pick  {report.sim_seconds_median:.1f} s (median)",
        f"speed               {report.realtime_factor:.1f} x real time",
    ]
    return "\n".join([*lines, *(f"{n:4d} x  {why}" for why, n in report.failures.items())])
