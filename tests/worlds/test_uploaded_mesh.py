"""What strangers send as meshes: read as it stands, or refused with the reason."""

import json
import struct

import numpy as np
import pytest
import trimesh

from app.domain.errors import AssetRefused
from app.worlds.simulators.mujoco.convex_parts import convex_parts, hull_of
from app.worlds.simulators.mujoco.upload import Format, Upload
from app.worlds.simulators.mujoco.uploaded_mesh import MAX_FACES, read_mesh

GLTF = {"asset": {"version": "2.0"}}


def exported(mesh):
    data = mesh.export(file_type="glb")
    assert isinstance(data, bytes)
    return data


def glb(tree):
    text = json.dumps(GLTF | tree).encode()
    text += b" " * (-len(text) % 4)
    chunk = struct.pack("<2I", len(text), 0x4E4F534A) + text
    return struct.pack("<3I", 0x46546C67, 2, 12 + len(chunk)) + chunk


NOT_MESHES: dict[str, tuple[Format, bytes, str]] = {
    "nothing": ("stl", b"", "cannot be read|no triangles"),
    "noise": ("stl", b"\x00\xff" * 200, "cannot be read|no triangles"),
    "a promise": (
        "stl",
        b"\0" * 80 + struct.pack("<I", 2**31) + b"\0" * 50,
        "cannot be read|no triangles",
    ),
    "numbers that are none": (
        "obj",
        b"v 0 0 0\nv nan 0 .1\nv .1 .1 .1\nf 1 2 3\n",
        "no triangles",
    ),
    "no GLB": ("glb", b"glTF" + b"\0" * 40, "no GLB"),
    "a list": ("glb", glb({"buffers": 3}), "no list"),
    "a reference": ("glb", glb({"buffers": [{"uri": "/etc/passwd"}]}), "outside itself"),
    "a picture": ("glb", glb({"images": [{"uri": "http://127.0.0.1/x.png"}]}), "outside itself"),
    "an extension": ("glb", glb({"extensionsRequired": ["packed"]}), "extensions"),
    "a bomb": ("glb", glb({"accessors": [{"count": 10**12, "type": "VEC3"}]}), "larger than"),
    "a crowd": ("glb", glb({"nodes": [{}] * 10_001}), "nodes"),
}


@pytest.mark.parametrize("name", NOT_MESHES)
def test_what_is_no_mesh_is_refused_with_the_reason(name):
    form, data, reason = NOT_MESHES[name]
    with pytest.raises(AssetRefused, match=reason) as refused:
        read_mesh(data, Upload(format=form))
    assert refused.value.faults[0].field == "body"


def test_one_mesh_shown_a_thousand_times_counts_a_thousand_times():
    scene, ball = trimesh.Scene(), trimesh.creation.icosphere(3, 0.001)
    for index in range(MAX_FACES // len(ball.faces) + 1):
        moved = trimesh.transformations.translation_matrix((0.0001 * index, 0, 0))
        scene.add_geometry(ball, geom_name="ball", node_name=f"ball {index}", transform=moved)
    data = exported(scene)
    assert len(data) < 500_000
    with pytest.raises(AssetRefused, match="faces; at most"):
        read_mesh(data, Upload(format="glb", up="y"))


def test_an_obj_does_not_open_the_material_file_it_names(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "secret.mtl").write_text("newmtl a\nKd broken\n")
    box = trimesh.creation.box((0.05, 0.05, 0.05)).export(file_type="obj")
    mesh = read_mesh(f"mtllib secret.mtl\nusemtl a\n{box}".encode(), Upload(format="obj"))
    assert mesh.extents == pytest.approx([0.05] * 3)


def test_it_stands_on_the_table_with_the_axis_up_that_was_said():
    box = trimesh.creation.box((0.03, 0.09, 0.05))
    box.apply_translation((1.0, 2.0, 3.0))
    mesh = read_mesh(exported(box), Upload(format="glb", up="y"))
    assert mesh.bounds == pytest.approx(
        np.array([[-0.025, -0.015, 0], [0.025, 0.015, 0.09]]), abs=1e-6
    )
    assert mesh.volume == pytest.approx(0.03 * 0.09 * 0.05, rel=1e-4)  # not inside out


def test_a_flat_sheet_is_no_solid():
    sheet = b"v 0 0 0\nv .1 0 .1\nv .1 .1 .1\nv 0 .1 0\nf 1 2 3\nf 1 3 4\n"
    with pytest.raises(AssetRefused, match="flat"):
        hull_of(read_mesh(sheet, Upload(format="obj")))


def test_a_convex_mesh_is_one_part_and_a_ring_is_several_that_leave_its_hole():
    assert len(convex_parts(trimesh.creation.icosphere(2, 0.02))) == 1
    ring = trimesh.creation.annulus(r_min=0.02, r_max=0.03, height=0.02, sections=24)
    ring.apply_translation((0, 0, 0.01))
    parts = convex_parts(ring)
    assert len(parts) >= 4
    hulls = [trimesh.convex.convex_hull(part) for part in parts]
    assert not any(hull.contains([[0, 0, 0.01]])[0] for hull in hulls if hull.is_watertight)
    assert sum(hull.volume for hull in hulls) == pytest.approx(ring.volume, rel=0.25)
    assert min(float(part[:, 2].min()) for part in parts) >= 0.0
