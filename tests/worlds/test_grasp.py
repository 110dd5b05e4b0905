import numpy as np
import pytest

from app.worlds.simulators.mujoco.cameras import Cloud
from app.worlds.simulators.mujoco.grasp import SLANTED, STEEP, candidates, distinct


def box_cloud(length, width, height, centre=(0.5, 0.1)):
    """The five visible faces of a box on the table, its length along x."""
    half = np.array([length, width, height]) / 2
    middle = np.array([*centre, height / 2])
    points, normals = [], []
    for axis, sign in ((0, -1), (0, 1), (1, -1), (1, 1), (2, 1)):
        others = [other for other in range(3) if other != axis]
        grid = [np.linspace(-half[other], half[other], 12) for other in others]
        face = np.zeros((144, 3))
        face[:, others[0]], face[:, others[1]] = (g.ravel() for g in np.meshgrid(*grid))
        face[:, axis] = sign * half[axis]
        normal = np.zeros((144, 3))
        normal[:, axis] = sign
        points.append(face + middle)
        normals.append(normal)
    return Cloud(np.concatenate(points), np.concatenate(normals))


def test_the_best_grasp_of_a_long_box_closes_across_its_narrow_side():
    best = candidates(box_cloud(0.14, 0.04, 0.04), STEEP, np.random.default_rng(0))[0]
    assert best.width == pytest.approx(0.04, abs=0.002)
    assert abs(best.tool[1, 1]) > 0.99  # the closing direction is along y
    assert best.tool[2, 2] < -0.99  # from above
    assert np.linalg.norm(best.tool[:2, 3] - [0.5, 0.1]) < 0.015
    assert best.quality > 0.9


def test_every_grasp_is_a_rotation_above_the_table_with_the_object_between_the_fingers():
    grasps = candidates(box_cloud(0.06, 0.04, 0.08), (*STEEP, *SLANTED), np.random.default_rng(0))
    assert grasps
    for grasp in grasps:
        rotation = grasp.tool[:3, :3]
        assert np.allclose(rotation.T @ rotation, np.eye(3), atol=1e-9)
        assert np.linalg.det(rotation) == pytest.approx(1.0)
        assert grasp.tool[2, 3] > 0.005
        assert grasp.width <= 0.072


def test_what_is_too_wide_has_no_good_grasp():
    grasps = candidates(box_cloud(0.12, 0.12, 0.1), STEEP, np.random.default_rng(0))
    assert all(grasp.quality < 0.75 for grasp in grasps)  # only corners are left to pinch


def test_distinct_grasps_are_not_alike_and_keep_their_order():
    grasps = candidates(box_cloud(0.14, 0.04, 0.04), STEEP, np.random.default_rng(0))
    chosen = distinct(grasps, 10)
    assert len(chosen) == 10
    assert chosen[0] is grasps[0]
    scores = [grasp.score for grasp in chosen]
    assert scores == sorted(scores, reverse=True)
    pairs = [(a, b) for i, a in enumerate(chosen) for b in chosen[:i]]
    assert not any(a.like(b, within=0.008) for a, b in pairs)
