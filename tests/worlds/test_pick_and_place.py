import numpy as np
import pytest

from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.worlds.simulators.mujoco.cameras import Cloud
from app.worlds.simulators.mujoco.picking import Picking
from app.worlds.simulators.mujoco.scene_builder import build
from app.worlds.simulators.mujoco.workcell import Workcell

pytestmark = pytest.mark.physics


def names(stages):
    return list(dict.fromkeys(stage.name for stage in stages))


def assert_safe(world):
    """The arm is at home and the gripper open."""
    assert abs(world.physics.joints - world.physics.arm.home).max() < 0.02
    assert world.physics.opening > 0.03


def test_a_pick_goes_through_its_stages_in_order(tabletop, scene_of, carry_out):
    world = tabletop.open(scene_of(banana=(0.5, 0.2), bowl=(0.5, -0.1)), 0)
    stages = carry_out(world, "banana", "bowl")
    assert names(stages) == [
        "look", "reach", "approach", "grasp", "lift", "carry", "lower", "release", "retreat",
        "home", "check",
    ]  # fmt: skip
    assert world.holds(Relation("in", ("banana", "bowl")))
    assert_safe(world)


def test_what_is_already_there_is_left_alone(tabletop, scene_of, carry_out):
    world = tabletop.open(scene_of(strawberry=(0.5, 0.2), plate=(0.5, -0.1)), 0)
    carry_out(world, "strawberry", "plate")
    time = world.time
    assert carry_out(world, "strawberry", "plate") == []
    assert world.time == time


def test_several_objects_find_room_in_one_container(tabletop, scene_of, carry_out):
    world = tabletop.open(
        scene_of(
            box=(0.5, -0.15), strawberry=(0.35, 0.2), block=(0.5, 0.15), lime=(0.4, 0.35)
        ),
        0,
    )  # fmt: skip
    for name in ("strawberry", "block", "lime"):
        carry_out(world, name, "box")
    world.settle()
    for name in ("strawberry", "block", "lime"):
        assert world.holds(Relation("in", (name, "box"))), name


def test_a_block_is_put_on_top_of_a_book(tabletop, scene_of, carry_out):
    world = tabletop.open(scene_of(block=(0.5, 0.2), book=(0.5, -0.1)), 0)
    carry_out(world, "block", "book")
    assert world.facts() == {Relation("on", ("block", "book"))}


def test_nothing_can_be_put_on_a_ball(tabletop, scene_of, carry_out):
    world = tabletop.open(scene_of(block=(0.5, 0.2), ball=(0.5, -0.1)), 0)
    with pytest.raises(ActionFailure, match="not flat enough") as failure:
        carry_out(world, "block", "ball")
    assert failure.value.stage == "place"
    assert_safe(world)


def test_nothing_can_be_put_into_itself(tabletop, scene_of, carry_out):
    world = tabletop.open(scene_of(bowl=(0.5, 0.0)), 0)
    with pytest.raises(ActionFailure, match="into itself"):
        carry_out(world, "bowl", "bowl")


def test_a_plate_is_not_put_into_what_lies_on_it(tabletop, scene_of, carry_out):
    world = tabletop.open(scene_of(bowl=(0.5, 0.2), plate=(0.5, -0.2)), 0)
    physics = world.physics
    address = physics.bodies["bowl"].qpos_address
    physics.data.qpos[address : address + 3] = (0.5, -0.2, 0.02)
    world.settle()
    with pytest.raises(ActionFailure, match="bowl is in plate itself"):
        carry_out(world, "plate", "bowl")


def test_an_object_taken_out_of_reach_is_reported_so(tabletop, scene_of, carry_out, move):
    world = tabletop.open(scene_of(block=(0.5, 0.2), bowl=(0.5, -0.1)), 0)
    move(world, "block", (0.85, 0.65, 0.0))
    with pytest.raises(ActionFailure, match="the arm cannot get there") as failure:
        carry_out(world, "block", "bowl")
    assert failure.value.stage == "unreachable"
    assert_safe(world)


def test_an_object_that_fell_off_the_table_is_reported_so(tabletop, scene_of, carry_out, move):
    world = tabletop.open(scene_of(block=(0.5, 0.2), bowl=(0.5, -0.1)), 0)
    move(world, "block", (1.3, 0.0, -0.3))
    world.settle()
    with pytest.raises(ActionFailure, match="fallen off the table") as failure:
        carry_out(world, "block", "bowl")
    assert failure.value.stage == "look"


def test_a_tipped_container_takes_nothing(tabletop, scene_of, carry_out, move):
    world = tabletop.open(scene_of(block=(0.5, 0.2), bowl=(0.5, -0.1)), 0)
    move(world, "bowl", (0.5, -0.1, 0.1), (0.0, 1.0, 0.0, 0.0))
    world.settle()
    with pytest.raises(ActionFailure, match="tipped over"):
        carry_out(world, "block", "bowl")


def test_a_full_container_is_reported_before_anything_is_picked(
    tabletop, scene_of, carry_out, move
):
    world = tabletop.open(scene_of(block=(0.35, 0.3), cup=(0.5, 0.0), can=(0.5, 0.3)), 0)
    move(world, "can", (0.5, 0.0, 0.04))
    world.physics.wake()
    with pytest.raises(ActionFailure, match="no room left") as failure:
        carry_out(world, "block", "cup")
    assert failure.value.stage == "place"


def test_what_lies_flat_on_the_table_has_no_grasp(tabletop, scene_of):
    cell = Workcell.over(build(tabletop.complete(scene_of(block=(0.5, 0.2)), 0)))
    grid = np.stack(np.meshgrid(*[np.linspace(0.4, 0.5, 20)] * 2, [0.001]), axis=-1)
    sheet = Cloud(grid.reshape(-1, 3), np.tile([0.0, 0.0, 1.0], (400, 1)))
    home = cell.physics.arm.home
    picking = Picking(cell.collisions, home, np.array([0.5, -0.2, 0.05]), np.random.default_rng(0))
    with pytest.raises(ActionFailure, match="no grasp found") as failure:
        picking.choose("sheet", sheet, banned=())
    assert failure.value.stage == "grasp"
