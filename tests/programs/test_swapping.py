from dataclasses import replace

import pytest

from app.domain.action import ActionSignature, Parameter
from app.domain.condition import Relation
from app.domain.errors import TaskDeclined
from app.domain.instruction import Instruction
from app.domain.planner import PlannerOptions, Task
from app.domain.program import ActionCall
from app.domain.scene import Scene, SceneObject
from app.programs.sketches.selection import Selection
from app.programs.sketches.swapping import swap
from app.programs.sketches.things import read_things

NUMBERS = tuple(Parameter(name=name, role="number") for name in "xy")
PLACE_AT = ActionSignature(
    name="place_at", parameters=(Parameter(name="obj"), *NUMBERS), meaning=""
)
OBJECTS = (
    SceneObject(name="red block", position=(0.4, 0.1, 0.0), size=(0.04, 0.04, 0.04)),
    SceneObject(name="blue block", position=(0.5, -0.1, 0.0), size=(0.04, 0.04, 0.04)),
    SceneObject(name="bowl", position=(0.5, 0.2, 0.0), size=(0.1, 0.1, 0.05)),
)


def statements(sentence, *, actions=(PLACE_AT,), facts=()):
    task = Task(
        scene=Scene(world="tabletop", objects=OBJECTS),
        actions=actions,
        instruction=Instruction(sentence),
        options=PlannerOptions(),
        facts=frozenset(facts),
    )
    return swap(task, sentence, Selection(read_things(OBJECTS), task.facts, sentence))


def calls(sentence):
    found = statements(sentence)
    assert found
    return found


@pytest.mark.parametrize(
    "sentence",
    [
        "swap the red and the blue block",
        "swap the red block with the blue block",
        "switch the blocks",
    ],
)
def test_one_waits_while_the_other_takes_its_place(sentence):
    _, waits, comes, goes = calls(sentence)
    assert str(waits).startswith("place_at('red block', ")
    assert str(comes) == "place_at('blue block', 0.4, 0.1)"
    assert str(goes) == "place_at('red block', 0.5, -0.1)"
    assert isinstance(waits, ActionCall)
    x, y = map(float, waits.arguments[1:])
    for item in OBJECTS:
        assert item.position
        assert max(abs(x - item.position[0]), abs(y - item.position[1])) > 0.07


def test_two_things_of_different_kinds_change_places_too():
    _, waits, *_ = calls("swap the bowl and the red block")
    assert str(waits).startswith("place_at('bowl', ")


def test_of_them_it_is_asked_which_two_are_meant():
    with pytest.raises(TaskDeclined) as declined:
        statements("swap them")
    assert declined.value.question


def test_what_asks_for_something_else_is_left():
    assert statements("put the red block in the bowl") is None


def test_it_takes_an_action_that_puts_things_at_a_place():
    with pytest.raises(TaskDeclined) as declined:
        statements("swap the blocks", actions=(replace(PLACE_AT, name="stack"),))
    assert declined.value.kind == "impossible"


def test_what_lies_in_something_does_not_stand_where_the_scene_says():
    with pytest.raises(TaskDeclined, match="not known"):
        statements("swap the blocks", facts=[Relation("in", ("red block", "bowl"))])
