import io

import mujoco
import numpy as np
import pytest
import trimesh

from app.view.solids import body_glb


def load(glb):
    return trimesh.load_scene(io.BytesIO(glb), file_type="glb")


def body(model, name):
    return load(body_glb(model, model.body(name).id))


def test_collision_shapes_are_not_drawn(model):
    width = body(model, "arm").extents.max()
    assert width == pytest.approx(0.26, abs=1e-3)  # the capsule's length, not the box around it


def test_a_plane_without_end_is_not_drawn(model):
    assert body_glb(model, 0) is None


def test_a_box_has_twelve_triangles_and_flat_sides(model):
    (box,) = body(model, "object/0").geometry.values()
    assert len(box.faces) == 12
    assert box.extents == pytest.approx([0.04] * 3)
    assert np.abs(box.vertex_normals).max(axis=1) == pytest.approx(1)


def test_colours_keep_their_look(model):
    (box,) = body(model, "object/0").geometry.values()
    assert list(box.visual.material.baseColorFactor) == [255, 0, 0, 255]


def test_equal_bodies_are_made_once(model):
    copy = mujoco.MjModel.from_xml_string(
        "<mujoco><worldbody><body><freejoint/>"
        '<geom type="box" size="0.02 0.02 0.02" rgba="1 0 0 1"/></body></worldbody></mujoco>'
    )
    assert body_glb(copy, 1) is body_glb(model, model.body("object/0").id)


def test_a_fine_mesh_is_drawn_with_fewer_triangles_at_the_same_size():
    ball = trimesh.creation.icosphere(subdivisions=5, radius=0.1)
    spec = mujoco.MjSpec()
    mesh = spec.add_mesh(name="ball")
    mesh.uservert = ball.vertices.ravel()
    mesh.userface = ball.faces.ravel()
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname="ball")
    (drawn,) = load(body_glb(spec.compile(), 0)).geometry.values()
    assert len(drawn.faces) < 0.8 * len(ball.faces)
    assert drawn.extents == pytest.approx([0.2] * 3, abs=0.01)
    drawn.merge_vertices(merge_norm=True, merge_tex=True)
    uses = np.unique(drawn.edges_sorted, axis=0, return_counts=True)[1]
    assert uses.min() >= 2  # no hole: an edge of one triangle only would be a rim
