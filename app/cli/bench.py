"""``progprompt bench``: measure parts of the system on this machine."""

import dataclasses
import json

import click
from rich.console import Console
from rich.progress import Progress

from app.evaluation.pick import Episode, PickReport, bench_pick
from app.evaluation.robot import RobotRow, robot_tasks, run_robot_task
from app.llm.models import open_model
from app.main.models import llm_config
from app.settings import Settings

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


@command.command()
@click.option("--layouts", default=10, show_default=True, type=click.IntRange(min=1))
@click.option("--model", default="default", show_default=True)
@click.option("--json", "as_json", is_flag=True, help="One JSON object on standard output.")
def robot(layouts: int, model: str, as_json: bool) -> None:
    """The paper's four robot tasks with 0 to 4 distractors: SR, Plan SR, GCR and Exec."""
    settings = Settings.from_environment()
    name = settings.model if model == "default" else model
    tasks = list(robot_tasks())
    rows: list[RobotRow] = []
    with Progress(console=Console(stderr=True)) as progress:
        bar = progress.add_task("rolling out", total=len(tasks) * layouts)
        opened = open_model(name, llm_config(settings))
        for task in tasks:
            rows.append(run_robot_task(task, opened, layouts, lambda _: progress.advance(bar)))
            progress.console.print(_row(rows[-1]), highlight=False)
    if as_json:
        click.echo(json.dumps([dataclasses.asdict(row) for row in rows]))
    else:
        click.echo("\n".join(map(_row, rows)))


def _row(row: RobotRow) -> str:
    low, high = row.sr_interval
    return (
        f"{row.instruction} | {row.distractors} distractors | SR {row.sr:.2f} ({low:.2f} to "
        f"{high:.2f}) | Plan SR {row.plan_sr:.0f} | GCR {row.gcr:.2f} | Exec {row.exec:.2f} | "
        f"precision {row.precision:.2f} | planned in {row.plan_seconds:.1f} s"
    )


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
