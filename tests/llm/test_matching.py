"""Steps as people say them, and the action that each means."""

import pytest

from app.domain.action import ActionSignature, Parameter
from app.domain.scene import Scene, SceneObject
from app.llm.matching import likeliest_names, nearest
from app.programs.wording import all_calls, say

pytestmark = [pytest.mark.model, pytest.mark.timeout(1800)]

ONE, TWO = ("obj",), ("obj1", "obj2")
VERBS = {
    "find": ONE,
    "grab": ONE,
    "walk_to": ONE,
    "open": ONE,
    "close": ONE,
    "switch_on": ONE,
    "switch_off": ONE,
    "put_in": TWO,
    "put_on": TWO,
    "wipe_with": TWO,
}
OBJECTS = [
    *("fridge", "microwave", "salmon", "kitchen", "television", "sofa", "lamp", "plate", "sink"),
    *("bread", "toaster", "table", "apple", "bin", "cupboard", "towel", "phone", "toothbrush"),
    *("bathroom", "coffee pot"),
]
STEPS = {
    "walk to the fridge": "walk_to('fridge')",
    "go to the kitchen": "walk_to('kitchen')",
    "head over to the sofa": "walk_to('sofa')",
    "enter the bathroom": "walk_to('bathroom')",
    "open the fridge": "open('fridge')",
    "open up the microwave": "open('microwave')",
    "pull the cupboard open": "open('cupboard')",
    "take the salmon": "grab('salmon')",
    "pick up the salmon": "grab('salmon')",
    "get hold of the towel": "grab('towel')",
    "grab an apple": "grab('apple')",
    "take the toothbrush in your hand": "grab('toothbrush')",
    "put the salmon in the microwave": "put_in('salmon', 'microwave')",
    "place the salmon inside the fridge": "put_in('salmon', 'fridge')",
    "throw the apple in the bin": "put_in('apple', 'bin')",
    "drop the plate into the sink": "put_in('plate', 'sink')",
    "put bread in the toaster": "put_in('bread', 'toaster')",
    "insert the bread into the toaster": "put_in('bread', 'toaster')",
    "set the plate on the table": "put_on('plate', 'table')",
    "lay the phone on the sofa": "put_on('phone', 'sofa')",
    "put the coffee pot on the table": "put_on('coffee pot', 'table')",
    "close the microwave": "close('microwave')",
    "shut the fridge": "close('fridge')",
    "close the cupboard door": "close('cupboard')",
    "turn on the microwave": "switch_on('microwave')",
    "switch the lamp on": "switch_on('lamp')",
    "turn the television on": "switch_on('television')",
    "start the toaster": "switch_on('toaster')",
    "turn off the lamp": "switch_off('lamp')",
    "switch off the TV": "switch_off('television')",
    "put the light out": "switch_off('lamp')",
    "look for the phone": "find('phone')",
    "locate the bread": "find('bread')",
    "find the toothbrush": "find('toothbrush')",
    "search for the towel": "find('towel')",
    "wipe the table with the towel": "wipe_with('table', 'towel')",
    "clean the sink with a towel": "wipe_with('sink', 'towel')",
    "dry the plate using the towel": "wipe_with('plate', 'towel')",
}


def actions():
    for name, parameters in VERBS.items():
        shown = tuple(Parameter(name=each) for each in parameters)
        yield ActionSignature(name=name, parameters=shown, meaning="")


def meant(step, most):
    scene = Scene(world="house", objects=tuple(SceneObject(name=name) for name in OBJECTS))
    calls = list(all_calls(scene, actions(), likeliest_names(step, OBJECTS, most)))
    return str(calls[nearest(step, [say(call) for call in calls])[0]])


def test_most_steps_find_their_action():
    wrong = {step: found for step in STEPS if (found := meant(step, 8)) != STEPS[step]}
    assert len(wrong) <= 0.2 * len(STEPS), wrong


def test_names_in_the_text_come_before_those_near_in_meaning():
    names = ["sofa", "television", "lime", "couch", "lamp"]
    assert likeliest_names("put the TV next to the lamps", names, 2) == ("television", "lamp")


def test_no_more_names_than_asked_for_and_in_their_order():
    assert likeliest_names("anything", ["b", "a"], 2) == ("b", "a")
    assert len(likeliest_names("anything", OBJECTS, 5)) == 5
