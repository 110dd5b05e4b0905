import numpy as np
import pytest

from app.worlds.simulators.mujoco.detector import SOMETHING_ELSE, Confused, Segmentation

TRUTH = Segmentation([(3,), (4, 5), (6,), (7,)], 9)
NOWHERE = np.zeros((0, 3))
BODIES = np.array([[0, 3, 4], [5, 6, 7]], np.int32)


def test_an_objects_parts_have_one_label_and_the_rest_has_none():
    expected = [[SOMETHING_ELSE, 0, 1], [1, 2, 3]]
    assert TRUTH.label(BODIES, NOWHERE).tolist() == expected


def test_without_confusion_everything_is_what_it_is():
    assert np.array_equal(
        Confused(TRUTH, 4, 0.0, 1).label(BODIES, NOWHERE), TRUTH.label(BODIES, NOWHERE)
    )


def test_at_full_rate_all_are_taken_for_one_another_in_pairs():
    labels = Confused(TRUTH, 4, 1.0, 1).label(np.array([3, 4, 6, 7], np.int32), NOWHERE)
    assert sorted(labels.tolist()) == [0, 1, 2, 3]
    assert all(label != index for index, label in enumerate(labels.tolist()))
    assert [labels[label] for label in labels] == [0, 1, 2, 3]


def test_the_rate_is_the_share_of_objects_mistaken():
    bodies = np.array([3, 4, 6, 7], np.int32)
    wrong = [
        np.mean(Confused(TRUTH, 4, 0.3, seed).label(bodies, NOWHERE) != [0, 1, 2, 3])
        for seed in range(300)
    ]
    assert np.mean(wrong) == pytest.approx(0.3, abs=0.06)


def test_the_same_seed_confuses_alike():
    first, second = (Confused(TRUTH, 4, 0.5, 7).label(BODIES, NOWHERE) for _ in range(2))
    assert np.array_equal(first, second)
