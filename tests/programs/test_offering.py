import pytest

from app.domain.errors import TaskDeclined
from app.programs.sketches.offering import with_offer
from app.worlds.actions.tabletop import actions

OTHERS = [action.signature for action in actions.values()]


@pytest.mark.parametrize(
    ("sentence", "name"),
    [
        ("hand me the mug", "handover"),
        ("put the mug left of the plate", "place_left_of"),
        ("put it back", "place_at"),
        ("shut the drawer", "close"),
        ("go home", "home"),
        ("wipe the plate", "wipe"),
    ],
)
def test_what_is_impossible_names_the_action_that_could(sentence, name):
    told = with_offer(TaskDeclined("cannot", kind="impossible"), sentence, OTHERS)
    assert told.reason == f"cannot; {name} could: list it in the scene's actions"
    assert str(told) == told.reason


def test_every_action_that_could_is_named():
    told = with_offer(TaskDeclined("cannot", kind="impossible"), "put it next to the mug", OTHERS)
    assert "place_left_of, place_right_of" in told.reason
    assert told.reason.endswith("list one of them in the scene's actions")


def test_nothing_is_promised_that_no_action_does():
    declined = TaskDeclined("cannot", kind="impossible")
    assert with_offer(declined, "sing a song", OTHERS) is declined


def test_other_refusals_stand():
    declined = TaskDeclined("no mug", kind="absent")
    assert with_offer(declined, "hand me the mug", OTHERS) is declined
