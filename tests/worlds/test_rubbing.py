import math

import pytest

from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.domain.scene import Scene, SceneObject

pytestmark = pytest.mark.physics
PLACES = {"sponge": (0.45, 0.25), "plate": (0.5, -0.1), "book": (0.4, 0.05), "bowl": (0.4, -0.35)}


@pytest.fixture
def dusty(tabletop):
    objects = [
        SceneObject(name=name, position=(*place, 0.0), yaw=0.0) for name, place in PLACES.items()
    ]
    scene = Scene(world="tabletop", objects=tuple(objects), actions=("pick", "place_on", "wipe"))
    return tabletop.open(scene, 0)


def share(world, name):
    return world.physics.rubbing.share(world.physics.data, name)


def test_the_level_top_of_a_plate_is_its_foot_and_that_of_a_book_its_cover(dusty):
    rubbing = dusty.physics.rubbing
    length, width, _ = dusty.scene.objects[2].size
    assert rubbing.top("book").area == pytest.approx(length * width, rel=0.05)
    foot = 0.70 * dusty.scene.objects[1].size[0] / 2
    assert rubbing.top("plate").area == pytest.approx(math.pi * foot**2, rel=0.1)
    assert rubbing.top("plate").middles[:, 2] == pytest.approx(0.005, abs=0.001)


def test_the_floor_of_what_is_hollow_is_no_level_top(dusty, carry_out):
    assert not dusty.physics.is_level("bowl")
    with pytest.raises(ActionFailure, match="no level top"):
        carry_out(dusty, "bowl", "sponge", action="wipe")


def test_what_is_only_put_down_rubs_nothing(dusty, carry_out):
    carry_out(dusty, "sponge", "book", action="place_on")
    assert dusty.holds(Relation("on", ("sponge", "book")))
    assert not dusty.holds(Relation("wiped", ("book",)))


def test_what_was_wiped_is_saved_with_the_state(dusty, tabletop, carry_out):
    before = dusty.save()
    carry_out(dusty, "book", "sponge", action="wipe")
    assert share(dusty, "book") >= 0.6
    assert share(dusty, "plate") == 0.0
    saved = dusty.save()
    dusty.restore(before)
    assert not dusty.holds(Relation("wiped", ("book",)))
    dusty.restore(saved)
    assert dusty.holds(Relation("wiped", ("book",)))
    supposed = tabletop.open_perfect(dusty.scene, 0, saved)
    assert supposed.holds(Relation("wiped", ("book",)))


def test_the_sponge_and_the_plate_end_where_they_were(dusty, carry_out):
    before = {name: dusty.place(name) for name in PLACES}
    carry_out(dusty, "plate", "sponge", action="wipe")
    dusty.settle()
    for name, place in before.items():
        assert dusty.place(name) == pytest.approx(place, abs=0.015), name


def test_a_scene_whose_robot_does_not_wipe_keeps_no_record(tabletop, scene_of):
    world = tabletop.open(scene_of(sponge=(0.45, 0.25), book=(0.4, 0.05)), 0)
    assert world.physics.rubbing is None
    assert not world.holds(Relation("wiped", ("book",)))


def test_what_lies_on_its_side_has_no_top_to_wipe(dusty, carry_out, move):
    move(dusty, "book", (0.4, 0.05, 0.06), (0.5**0.5, 0.5**0.5, 0.0, 0.0))
    dusty.settle()
    with pytest.raises(ActionFailure):
        carry_out(dusty, "book", "sponge", action="wipe")
    assert not dusty.holds(Relation("wiped", ("book",)))
