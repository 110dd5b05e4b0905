import pytest

from app.domain.action import ActionSignature, Parameter
from app.domain.errors import TaskDeclined
from app.domain.program import ActionCall
from app.domain.scene import SceneObject
from app.programs.sketches.refusals import (
    HANDOVER,
    refuse_harm,
    refuse_immaterial,
    refuse_place_beside,
    refuse_two_places,
    refuse_ungrounded,
)
from app.programs.sketches.selection import Selection
from app.programs.sketches.sketch import Phrase, SketchCall
from app.programs.sketches.things import read_things

HAND = ActionSignature(name=HANDOVER, parameters=(Parameter(name="obj"),), meaning="")


def selection(*names):
    things = read_things(SceneObject(name=name) for name in names)
    return Selection(things, frozenset(), "hand it over")


def test_a_knife_is_not_handed_to_a_person():
    with pytest.raises(TaskDeclined) as declined:
        refuse_harm(ActionCall(action=HANDOVER, arguments=("knife",)), HAND, selection("knife"))
    assert declined.value.kind == "hazardous"
    assert declined.value.question


def test_an_apple_is_handed_over():
    refuse_harm(ActionCall(action=HANDOVER, arguments=("apple",)), HAND, selection("apple"))


@pytest.mark.parametrize(
    "sentence",
    ["put the fork left of the plate", "move the green one next to the blue bowl"],
)
def test_what_goes_beside_a_thing_is_not_put_into_it(grab_and_putin, sentence):
    with pytest.raises(TaskDeclined) as declined:
        refuse_place_beside(sentence, [grab_and_putin])
    assert declined.value.kind == "impossible"


@pytest.mark.parametrize(
    "sentence",
    ["put the cup next to the can in the box", "put the box on the left in the bowl"],
)
def test_what_tells_which_thing_is_meant_passes(grab_and_putin, sentence):
    refuse_place_beside(sentence, [grab_and_putin])


def test_a_verb_that_puts_things_there_passes():
    beside = ActionSignature(name="place_left_of", parameters=HAND.parameters * 2, meaning="")
    refuse_place_beside("put the fork left of the plate", [beside])


def test_nothing_goes_where_nothing_of_the_scene_is(grab_and_putin):
    call = ActionCall(action="grab_and_putin", arguments=("fork", "away"))
    with pytest.raises(TaskDeclined) as declined:
        refuse_ungrounded(call, grab_and_putin, selection("fork", "box"))
    assert declined.value.choices == ("put the fork in the box",)


def test_a_thing_is_handed_over_and_nobody_else(grab_and_putin):
    with pytest.raises(TaskDeclined):
        refuse_ungrounded(ActionCall(action=HANDOVER, arguments=("me",)), HAND, selection("fork"))


@pytest.mark.parametrize("text", ["echo of the bell", "shadow of the cup", "bell's sound"])
def test_nobody_takes_hold_of_an_echo(text):
    call = SketchCall("grab_and_putin", (Phrase(text=text), Phrase(text="box")))
    with pytest.raises(TaskDeclined) as declined:
        refuse_immaterial(call, selection("bell", "cup", "box"))
    assert declined.value.kind == "impossible"


def test_a_thing_may_be_called_a_wind_chime():
    call = SketchCall("grab_and_putin", (Phrase(text="mum's wind chime"), Phrase(text="box")))
    refuse_immaterial(call, selection("wind chime", "box"))


def test_one_thing_is_not_in_two_places_at_once():
    with pytest.raises(TaskDeclined):
        refuse_two_places("put the ring in the box and in the jar at the same time")
    refuse_two_places("put the ring in the box and the coin in the jar at the same time")
