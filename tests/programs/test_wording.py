import re

import pytest

from app.domain.action import ActionSignature, Parameter
from app.domain.program import ActionCall
from app.domain.scene import Scene, SceneObject
from app.programs.examples import load_examples
from app.programs.parser import parse_program
from app.programs.wording import all_calls, read_steps, say, speak, spoken_prompt


@pytest.mark.parametrize(
    ("call", "said"),
    [
        ("grab_and_putin('spoon', 'mug')", "grab the spoon and put it in the mug"),
        ("putin('salmon', 'fridge')", "put the salmon in the fridge"),
        ("puton('mug', 'table')", "put the mug on the table"),
        ("put_in('salmon', 'fridge')", "put the salmon in the fridge"),
        ("switchon('tv')", "switch on the tv"),
        ("switch_off('tv')", "switch off the tv"),
        ("walk('kitchen')", "walk to the kitchen"),
        ("walk_to('kitchen')", "walk to the kitchen"),
        ("find('salmon')", "find the salmon"),
        ("open('fridge')", "open the fridge"),
        ("place_next_to('cup', 'plate')", "place the cup next to the plate"),
        ("wipe_with('table', 'sponge')", "wipe the table with the sponge"),
        ("wipe('plate', 'sponge')", "wipe the plate with the sponge"),
        ("stack('cup', 'bowl')", "stack the cup on the bowl"),
        ("open_gripper()", "open gripper"),
        ("move('cup', 0.5, 0.25)", "move the cup in 0.5 0.25"),
    ],
)
def test_call_is_said_in_plain_english(call, said):
    (statement,) = parse_program(f"def f():\n    {call}\n").body
    assert isinstance(statement, ActionCall)
    assert say(statement) == said


def test_example_program_is_said_step_by_step():
    program = parse_program(
        "def put_the_key_in_the_cup():\n"
        "    objects = ['key', 'cup']\n"
        "    # 1: put it there\n"
        "    put_in('key', 'cup')\n"
        "    assert 'key' in 'cup', put_in('key', 'cup')\n"
    )
    spoken = speak(program)
    assert spoken
    assert (spoken.task, spoken.objects) == ("put the key in the cup", ("key", "cup"))
    assert spoken.steps == ("put the key in the cup",)
    assert spoken_prompt([spoken], "put it back") == (
        "Task: put the key in the cup\n1. put the key in the cup\n2. done\n\nTask: put it back\n1."
    )


@pytest.mark.parametrize("world", ["tabletop", "household"])
def test_plain_example_programs_can_be_said(world):
    for program in load_examples(world):
        spoken = speak(program)
        for step in spoken.steps if spoken else ():
            assert re.fullmatch(r"[a-z]+( [\w.]+)*", step), step


def test_steps_are_read_up_to_the_end_of_the_plan():
    text = " take the cup.\n2. put it in the sink\n 3) open the tap\n4. Done\n5. no more"
    assert read_steps(text) == ["take the cup", "put it in the sink", "open the tap"]
    assert read_steps(" \n") == []


def test_every_call_takes_things_of_the_right_kind_and_none_twice():
    scene = Scene(
        world="w",
        objects=(
            SceneObject(name="cup"),
            SceneObject(name="key"),
            SceneObject(name="box", container=True),
        ),
    )
    put = (Parameter(name="a"), Parameter(name="b", role="container"))
    actions = [
        ActionSignature(name="put", parameters=put, meaning=""),
        ActionSignature(name="wave", parameters=(), meaning=""),
        ActionSignature(name="turn", parameters=(Parameter(name="n", role="number"),), meaning=""),
    ]
    assert [str(call) for call in all_calls(scene, actions)] == [
        "put('cup', 'box')",
        "put('key', 'box')",
        "wave()",
    ]
    assert list(map(str, all_calls(scene, actions, ["key"]))) == ["wave()"]
