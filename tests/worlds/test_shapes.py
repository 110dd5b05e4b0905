import numpy as np
import pytest
from scipy.spatial import ConvexHull

from app.worlds.simulators.mujoco.shapes import (
    Mesh,
    box,
    ellipsoid,
    globe,
    lying,
    prism,
    revolve,
    ring_wedges,
    tube,
)


def volume(mesh: Mesh) -> float:
    """By the divergence theorem; right only for a closed surface with its faces outwards."""
    first, second, third = np.moveaxis(mesh.vertices[mesh.faces], 1, 0)
    return float(np.einsum("ij,ij->i", first, np.cross(second, third)).sum() / 6)


@pytest.mark.parametrize(
    "mesh",
    [
        box((0.05, 0.03, 0.004), (0.1, 0.2, 0.3), bevel=0.0015),
        box((0.1, 0.01, 0.02), (0.1, 0.0, -0.3)),
        ellipsoid((0.03, 0.02, 0.01), (0, 0, 0.2)),
        globe(0.06, 0.05),
        revolve([(0, 0), (0.5, 0), (0.5, 1), (0, 1)]),
        tube([(0, 0, 0), (0, 0, 0.1)], [0.01, 0.01]),
        tube([(0, 0, 0.1), (0.1, 0, 0)], [0.01, 0.005]),
        prism([(0, 0), (1, 0), (1, 1), (0, 1)], -0.1, 0.2),
        lying([(0, 0), (0.5, 0), (0.5, 1), (0, 1)], 6),
    ],
)
def test_a_convex_shape_is_closed_and_faces_outwards(mesh):
    assert volume(mesh) == pytest.approx(ConvexHull(mesh.vertices).volume, rel=1e-6)


def test_a_cylinder_has_sharp_edges_and_a_ball_has_none():
    edge = revolve([(0, 0), (0.5, 0), (0.5, 1), (0, 1)], segments=12)
    copies = np.unique(edge.vertices.round(9), axis=0, return_counts=True)[1]
    assert len(edge.vertices) == 6 * 12
    assert 2 in copies
    ball = ellipsoid((1, 1, 1), rings=8)
    assert len(ball.vertices) == 8 * 16


def test_what_lies_has_its_underside_on_one_line():
    body = lying([(0, 0), (0.3, 0), (0.5, 0.4), (0.1, 1.0)], 12)
    for x in (0.0, 0.4, 1.0):
        ring = body.vertices[np.abs(body.vertices[:, 0] - x) < 1e-9]
        assert ring[:, 2].min() == pytest.approx(0, abs=1e-9)


def test_wedges_fill_the_shell_between_two_profiles():
    inner, outer = [(0.09, 0.0), (0.09, 0.1)], [(0.1, 0.0), (0.1, 0.1)]
    pieces = ring_wedges(inner, outer, sectors=64)
    shell = np.pi * (0.1**2 - 0.09**2) * 0.1
    assert sum(ConvexHull(piece).volume for piece in pieces) == pytest.approx(shell, rel=0.04)


def test_a_fitted_shape_fills_its_box_standing_on_the_origin():
    fitted = ellipsoid((1, 2, 3), (4, 5, 6)).turned("x", 0.3).fitted((0.1, 0.2, 0.3))
    assert np.allclose(fitted.vertices.min(axis=0), (-0.05, -0.1, 0))
    assert np.allclose(fitted.vertices.max(axis=0), (0.05, 0.1, 0.3))


def test_turning_is_counter_clockwise_about_each_axis():
    point = Mesh(np.array([[1.0, 2.0, 3.0]]), np.zeros((0, 3), np.int32))
    assert np.allclose(point.turned("x", np.pi / 2).vertices, [[1, -3, 2]])
    assert np.allclose(point.turned("y", np.pi / 2).vertices, [[3, 2, -1]])
    assert np.allclose(point.turned("z", np.pi / 2).vertices, [[-2, 1, 3]])
