import json

import numpy as np
import pytest
from click.testing import CliRunner

from app.cli.verb_benches import verb
from app.domain.perception import Perception
from app.evaluation.tower import build_tower
from app.evaluation.verb import bench_verb, run_trial
from app.evaluation.verb_cases import CASES, draw_case
from app.worlds.actions.tabletop import actions

pytestmark = pytest.mark.physics
PRIVILEGED = Perception(source="privileged")


def test_every_verb_has_cases():
    assert set(CASES) == set(actions)


@pytest.mark.parametrize("name", sorted(CASES))
def test_a_case_depends_on_its_seed_alone_and_names_what_is_there(name):
    case, same = (draw_case(name, np.random.default_rng((4, 2))) for _ in range(2))
    assert case == same
    parameters = actions[name].signature.parameters
    assert len(case.arguments) == len(parameters)
    for parameter, argument in zip(parameters, case.arguments, strict=True):
        if parameter.role in ("object", "support", "container"):
            assert argument in case.scene.names


def test_the_report_counts_what_was_told():
    told = []
    report = bench_verb("push", 2, 1, perception=PRIVILEGED, on_trial=told.append)
    assert report.layouts == len(told) == 2
    assert report.successes == sum(trial.failure is None for trial in told)
    assert report.success_interval[0] <= report.success <= report.success_interval[1]
    assert sum(report.failures.values()) == len(report.failed)


@pytest.mark.parametrize(
    ("name", "seed", "index"),
    [
        pytest.param("open", 910262, 0, id="a drawer so close that the hand must lean towards it"),
        pytest.param("push", 910262, 3, id="a knife lower than the finger tips went"),
        pytest.param("stack", 910262, 4, id="a stack the arm struck, not having looked at it"),
        pytest.param("stack", 910262, 18, id="a stack the arm grazed on its way home"),
        pytest.param("pour", 5150, 2, id="a cup the arm struck after it had put it back"),
    ],
)
def test_a_call_that_once_went_wrong_succeeds_at_the_first_attempt(name, seed, index):
    trial = run_trial(name, seed, index)
    assert (trial.failure, trial.attempts) == (None, 1)


def test_a_tower_of_five_blocks_stands():
    built = build_tower(2, PRIVILEGED)
    assert built.failure is None
    assert built.height == 5


def test_the_command_prints_one_json_object():
    arguments = ["open", "--layouts", "1", "--perception", "privileged", "--json"]
    result = CliRunner().invoke(verb, arguments)
    assert result.exit_code == 0, result.output
    assert {"success", "success_interval", "failed"} <= set(json.loads(result.stdout))
