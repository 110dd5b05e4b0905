from typing import Any

from app.domain.condition import Relation
from app.domain.plan import GroundedAssertion, GroundedCall, RejectedCall
from app.domain.trace import ActionStarted, AssertionChecked, CallSkipped, RecoveryTaken
from app.execution.assertion import WorldCheck
from app.execution.recovery import MAX_RECOVERY_CALLS, demand


def put(line, thing):
    return GroundedCall(line=line, action="put", arguments=(thing, "bowl"))


def assertion(*recovery):
    return GroundedAssertion(line=2, condition=Relation("in", ("pear", "bowl")), recovery=recovery)


def events(demanded, world, *wanted) -> list[Any]:
    return [each for each in demand(demanded, world, WorldCheck()) if isinstance(each, wanted)]


def test_a_true_assertion_takes_no_recovery(slippery):
    world = slippery()
    world.inside = {"pear": "bowl"}
    told = list(demand(assertion(put(3, "pear")), world, WorldCheck()))
    assert told == [
        AssertionChecked(
            line=2,
            condition=Relation("in", ("pear", "bowl")),
            holds=True,
            decider="world",
            by_world=True,
            time=0.0,
        )
    ]


def test_a_false_assertion_runs_recoveries_until_it_is_true(slippery):
    world = slippery(pear=1)
    calls = (put(3, "pear"), put(4, "pear"), put(5, "pear"))
    told = events(assertion(*calls), world, AssertionChecked, ActionStarted, RecoveryTaken)
    assert [type(each).__name__ for each in told] == [
        "AssertionChecked",
        "RecoveryTaken",
        "ActionStarted",
        "AssertionChecked",
        "ActionStarted",
        "AssertionChecked",
    ]
    assert [each.holds for each in told if isinstance(each, AssertionChecked)] == [
        False,
        False,
        True,
    ]
    assert [each.line for each in told if isinstance(each, ActionStarted)] == [3, 4]


def test_a_false_assertion_without_recovery_is_only_told(slippery):
    told = list(demand(assertion(), slippery(), WorldCheck()))
    assert [type(each).__name__ for each in told] == ["AssertionChecked"]


def test_a_rejected_recovery_is_skipped(slippery):
    rejected = RejectedCall(line=3, text="find('pear')", reason="no action 'find'")
    told = events(assertion(rejected, put(4, "pear")), slippery(), CallSkipped, ActionStarted)
    assert [each.line for each in told] == [3, 4]


def test_recoveries_are_limited(slippery):
    world = slippery(pear=99)
    calls = tuple(put(3 + number, "pear") for number in range(MAX_RECOVERY_CALLS + 2))
    assert len(events(assertion(*calls), world, ActionStarted)) == MAX_RECOVERY_CALLS
    skipped = events(assertion(*calls), world, CallSkipped)
    assert [each.text for each in skipped] == ["put('pear', 'bowl')"] * 2
