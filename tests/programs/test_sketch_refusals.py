import pytest

from app.domain.action import ActionSignature, Parameter
from app.domain.errors import TaskDeclined
from app.domain.program import ActionCall
from app.domain.scene import SceneObject
from app.programs.sketches.refusals import HANDOVER, refuse_harm
from app.programs.sketches.selection import Selection
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
