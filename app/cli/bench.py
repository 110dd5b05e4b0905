"""``progprompt bench``: measure parts of the system on this machine."""

import dataclasses
import json

import click
from rich.console import Console
from rich.progress import Progress

from app.cli.api_bench import api
from app.cli.bench_options import AS_JSON, SEED, seeing
from app.cli.fuzz_bench import fuzz
from app.cli.household_bench import household
from app.cli.model_bench import model
from app.cli.verb_benches import pairs, tower, verb
from app.domain.perception import Perception
from app.evaluation.pick import Episode, PickReport, bench_pick
from app.evaluation.readiness import bench_scene
from app.evaluation.robot import RobotRow, robot_tasks, run_robot_task
from app.evaluation.scaling import ScalingRow, bench_parallel
from app.llm.models import open_model
from app.main.models import llm_config
from app.settings import Settings
from app.worlds.simulators.mujoco.arms import DEFAULT_ARM, arms


@click.group()
def command() -> None:
    """Measure parts of the system on this machine."""


for each in (verb, tower, pairs, household, fuzz, api, model):
    command.add_command(each)


@command.command()
@click.option("--episodes", default=50, show_default=True, type=click.IntRange(min=1))
@SEED
@click.option("--workers", default=1, show_default=True, type=click.IntRange(1, 64))
@click.option("--robot", default=DEFAULT_ARM, show_default=True, type=click.Choice(list(arms)),
              help="The arm that picks.")  # fmt: skip
@seeing
@AS_JSON
def pick(
    episodes: int, seed: int, workers: int, robot: str, perception: Perception, as_json: bool
) -> None:
    """Pick random objects and put them into random containers; nothing else needs to run."""
    with Progress(console=Console(stderr=True)) as progress:
        bar = progress.add_task("picking", total=episodes)

        def tell(episode: Episode) -> None:
            progress.advance(bar)
            if episode.failure:
                what = f"{episode.item} to {episode.container}, scene seed {episode.seed}"
                progress.console.print(f"{what}: {episode.failure}", highlight=False)

        report = bench_pick(
            episodes, seed, robot=robot, perception=perception, workers=workers, on_episode=tell
        )
    click.echo(json.dumps(dataclasses.asdict(report)) if as_json else _text(report))


@command.command()
@click.option("--layouts", default=10, show_default=True, type=click.IntRange(min=1))
@click.option("--model", default="default", show_default=True)
@seeing
@AS_JSON
def robot(layouts: int, model: str, perception: Perception, as_json: bool) -> None:
    """The paper's four robot tasks with 0 to 4 distractors: SR, Plan SR, GCR and Exec."""
    settings = Settings.from_environment()
    name = settings.model if model == "default" else model
    tasks = robot_tasks()
    rows: list[RobotRow] = []
    with Progress(console=Console(stderr=True)) as progress:
        bar = progress.add_task("rolling out", total=len(tasks) * layouts)
        opened = open_model(name, llm_config(settings))
        for task in tasks:
            row = run_robot_task(task, opened, layouts, perception, lambda _: progress.advance(bar))
            rows.append(row)
            progress.console.print(_row(rows[-1]), highlight=False)
    if as_json:
        click.echo(json.dumps([dataclasses.asdict(row) for row in rows]))
    else:
        click.echo("\n".join(map(_row, rows)))


@command.command()
@click.option("--episodes", default=16, show_default=True, type=click.IntRange(min=1))
@SEED
@click.option("--workers", default=2, show_default=True, type=click.IntRange(1, 64))
@click.option("--json", "as_json", is_flag=True, help="One JSON array on standard output.")
def parallel(episodes: int, seed: int, workers: int, as_json: bool) -> None:
    """The same picks over 1, 2, 4 … worker processes: how the speed grows with them."""
    rows = bench_parallel(episodes, seed, workers)
    if as_json:
        click.echo(json.dumps([dataclasses.asdict(row) for row in rows]))
    else:
        click.echo("\n".join(map(_scaling, rows)))


@command.command()
@click.option("--objects", default=12, show_default=True, type=click.IntRange(1, 40))
@click.option("--scenes", default=20, show_default=True, type=click.IntRange(min=1))
@SEED
@AS_JSON
def scene(objects: int, scenes: int, seed: int, as_json: bool) -> None:
    """Open random scenes: seconds of CPU from their names until everything stands ready."""
    report = bench_scene(objects, scenes, seed)
    if as_json:
        click.echo(json.dumps(dataclasses.asdict(report)))
        return
    click.echo(
        f"{report.objects} objects ready in {report.median_seconds:.3f} s of CPU (median of "
        f"{report.scenes}), slowest {report.slowest_seconds:.3f} s, the first in this process "
        f"{report.first_seconds:.3f} s"
    )


def _scaling(row: ScalingRow) -> str:
    return (
        f"{row.workers:2d} workers | {row.episodes_per_second:.2f} picks/s | speed-up "
        f"{row.speedup:.2f} | {row.efficiency:.0%} of the cores they have | "
        f"{row.realtime_factor:.1f} x real time"
    )


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

    seeing = report.perception
    seen = f"cameras, noise {1000 * seeing.noise:.1f} mm, confusion {seeing.confusion:.0%}"
    lines = [
        f"episodes            {report.episodes} (seed {report.seed})",
        f"robot               {report.robot}",
        f"perception          {seen if seeing.source == 'cameras' else 'privileged'}",
        f"success             {rate(report.success, report.success_interval)}",
        f"at first attempt    {rate(report.first_attempt, report.first_attempt_interval)}",
        f"CPU per pick        {report.cpu_seconds_median:.2f} s (median)",
        f"simulated per pick  {report.sim_seconds_median:.1f} s (median)",
        f"scene ready in      {report.ready_seconds_median:.3f} s of CPU (median)",
        f"speed               {report.realtime_factor:.1f} x real time",
    ]
    return "\n".join([*lines, *(f"{n:4d} x  {why}" for why, n in report.failures.items())])
