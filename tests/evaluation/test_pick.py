import json

import pytest
from click.testing import CliRunner

from app.cli.bench import command
from app.domain.perception import Perception
from app.evaluation.pick import bench_pick, run_episode
from app.evaluation.readiness import bench_scene
from app.evaluation.scaling import bench_parallel

pytestmark = pytest.mark.physics


def test_an_episode_depends_on_its_seed_and_number_alone():
    first, second = run_episode((5, 1)), run_episode((5, 1))
    assert (first.item, first.container, first.sim_seconds, first.failure) == (
        second.item,
        second.container,
        second.sim_seconds,
        second.failure,
    )
    assert first.attempts >= 1
    assert 1 <= first.distractors <= 4


@pytest.mark.parametrize(
    "index",
    [
        pytest.param(145, id="a cucumber too long to lie in its bowl"),
        pytest.param(444, id="a carrot that hung low while it was carried over a rim"),
        pytest.param(462, id="a pen in a basket, too thin to be seen from afar"),
    ],
)
def test_a_layout_that_once_went_wrong_succeeds_at_the_first_attempt(index):
    episode = run_episode((910261, index))
    assert (episode.failure, episode.attempts) == (None, 1)


def test_the_report_counts_what_was_told():
    told = []
    report = bench_pick(2, 5, on_episode=told.append)
    assert report.episodes == len(told) == 2
    assert report.success == sum(episode.failure is None for episode in told) / 2
    assert report.success_interval[0] <= report.success <= report.success_interval[1]
    assert report.first_attempt <= report.success
    assert sum(report.failures.values()) == len(report.failed)


def test_privileged_perception_and_cameras_are_told_apart_in_the_report():
    report = bench_pick(1, 5, perception=Perception(source="privileged"))
    assert report.perception.source == "privileged"
    assert bench_pick(0, 5).perception == Perception(source="cameras", noise=0.002)


def test_the_same_picks_run_in_worker_processes():
    (row,) = bench_parallel(2, 5, 1)
    assert (row.workers, row.episodes, row.speedup) == (1, 2, 1.0)
    assert row.episodes_per_second == pytest.approx(2 / row.wall_seconds)
    assert row.realtime_factor > 0


def test_a_scene_is_ready_after_some_time():
    report = bench_scene(12, 3, 0)
    assert (report.objects, report.scenes) == (12, 3)
    assert 0 < report.median_seconds <= max(report.slowest_seconds, report.first_seconds)


def test_the_command_takes_how_the_robot_sees():
    arguments = ["pick", "--episodes", "1", "--seed", "5", "--noise", "1", "--confusion", "0.5"]
    result = CliRunner().invoke(command, [*arguments, "--json"])
    assert result.exit_code == 0, result.output
    seen = {"source": "cameras", "noise": 0.001, "detector": "segmentation", "confusion": 0.5}
    assert json.loads(result.stdout)["perception"] == seen


def test_the_command_takes_which_robot_picks():
    arguments = ["pick", "--episodes", "1", "--seed", "5", "--robot", "ur5e", "--json"]
    result = CliRunner().invoke(command, arguments)
    assert result.exit_code == 0, result.output
    assert json.loads(result.stdout)["robot"] == "ur5e"


def test_the_command_prints_one_json_object():
    result = CliRunner().invoke(command, ["pick", "--episodes", "1", "--seed", "5", "--json"])
    assert result.exit_code == 0, result.output
    report = json.loads(result.stdout)
    wanted = "episodes success first_attempt cpu_seconds_median sim_seconds_median realtime_factor"
    assert set(wanted.split()) <= set(report)
    assert isinstance(report["failures"], dict)
