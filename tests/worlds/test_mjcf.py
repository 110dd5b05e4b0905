"""What strangers send as MJCF: one rigid body, read as it stands, or refused with the reason."""

import io
import zipfile

import numpy as np
import pytest
import trimesh

from app.domain.errors import AssetRefused
from app.worlds.simulators.mujoco.mjcf import MAX_GEOMS, read_mjcf
from app.worlds.simulators.mujoco.solid_shape import Shape
from app.worlds.simulators.mujoco.upload import Upload, digest

XML, ZIP = Upload(format="xml"), Upload(format="zip")
MALLET = """
<mujoco>
  <!-- a head on a handle -->
  <asset><material name="wood" rgba="0.6 0.4 0.2 1"/></asset>
  <worldbody>
    <body name="mallet" pos="1 2 3">
      <freejoint/>
      <geom type="cylinder" fromto="0 0 0 0 0 0.1" size="0.01" material="wood" mass="0.05"/>
      <geom type="box" pos="0 0 0.11" size="0.03 0.015 0.015" rgba="1 0 0 1" mass="0.1"/>
    </body>
  </worldbody>
</mujoco>
"""


def body(inside, before=""):
    return f"<mujoco>{before}<worldbody><body>{inside}</body></worldbody></mujoco>".encode()


def zipped(**files):
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name.replace("__", "/").replace("_", "."), content)
    return packed.getvalue()


def stl():
    mesh = trimesh.creation.box((0.06, 0.04, 0.02))
    data = mesh.export(file_type="stl")
    assert isinstance(data, bytes)
    return data


def test_a_body_of_primitives_stands_on_its_lowest_point_with_its_mass_and_colours():
    read = read_mjcf(MALLET.encode(), XML)
    assert read.size == pytest.approx((0.06, 0.03, 0.125), abs=1e-3)
    assert read.mass == pytest.approx(0.15)
    handle, head = read.shape.primitives
    assert handle.centre == pytest.approx((0, 0, 0.05), abs=1e-6)
    assert head.centre == pytest.approx((0, 0, 0.11), abs=1e-6)
    assert [look.colour for look in read.shape.looks] == [
        pytest.approx((0.6, 0.4, 0.2, 1)),
        pytest.approx((1, 0, 0, 1)),
    ]


def test_a_mesh_of_the_same_zip_is_found_wherever_its_folder_was():
    text = body(
        '<geom type="mesh" mesh="slab" density="500"/>',
        '<asset><mesh name="slab" file="parts/slab.stl"/></asset>',
    )
    read = read_mjcf(zipped(thing__slab_xml=text, thing__parts__slab_stl=stl()), ZIP)
    assert read.size == pytest.approx((0.06, 0.04, 0.02), abs=1e-3)
    assert read.mass == pytest.approx(500 * 48e-6, rel=1e-3)
    (part,) = read.shape.parts
    assert part[:, 2].min() == pytest.approx(0, abs=1e-6)


def test_an_include_without_a_world_is_a_body_as_well():
    text = b'<mujocoinclude><body><geom size="0.02"/></body></mujocoinclude>'
    assert read_mjcf(text, XML).size == pytest.approx((0.04, 0.04, 0.04), abs=1e-3)


def test_what_a_class_says_is_taken_over():
    free = '<default><default class="loose"><joint type="free"/></default></default>'
    assert read_mjcf(body(f'<joint class="loose"/>{BALL}', free), XML).mass > 0


def test_a_shape_is_the_same_after_it_was_stored():
    shape = read_mjcf(MALLET.encode(), XML).shape
    again = Shape.unpack(shape.pack())
    assert again.primitives == shape.primitives
    for look, before in zip(again.looks, shape.looks, strict=True):
        assert look.colour == pytest.approx(before.colour)
        assert np.allclose(look.mesh.vertices, before.mesh.vertices, atol=1e-6)
        assert np.array_equal(look.mesh.faces, before.mesh.faces)


