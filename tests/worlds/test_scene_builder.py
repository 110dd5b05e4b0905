import mujoco
import numpy as np
import pytest

from app.domain.scene import Scene, SceneObject
from app.worlds.simulators.mujoco.colours import css
from app.worlds.simulators.mujoco.placement import complete
from app.worlds.simulators.mujoco.scene_builder import build
from app.worlds.simulators.mujoco.solid import COLLISION_GROUP, VISUAL_GROUP

TWELVE = (
    *("banana", "strawberry", "bottle", "plate", "box", "drill"),
    *("soup can", "mug", "fork", "red block", "pen", "pear"),
)


@pytest.fixture(scope="module")
def twelve():
    objects = tuple(SceneObject(name=name) for name in TWELVE)
    return complete(Scene(world="tabletop", objects=objects), 4)


@pytest.fixture(scope="module")
def built(twelve):
    return build(twelve)


def test_the_panda_stands_on_the_table_with_its_joints_first(built):
    model = built.model
    names = [model.joint(index).name for index in range(model.njnt)]
    arm = [f"joint{number}" for number in range(1, 8)]
    assert names[:9] == [*arm, "finger_joint1", "finger_joint2"]
    assert names[9:] == [f"object/{index}/free" for index in range(len(TWELVE))]
    assert [model.actuator(index).name for index in range(8)] == [
        f"actuator{number}" for number in range(1, 9)
    ]
    assert model.nkey == 0
    assert model.geom("table").bodyid[0] == model.body("table").id
    assert model.geom("floor").type[0] == mujoco.mjtGeom.mjGEOM_PLANE


def test_the_tool_centre_is_between_the_finger_tips(built):
    data = mujoco.MjData(built.model)
    mujoco.mj_forward(built.model, data)
    tips = (data.body("left_finger").xpos + data.body("right_finger").xpos) / 2
    hand = data.body("hand")
    assert np.linalg.norm(data.site("tcp").xpos - hand.xpos) == pytest.approx(0.1034)
    assert np.linalg.norm(np.cross(data.site("tcp").xpos - hand.xpos, tips - hand.xpos)) < 1e-6


def test_objects_stand_where_the_scene_says(twelve, built):
    data = mujoco.MjData(built.model)
    mujoco.mj_forward(built.model, data)
    assert list(built.bodies) == list(TWELVE)
    for item in twelve.objects:
        body = built.bodies[item.name]
        x, y, z = data.qpos[body.qpos_address : body.qpos_address + 3]
        assert (x, y) == pytest.approx(item.position[:2])
        assert z == pytest.approx(0, abs=0.001)
        assert data.qpos[body.qpos_address + 6] == pytest.approx(np.sin(item.yaw / 2))
        assert (body.kind, body.height) == (item.kind, item.size[2])
        assert (body.opening is not None) == item.container


def test_every_object_is_seen_in_one_group_and_touched_in_another(built):
    model = built.model
    for body in built.bodies.values():
        geoms = np.flatnonzero(model.geom_bodyid == body.body_id)
        groups = model.geom_group[geoms]
        assert set(groups) == {VISUAL_GROUP, COLLISION_GROUP}
        assert (model.geom_contype[geoms] == (groups == COLLISION_GROUP)).all()


def test_a_colour_in_the_scene_is_the_colour_in_the_model(built):
    geoms = np.flatnonzero(built.model.geom_bodyid == built.bodies["red block"].body_id)
    assert any(np.allclose(built.model.geom_rgba[geom], css("red")) for geom in geoms)


def test_the_same_scene_gives_the_same_model(twelve, built):
    again = build(twelve)
    assert again.bodies == built.bodies
    for field in ("body_mass", "body_inertia", "geom_pos", "geom_size", "mesh_vert", "qpos0"):
        assert np.array_equal(getattr(again.model, field), getattr(built.model, field))


def test_names_of_strangers_never_become_names_in_the_model():
    strange = "hand\" /><body name='x'>"
    objects = (SceneObject(name=strange), SceneObject(name="hand"), SceneObject(name="object/0"))
    built = build(complete(Scene(world="tabletop", objects=objects), 0))
    assert list(built.bodies) == [strange, "hand", "object/0"]
    assert built.model.body("hand").id != built.bodies["hand"].body_id
    assert built.model.body("object/0").id == built.bodies[strange].body_id


def test_a_scene_that_is_not_completed_is_not_built():
    with pytest.raises(ValueError, match="'banana' is not completed"):
        build(Scene(world="tabletop", objects=(SceneObject(name="banana"),)))


@pytest.mark.physics
def test_a_dozen_objects_stand_still_for_a_second(built):
    model, data = built.model, mujoco.MjData(built.model)
    data.qpos[:9] = data.ctrl[:9] = 0
    data.qpos[:7] = data.ctrl[:7] = (0, -0.35, 0, -2.3, 0, 1.95, 0.785)
    data.qpos[7:9], data.ctrl[7] = 0.04, 255
    start = data.qpos.copy()
    mujoco.mj_step(model, data, 500)
    assert np.abs(data.qpos[:9] - start[:9]).max() < 1e-3
    for body in built.bodies.values():
        before, after = (qpos[body.qpos_address :][:7] for qpos in (start, data.qpos))
        assert np.linalg.norm(after[:3] - before[:3]) < 0.002
        assert 2 * np.arccos(min(1.0, abs(after[3:] @ before[3:]))) < np.radians(2)
