import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.worlds.simulators.mujoco.kinematics import (
    CLEARANCE,
    HOME,
    LOWER,
    UPPER,
    forward,
    inverse,
    line,
)

inside = st.tuples(
    *(
        st.floats(low + 2 * CLEARANCE, high - 2 * CLEARANCE)
        for low, high in zip(LOWER, UPPER, strict=True)
    )
)


@settings(deadline=None, max_examples=60)
@given(joints=inside)
def test_every_solution_brings_the_tool_to_the_pose_asked_for(joints):
    pose = forward(np.array(joints))
    for found in inverse(pose, HOME):
        assert np.allclose(forward(found), pose, atol=2e-4)
        assert np.all(found > LOWER)
        assert np.all(found < UPPER)


def test_solutions_come_with_the_least_motion_first():
    pose = forward(HOME)
    found = inverse(pose, HOME)
    assert len(found) > 1
    largest = np.abs(found - HOME).max(axis=1)
    assert largest[0] == pytest.approx(largest.min(), abs=0.3)


def test_a_pose_out_of_reach_has_no_solution():
    pose = forward(HOME)
    pose[0, 3] = 2.0
    assert inverse(pose, HOME).shape == (0, 7)


def test_a_line_is_straight_and_keeps_the_orientation():
    start = forward(HOME)
    end = start.copy()
    end[2, 3] -= 0.1
    path = line(start, end, HOME)
    assert path is not None
    poses = np.array([forward(joints) for joints in path])
    assert np.allclose(poses[:, :2, 3], start[:2, 3], atol=1e-4)
    assert np.allclose(poses[:, :3, :3], start[:3, :3], atol=2e-4)
    assert np.all(np.diff(poses[:, 2, 3]) < 0)
    assert np.allclose(poses[-1], end, atol=2e-4)


def test_a_line_that_leaves_the_reach_is_refused():
    start = forward(HOME)
    end = start.copy()
    end[0, 3] += 0.8
    assert line(start, end, HOME) is None
