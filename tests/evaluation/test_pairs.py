import pytest

from app.evaluation.pairs import Pair, every_pair, try_pair

pytestmark = pytest.mark.physics


def test_there_is_a_pair_for_every_kind_and_every_plain_container():
    pairs = list(every_pair())
    assert len(pairs) == len(set(pairs)) > 400
    assert ("apple", "bowl") in pairs
    assert ("bowl", "bowl") not in pairs


@pytest.mark.parametrize("pair", list(every_pair())[5::67], ids=" into ".join)
def test_what_is_let_down_into_a_container_neither_flies_nor_sinks_nor_jitters(pair):
    assert try_pair(*pair).fault is None


@pytest.mark.parametrize(
    ("change", "fault"),
    [
        ({"fastest": 2.0}, "flies"),
        ({"deepest": 0.01}, "sinks in"),
        ({"drift": 0.1}, "does not rest"),
    ],
)
def test_what_is_wrong_with_a_pair_is_told(change, fault):
    fine = {"deepest": 0.0, "fastest": 0.2, "drift": 0.0, "rolling": False}
    assert Pair(item="apple", container="bowl", **fine).fault is None
    assert Pair(item="apple", container="bowl", **(fine | change)).fault == fault


def test_what_is_wider_than_the_floor_of_a_bowl_is_let_go_above_its_walls():
    assert try_pair("cracker_box", "bowl").fault is None
