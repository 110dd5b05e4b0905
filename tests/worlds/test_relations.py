import math

import pytest

from app.domain.condition import Relation
from app.domain.scene import Scene, SceneObject

pytestmark = pytest.mark.physics
UNTURNED = (1.0, 0.0, 0.0, 0.0)
LYING = (math.sqrt(0.5), math.sqrt(0.5), 0.0, 0.0)


@pytest.fixture
def world(tabletop, scene_of):
    scene = scene_of(
        apple=(0.5, 0.25), bowl=(0.5, 0.0), plate=(0.5, -0.3), can=(0.35, 0.3), book=(0.35, 0.1)
    )
    return tabletop.open(scene, 0)


def holds(world, name, *arguments):
    return world.holds(Relation(name, arguments))


def rest_on(world, move, name, other, height):
    """Let an object down on another from a little above a height [m]."""
    body = world.physics.bodies[other]
    x, y = world.physics.data.qpos[body.qpos_address : body.qpos_address + 2]
    move(world, name, (x, y, height + 0.003))
    world.settle()


def test_nothing_is_in_or_on_anything_at_first(world):
    assert world.facts() == frozenset()


def test_an_apple_in_a_bowl_is_in_it_and_not_on_it(world, move):
    rest_on(world, move, "apple", "bowl", world.physics.bodies["bowl"].opening.floor)
    assert world.facts() == {Relation("in", ("apple", "bowl"))}


def test_what_lies_on_a_plate_is_both_in_and_on_it(world, move):
    rest_on(world, move, "apple", "plate", world.physics.bodies["plate"].opening.floor)
    assert world.facts() == {
        Relation("in", ("apple", "plate")),
        Relation("on", ("apple", "plate")),
    }


def test_what_is_stacked_is_on_what_carries_it(world, move):
    rest_on(world, move, "can", "book", world.physics.bodies["book"].height)
    assert world.facts() == {Relation("on", ("can", "book"))}


def test_a_bowl_on_a_plate_brings_its_apple_along(world, move):
    rest_on(world, move, "bowl", "plate", world.physics.bodies["plate"].opening.floor)
    floor = world.physics.bodies["plate"].opening.floor
    rest_on(world, move, "apple", "bowl", floor + world.physics.bodies["bowl"].opening.floor)
    assert holds(world, "in", "bowl", "plate")
    assert holds(world, "in", "apple", "bowl")
    assert holds(world, "in", "apple", "plate")
    assert not holds(world, "in", "plate", "bowl")


def test_an_object_beside_a_container_is_not_in_it(world, move):
    move(world, "apple", (0.5, 0.13, 0.0))
    world.settle()
    assert not holds(world, "in", "apple", "bowl")
    assert holds(world, "near", "apple", "bowl")


def test_left_is_the_robots_left(world):
    assert holds(world, "left_of", "apple", "bowl")
    assert not holds(world, "left_of", "bowl", "apple")
    assert holds(world, "right_of", "plate", "bowl")
    assert not holds(world, "left_of", "bowl", "bowl")


def test_near_ends_ten_centimetres_from_the_surface(world, move):
    radius = world.physics.bodies["can"].footprint_radius / math.sqrt(2)
    other = world.physics.bodies["book"]
    half_width = world.scene.objects[4].size[1] / 2
    assert other.name == "book"
    for gap, expected in ((0.09, True), (0.11, False)):
        move(world, "can", (0.35, 0.1 + half_width + radius + gap, 0.0))
        assert holds(world, "near", "can", "book") is expected
        assert holds(world, "near", "book", "can") is expected


def test_a_toppled_can_is_not_upright(world, move):
    assert holds(world, "upright", "can")
    move(world, "can", (0.35, 0.3, 0.05), LYING)
    world.settle()
    assert not holds(world, "upright", "can")


def test_a_tipped_bowl_contains_nothing(world, move):
    move(world, "bowl", (0.5, 0.0, 0.2), (0.0, 1.0, 0.0, 0.0))
    world.settle()
    body = world.physics.bodies["bowl"]
    assert not holds(world, "upright", "bowl")
    move(world, "apple", (0.5, 0.0, world.physics.height_of(body) + 0.001))
    world.settle()
    assert not holds(world, "in", "apple", "bowl")


def test_what_lies_across_a_rim_is_not_in_it_and_what_leans_inside_is(tabletop, scene_of, move):
    world = tabletop.open(scene_of(cup=(0.5, 0.0), pen=(0.4, 0.3)), 0)
    rim = world.physics.bodies["cup"].height
    move(world, "pen", (0.5, 0.0, rim + 0.002))
    world.settle()
    assert world.physics.height_of(world.physics.bodies["pen"]) > rim - 0.002
    assert not holds(world, "in", "pen", "cup")
    leaning = (math.cos(-0.72), 0.0, math.sin(-0.72), 0.0)
    move(world, "pen", (0.5, 0.0, 0.085), leaning)
    world.settle()
    assert holds(world, "in", "pen", "cup")


def test_in_front_is_nearer_to_the_robot(world):
    assert holds(world, "in_front_of", "can", "apple")
    assert holds(world, "behind", "apple", "can")
    assert not holds(world, "behind", "can", "apple")


def test_what_carries_something_is_not_clear(world, move):
    assert holds(world, "clear", "book")
    rest_on(world, move, "can", "book", world.physics.bodies["book"].height)
    assert not holds(world, "clear", "book")
    assert holds(world, "clear", "can")


@pytest.mark.parametrize("name", ["drawer", "hinged box", "door cabinet"])
def test_what_shuts_is_open_closed_or_neither(tabletop, name):
    scene = Scene(world="tabletop", objects=(SceneObject(name=name, position=(0.5, 0, 0)),))
    world = tabletop.open(scene, 0)
    physics, body = world.physics, world.physics.bodies[name]
    found = []
    for share in (1.0, 0.4, 0.0):
        physics.data.qpos[physics.model.jnt_qposadr[body.joint]] = share * body.articulation.travel
        found.append((holds(world, "open", name), holds(world, "closed", name)))
        assert (Relation("closed", (name,)) in world.facts()) == found[-1][1]
    assert found == [(True, False), (False, False), (False, True)]


def test_containers_are_open_and_nothing_is_closed(world):
    assert holds(world, "open", "bowl")
    assert not holds(world, "open", "apple")
    assert not holds(world, "closed", "bowl")


@pytest.mark.parametrize(
    "relation",
    [Relation("in", ("apple",)), Relation("in", ("apple", "moon")), Relation("eats", ("apple",))],
)
def test_what_makes_no_sense_does_not_hold(world, relation):
    assert not world.holds(relation)
