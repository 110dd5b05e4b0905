import time

import pytest

from app.domain.action import ActionSignature, Parameter
from app.domain.condition import Relation
from app.domain.plan import GroundedAssertion, GroundedCall, RejectedCall
from app.domain.program import Comment
from app.domain.scene import Scene, SceneObject
from app.programs.grounding import ground
from app.programs.parser import parse_program

SCENE = Scene(
    world="tabletop",
    objects=tuple(SceneObject(name=name) for name in ("banana", "bowl", "red cup")),
)
TURN = ActionSignature(
    name="turn",
    parameters=(Parameter(name="obj"), Parameter(name="angle", role="number")),
    meaning="Turns an object by an angle [rad].",
)


def steps(actions, *lines, relations=None):
    program = parse_program("\n".join(["def f():", *(f"    {line}" for line in lines)]))
    return ground(program, SCENE, actions, relations).steps


def test_calls_stand_under_the_comment_above_them(grab_and_putin):
    assert steps(
        [grab_and_putin, TURN],
        "turn('bowl', 1)",
        "# tidy up",
        "grab_and_putin('banana', 'bowl')",
        "turn('red cup', -0.5)",
        "pass",
    ) == (
        GroundedCall(line=2, action="turn", arguments=("bowl", 1.0)),
        Comment(text="tidy up"),
        GroundedCall(
            line=4, action="grab_and_putin", arguments=("banana", "bowl"), comment="tidy up"
        ),
        GroundedCall(line=5, action="turn", arguments=("red cup", -0.5), comment="tidy up"),
    )


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        ("open('banana')", "no action 'open'; it has: grab_and_putin, turn"),
        ("exec('import os')", "no action 'exec'"),
        ("grab_and_putin('banana')", "grab_and_putin(obj1, obj2) takes 2 argument(s), not 1"),
        ("grab_and_putin('banana', 'bowl', 'bowl')", "takes 2 argument(s), not 3"),
        ("grab_and_putin('bannana', 'bowl')", "no object 'bannana' in the scene; did you mean "),
        ("grab_and_putin('xylophone', 'bowl')", "no object 'xylophone' in the scene"),
        ("grab_and_putin('banana', 3)", "obj2 is an object's name in quotes, not the number 3"),
        ("turn('banana', 'bowl')", "angle is a number, not 'bowl'"),
        ("grab_and_putin('bowl', 'bowl')", "different objects, not 'bowl' twice"),
    ],
)
def test_what_is_not_there_is_rejected_with_its_reason(grab_and_putin, line, reason):
    (step,) = steps([grab_and_putin, TURN], line)
    assert isinstance(step, RejectedCall)
    assert step.line == 2
    assert step.text.split("(")[0] == line.split("(")[0]
    assert reason in step.reason


def test_recoveries_are_grounded_one_by_one(grab_and_putin):
    (step,) = steps(
        [grab_and_putin],
        "assert('banana' in 'bowl')",
        "    else: grab_and_putin('banana', 'bowl')",
        "    else: find('banana')",
    )
    assert isinstance(step, GroundedAssertion)
    assert step.condition == Relation("in", ("banana", "bowl"))
    assert [type(call) for call in step.recovery] == [GroundedCall, RejectedCall]


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        ("assert('banana' in 'pot')", "no object 'pot'"),
        ("assert happy('banana')", "cannot tell 'happy'; it can: in, near"),
        ("assert('close' to 'banana')", "near speaks of 2 object(s) here, not 1"),
    ],
)
def test_an_assertion_nobody_can_decide_is_rejected(grab_and_putin, line, reason):
    (step,) = steps([grab_and_putin], line, relations={"in": 2, "near": 2})
    assert isinstance(step, RejectedCall)
    assert step.text.startswith("assert ")
    assert reason in step.reason


def test_thousands_of_unknown_names_do_not_take_long(grab_and_putin):
    scene = Scene(
        world="tabletop", objects=tuple(SceneObject(name=f"thing {n}" * 5) for n in range(200))
    )
    lines = [f"    grab_and_putin('thing x{n}', 'bowl')" for n in range(1500)]
    program = parse_program("\n".join(["def f():", *lines]))
    started = time.process_time()
    assert len(ground(program, scene, [grab_and_putin]).rejected) == 1500
    assert time.process_time() - started < 3
