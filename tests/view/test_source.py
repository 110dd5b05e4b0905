import numpy as np
import pytest

from app.view import source
from app.view.source import Footage


@pytest.fixture(autouse=True)
def impatient(monkeypatch):
    monkeypatch.setattr(source, "READ_EVERY", 0.0)


def test_footage_reads_only_what_is_new(growing):
    footage = Footage(growing)
    footage.refresh()
    growing.known = 20
    footage.refresh()
    assert growing.asked == [0, 10]
    assert footage.duration == pytest.approx(19 / 30)


def test_footage_of_a_finished_rollout_asks_no_more(rollout):
    footage = Footage(rollout)
    footage.refresh()
    footage.refresh()
    assert footage.finished
    assert rollout.asked == [0]


def test_frames_that_come_with_the_end_are_not_missed(growing):
    footage = Footage(growing)
    footage.refresh()
    growing.known = 30
    footage.refresh()
    assert footage.finished
    assert footage.duration == pytest.approx(29 / 30)


def test_before_the_first_frame_everything_stands_as_modelled(growing, model):
    growing.known = 0
    footage = Footage(growing)
    footage.refresh()
    assert footage.duration == 0
    np.testing.assert_array_equal(footage.at(3.0), model.qpos0)


def test_between_two_frames_the_motion_goes_on_evenly(rollout):
    footage = Footage(rollout)
    footage.refresh()
    assert footage.at(10.25 / 30)[0] == pytest.approx(10.25 / 30)


def test_turning_between_two_frames_keeps_quaternions_whole(model, frames):
    turned = frames[:2].copy()
    turned[1, 5:9] = [0, 0, 0, 1]

    class HalfTurn:
        def model(self):
            return model

        def frames(self, after):
            return turned[after:]

        def finished(self):
            return True

    footage = Footage(HalfTurn())
    footage.refresh()
    between = footage.at(turned[1, 0] / 2)[4:8]
    assert np.linalg.norm(between) == pytest.approx(1)
    assert abs(between[0]) == pytest.approx(np.sqrt(0.5))


def test_after_the_last_frame_it_stays_as_it_was(rollout, frames):
    footage = Footage(rollout)
    footage.refresh()
    np.testing.assert_array_equal(footage.at(99.0), frames[-1, 1:])
