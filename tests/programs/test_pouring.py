import pytest

from app.domain.errors import TaskDeclined
from app.domain.scene import SceneObject
from app.programs.sketches.course import Course
from app.programs.sketches.pouring import poured_into, poured_out, refuse_solid
from app.programs.sketches.things import read_things

THINGS = read_things(
    SceneObject(name=name) for name in ("cocoa tin", "lemon slice", "glass", "jug")
)


@pytest.mark.parametrize(
    "said",
    [
        "Lemon slice in the glass, then pour the jug on it",
        "put the slice into my glass and pour the jug over that",
        "the slice goes in the glass, then pour the jug in.",
    ],
)
def test_it_is_poured_into_what_holds_the_thing(said):
    course = Course(places={"lemon slice": "glass"})
    assert poured_into("lemon slice", course, said, THINGS) == "glass"


def test_what_is_named_is_poured_on_itself():
    course = Course(places={"lemon slice": "glass"})
    said = "put the slice in the glass and pour the jug on the lemon slice"
    assert poured_into("lemon slice", course, said, THINGS) == "lemon slice"


def test_what_is_taken_and_emptied_is_poured():
    said = "Fetch the jug and empty it into the glass."
    assert poured_out(said, THINGS) == "pour the jug into the glass."


def test_what_a_glass_is_topped_up_with_is_poured():
    assert poured_out("top it up with the jug.", THINGS) == "pour the jug into it."


@pytest.mark.parametrize(
    "name", ["brick", "wooden spoon", "bowling ball", "claw hammer", "rolling pin", "footstool"]
)
def test_nobody_pours_a_solid_thing(name):
    with pytest.raises(TaskDeclined):
        refuse_solid(name)


@pytest.mark.parametrize("name", ["gravel", "lentils", "milk jug", "orange juice", "paint tin"])
def test_what_trickles_or_holds_is_poured(name):
    refuse_solid(name)
