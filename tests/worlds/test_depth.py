import numpy as np

from app.worlds.simulators.mujoco.camera import Camera
from app.worlds.simulators.mujoco.depth import DepthImage

SIZE = 48
CAMERA = Camera((0.5, 0.0, 1.0), (0.5, 0.001, 0.0))


def table(step=0.0):
    """A level surface a metre below the camera, the right half of it higher by a step [m]."""
    labels = np.zeros((SIZE, SIZE), np.int32)
    depths = np.ones((SIZE, SIZE))
    labels[:, SIZE // 2 :] = 1 if step else 0
    depths[:, SIZE // 2 :] -= step
    a, b = Camera(CAMERA.position, CAMERA.target, 0.2).tangents(SIZE, SIZE)
    return DepthImage(labels, depths, (a, b))


def test_a_fitted_surface_is_quieter_than_what_was_measured():
    noisy = table().with_noise(0.002, np.random.default_rng(0))
    measured = np.std(noisy.depths)
    _, points, normals = noisy.surfaces(2)
    assert 0.0018 < measured < 0.0022
    assert np.std(points[:, 2]) < measured / 2
    assert np.degrees(np.arccos(np.median(-normals[:, 2]))) < 15
    assert np.allclose(np.linalg.norm(normals, axis=1), 1.0)


def test_without_noise_the_surface_is_exact():
    labels, points, normals = table().surfaces(2)
    assert len(labels) == SIZE * SIZE
    assert np.allclose(points[:, 2], 1.0)
    assert np.allclose(normals, [0, 0, -1], atol=1e-6)


def test_measurements_drop_out_at_edges_only():
    image = table(step=0.1).with_noise(0.002, np.random.default_rng(0))
    missing = np.flatnonzero((image.labels == -1).any(axis=0))
    assert set(missing) == {SIZE // 2 - 1, SIZE // 2}
    assert 0.3 < np.mean(image.labels[:, missing] == -1) < 0.7


def test_two_surfaces_are_never_averaged():
    labels, points, _ = table(step=0.1).surfaces(2)
    assert np.allclose(points[labels == 0, 2], 1.0)
    assert np.allclose(points[labels == 1, 2], 0.9)


def test_the_same_seed_gives_the_same_noise():
    first, second = (table().with_noise(0.002, np.random.default_rng(5)) for _ in range(2))
    assert np.array_equal(first.depths, second.depths)
