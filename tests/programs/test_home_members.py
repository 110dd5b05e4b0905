"""Single things have names of their own where a class has several of them in a home."""

import pytest

from app.domain.condition import Relation
from app.domain.plan import GroundedCall, RejectedCall
from app.domain.scene import Scene
from app.programs.grounding import ground
from app.programs.home_members import HomeMembers, room_told
from app.programs.parser import parse_program
from app.worlds import worlds

HOUSEHOLD = worlds["household"]


@pytest.fixture(scope="module")
def scene():
    return HOUSEHOLD.complete(Scene(world="household", environment="env0"), 0)


@pytest.fixture
def members(scene):
    return HomeMembers(scene.objects, HOUSEHOLD.open_perfect(scene, 0).holds)


def test_each_of_several_has_a_name(members):
    assert members.of("plate") == ("plate 1", "plate 2", "plate 3")
    assert members.of("fridge") == ()
    assert members.class_of("plate 2") == "plate"
    assert members.spoken("waterglass 2") == "water glass 2"


def test_a_room_tells_which(members):
    assert members.one_within("ceilinglamp", "bedroom") == "ceilinglamp 3"
    assert members.one_within("waterglass", "kitchen") == "waterglass"
    assert members.one_within("fridge", "bedroom") == "fridge"


def test_nothing_is_known_of_single_things_without_the_home(scene):
    assert HomeMembers(scene.objects).of("plate") == ()


def test_a_plan_can_name_the_second_one_and_no_fourth(scene):
    program = parse_program("def task():\n    find('plate 2')\n    find('plate 4')\n")
    second, fourth = ground(program, scene, HOUSEHOLD.actions).steps
    assert isinstance(second, GroundedCall)
    assert isinstance(fourth, RejectedCall)


def test_the_world_does_it_with_the_one_that_is_named(scene):
    world = HOUSEHOLD.open_perfect(scene, 0)
    for action in ("find", "open"):
        list(world.perform(action, ("window 2",)))
    assert world.holds(Relation("open", ("window 2",)))
    assert world.holds(Relation("closed", ("window 3",)))


@pytest.mark.parametrize(
    ("sentence", "before", "room"),
    [
        ("make some light in the bedroom", (), "bedroom"),
        ("vacuum the living room", (), "livingroom"),
        ("put the mug on the kitchen table", (), ""),
        ("from the kitchen to the bedroom", (), ""),
        ("bring it from the kitchen to the bedroom", ("from",), "kitchen"),
    ],
)
def test_the_room_a_sentence_speaks_of(scene, sentence, before, room):
    assert room_told(scene.objects, sentence, before=before) == room