BALL = '<geom size="0.02"/>'
REFUSED = {
    "no XML": (b"<mujoco><worldbody>", "no XML"),
    "an entity": (b'<!DOCTYPE x [<!ENTITY a "b">]>' + body(BALL), "declaration"),
    "an entity in disguise": (
        ('<!DOCTYPE x [<!ENTITY a "b">]>' + body(BALL).decode()).encode("utf-16"),
        "no XML",
    ),
    "an include": (body(BALL, '<include file="/etc/passwd"/>'), "<include>"),
    "an actuator": (body(BALL, "<actuator/>"), "<actuator>"),
    "a plugin": (body(BALL, "<extension><plugin/></extension>"), "<extension>"),
    "a keyframe": (body(BALL, "<keyframe/>"), "<keyframe>"),
    "copies": (body(f'<replicate count="9999999">{BALL}</replicate>'), "<replicate>"),
    "a plugin of a geom": (body('<geom size="0.02" plugin="x"/>'), "plugin"),
    "a folder": (body(BALL, '<compiler meshdir="/etc"/>'), "meshdir"),
    "a file that is not there": (
        body(
            '<geom type="mesh" mesh="m"/>', '<asset><mesh name="m" file="/etc/hosts.stl"/></asset>'
        ),
        "not in the upload",
    ),
    "a file that is no mesh": (
        body(BALL, '<asset><mesh name="m" file="../../etc/passwd"/></asset>'),
        "are taken",
    ),
    "a hinge": (body(f'<joint type="hinge"/>{BALL}'), "hinge joint"),
    "a joint in a class": (
        body(f'<joint class="j"/>{BALL}', '<default><default class="j"/></default>'),
        "1 joints",
    ),
    "two bodies": (body(f"{BALL}<body>{BALL}</body>"), "2 bodies"),
    "no body": (b"<mujoco><worldbody/></mujoco>", "0 bodies"),
    "loose geoms": (
        b'<mujoco><worldbody><geom size="0.1"/><body><geom size="0.1"/></body></worldbody></mujoco>',
        "outside its body",
    ),
    "a crowd": (body(BALL * (MAX_GEOMS + 1)), "65 geoms"),
    "a plane": (body('<freejoint/><geom type="plane" size="1 1 1" mass="1"/>'), "plane|built"),
    "too large": (body('<geom size="2"/>'), "every side"),
    "too heavy": (body('<geom size="0.02" mass="50"/>'), "weighs 50 kg"),
    "nothing solid": (body('<geom size="0.02" contype="0" conaffinity="0"/>'), "collides"),
    "what physics refuses": (body('<geom type="box" size="-1 0 0"/>'), "built in physics"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_no_rigid_body_is_refused_with_the_reason(name):
    data, reason = REFUSED[name]
    with pytest.raises(AssetRefused, match=reason) as refused:
        read_mjcf(data, XML)
    assert refused.value.faults[0].field == "body"


ZIPS = {
    "no zip": (b"PK" * 50, "as a zip"),
    "no XML in it": (zipped(slab_stl=stl()), "one XML file"),
    "two XML in it": (zipped(a_xml=MALLET, b_xml=MALLET), "a.xml, b.xml"),
    "a bomb": (zipped(a_xml=MALLET, b_stl=b"\0" * 61_000_000), "60 MB"),
    "too many files": (zipped(a_xml=MALLET, **{f"f{n}_stl": b"" for n in range(64)}), "65 files"),
}


@pytest.mark.parametrize("name", ZIPS)
def test_a_zip_that_is_none_is_refused_with_the_reason(name):
    data, reason = ZIPS[name]
    with pytest.raises(AssetRefused, match=reason):
        read_mjcf(data, ZIP)


@pytest.mark.parametrize("field", ["scale", "up"])
def test_a_body_is_neither_scaled_nor_turned(field):
    wrong = Upload(format="xml", scale=0.001) if field == "scale" else Upload(format="xml", up="y")
    with pytest.raises(AssetRefused) as refused:
        read_mjcf(MALLET.encode(), wrong)
    assert refused.value.faults[0].field == field


def test_in_quarantine_a_body_becomes_a_shape():
    made = digest(MALLET.encode(), XML)
    assert made.parts == 2
    assert made.density == pytest.approx(0.15 / made.volume)
    with pytest.raises(AssetRefused, match="<include>"):
        digest(body(BALL, '<include file="x"/>'), XML)
