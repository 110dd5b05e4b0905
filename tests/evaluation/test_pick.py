import json

import pytest
from click.testing import CliRunner

from app.cli.bench import command
from app.evaluation.pick import bench_pick, run_episode

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


def test_the_report_counts_what_was_told():
    told = []
    report = bench_pick(2, 5, on_episode=told.append)
    assert report.episodes == len(told) == 2
    assert report.success == sum(episode.failure is None for episode in told) / 2
    assert report.success_interval[0] <= report.success <= report.success_interval[1]
    assert report.first_attempt <= report.success
    assert sum(report.failures.values()) == len(report.failed)


def test_the_command_prints_one_json_object():
    result = CliRunner().invoke(command, ["pick", "--episodes", "1", "--seed", "5", "--json"])
    assert result.exit_code == 0, result.output
    report = json.loads(result.stdout)
    wanted = "episodes success first_attempt cpu_seconds_median sim_seconds_median realtime_factor"
    assert set(wanted.split()) <= set(report)
    assert isinstance(report["failures"], dict)
