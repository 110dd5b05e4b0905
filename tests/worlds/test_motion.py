from itertools import pairwise

import numpy as np

from app.worlds.simulators.mujoco.arms import arms
from app.worlds.simulators.mujoco.motion import free_path, timed

ARM = arms["panda"]
HOME = ARM.home
GOAL = HOME + np.array([1.2, 0.3, 0.0, 0.0, 0.0, 0.0, 0.0])
TIMESTEP = 0.002


def pillar(joints):
    """A wall across the straight line from HOME to GOAL, with a way around it."""
    return abs(joints[0] - 0.6) < 0.1 and joints[1] > -0.6


def test_a_free_straight_line_is_taken():
    path = free_path(ARM, HOME, GOAL, lambda _: False, np.random.default_rng(0))
    assert path is not None
    assert np.array_equal(path, [HOME, GOAL])


def test_a_wall_is_gone_around():
    path = free_path(ARM, HOME, GOAL, pillar, np.random.default_rng(0))
    assert path is not None
    assert len(path) > 2
    assert np.array_equal(path[[0, -1]], [HOME, GOAL])
    for start, end in pairwise(path):
        assert not any(pillar(start + (end - start) * share) for share in np.linspace(0, 1, 50))


def test_the_same_stream_of_random_numbers_gives_the_same_path():
    first, second = (free_path(ARM, HOME, GOAL, pillar, np.random.default_rng(3)) for _ in range(2))
    assert first is not None
    assert second is not None
    assert np.array_equal(first, second)


def test_a_blocked_goal_has_no_path():
    assert free_path(ARM, HOME, GOAL, lambda q: q[0] > 1.0, np.random.default_rng(0)) is None


def test_a_goal_walled_in_exhausts_the_budget():
    def shell(joints):
        return 0.2 < np.abs(joints - GOAL).max() < 0.6

    assert free_path(ARM, HOME, GOAL, shell, np.random.default_rng(0)) is None


def test_a_course_starts_and_ends_at_rest_within_the_limits():
    points, velocities = timed(ARM, np.array([HOME, GOAL]), 1.0, TIMESTEP)
    assert np.allclose(points[-1], GOAL)
    assert np.abs(points[0] - HOME).max() < 1e-6
    assert np.abs(velocities[[0, -1]]).max() < 0.01
    assert np.all(np.abs(velocities) <= ARM.speed * 1.001)
    accelerations = np.gradient(velocities, TIMESTEP, axis=0)[2:-2]
    assert np.all(np.abs(accelerations) <= ARM.acceleration * 1.01)


def test_half_the_speed_takes_longer():
    path = np.array([HOME, GOAL])
    fast, slow = (len(timed(ARM, path, speed, TIMESTEP)[0]) for speed in (1.0, 0.5))
    assert slow > 1.8 * fast
