"""The grammar is turned into a regular expression, so that what it allows can be drawn from it."""

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.domain.action import ActionSignature, Parameter
from app.domain.instruction import Instruction
from app.domain.planner import PlannerOptions, Task
from app.domain.program import ActionCall
from app.domain.scene import Scene, SceneObject
from app.llm.grammar import MAX_STEPS, program_grammar
from app.programs.grounding import ground
from app.programs.parser import parse_program
from app.programs.prompt import write_cue

GRAB = ActionSignature(
    name="grab_and_putin",
    parameters=(Parameter(name="obj1"), Parameter(name="obj2", role="container")),
    meaning="Takes up one object and puts it down in another.",
)
TURN = ActionSignature(
    name="turn",
    parameters=(Parameter(name="obj"), Parameter(name="angle", role="number")),
    meaning="Turns an object by an angle [rad].",
)
WAIT = ActionSignature(name="wait", parameters=(), meaning="Waits.")
ODD = (
    "banana",
    "driver's cup",
    'say "hi"',
    "a\nb",
    "back\\slash",
    "😀",
    "x'); import os",
    "{2} | *",
)
PIECE = re.compile(
    r'"(?P<text>(?:[^"\\]|\\.)*)"|(?P<rule>[a-z][a-z0-9-]*)|(?P<set>\[[^\]]*\])'
    r"|(?P<other>[()|?*+]|\{[0-9,]+\})|\s+"
)


def scene(*names, containers=()):
    return Scene(
        world="tabletop",
        objects=tuple(SceneObject(name=name, container=name in containers) for name in names),
    )


def expression(grammar):
    rules = dict(line.split(" ::= ", 1) for line in grammar.strip().split("\n"))

    def expand(name):
        found, at = [], 0
        while at < len(rules[name]):
            piece = PIECE.match(rules[name], at)
            assert piece, rules[name][at:]
            at = piece.end()
            if piece["text"] is not None:
                plain = re.sub(
                    r"\\(.)",
                    lambda m: {"n": "\n", "t": "\t", "r": "\r"}.get(m[1], m[1]),
                    piece["text"],
                )
                found.append(f"(?:{re.escape(plain)})")
            elif piece["rule"]:
                found.append(f"(?:{expand(piece['rule'])})")
            else:
                found.append(piece["set"] or piece["other"] or "")
        return "".join(found)

    return expand("root")


def allows(grammar, *lines):
    return bool(
        re.fullmatch(expression(grammar), "".join(f"    {line}\n" for line in lines) + "\n")
    )


@pytest.mark.parametrize("comments", [True, False])
@pytest.mark.parametrize("feedback", [True, False])
def test_everything_it_allows_parses_and_grounds(comments, feedback):
    there = scene(*ODD, containers=ODD[1:5])
    actions = (GRAB, TURN, WAIT)
    grammar = program_grammar(there, actions, comments=comments, feedback=feedback)
    pattern = expression(grammar).replace(f"{{1,{MAX_STEPS}}}", "{1,4}").replace("{1,100}", "{1,9}")
    cue = write_cue(
        Task(scene=there, actions=actions, instruction=Instruction("go"), options=PlannerOptions())
    )

    @settings(max_examples=120, deadline=None)
    @given(st.from_regex(pattern, fullmatch=True, alphabet=st.characters(codec="utf-8")))
    def check(body):
        program = parse_program(cue + body)
        assert not ground(program, there, actions).rejected
        calls = [each for each in program.body if isinstance(each, ActionCall)]
        assert all(call.arguments[1] in ODD[1:5] for call in calls if call.action == GRAB.name)

    check()


def test_it_binds_actions_objects_containers_and_comments():
    grammar = program_grammar(
        scene("pear", "bowl", "box", containers=("bowl", "box")),
        [GRAB],
        comments=True,
        feedback=False,
    )
    assert allows(grammar, "# 1: the pear", "grab_and_putin('pear', 'bowl')", "# 2: Done")
    assert allows(grammar, "grab_and_putin('bowl', 'box')", "grab_and_putin('pear', 'box')")
    assert allows(grammar, "# there is no plum", "pass")
    assert not allows(grammar, "grab_and_putin('plum', 'bowl')")
    assert not allows(grammar, "grab_and_putin('pear', 'pear')")
    assert not allows(grammar, "grab_and_putin('bowl', 'pear')")
    assert not allows(grammar, "grab_and_putin('bowl', 'bowl')")
    assert not allows(grammar, "grab_and_putin('pear')")
    assert not allows(grammar, "push('pear', 'bowl')")
    assert not allows(grammar, "# only a remark")
    assert not allows(grammar, "")


def test_where_the_scene_has_no_container_any_other_object_will_do():
    grammar = program_grammar(scene("block", "cube"), [GRAB], comments=False, feedback=False)
    assert allows(grammar, "grab_and_putin('block', 'cube')", "grab_and_putin('cube', 'block')")
    assert not allows(grammar, "grab_and_putin('block', 'block')")


def test_switches_allow_and_forbid_comments_and_assertions():
    there = scene("pear", "bowl", containers=("bowl",))
    lines = ["assert('pear' in 'bowl')", "    else: grab_and_putin('pear', 'bowl')"]
    bare = program_grammar(there, [GRAB], comments=False, feedback=False)
    full = program_grammar(there, [GRAB], comments=True, feedback=True)
    assert allows(full, "# look", *lines)
    assert not allows(bare, *lines)
    assert not allows(bare, "# take it", "grab_and_putin('pear', 'bowl')")


def test_no_text_it_allows_is_endless():
    there = scene("pear", "bowl", containers=("bowl",))
    grammar = program_grammar(there, [GRAB], comments=True, feedback=False)
    call = "grab_and_putin('pear', 'bowl')"
    assert allows(grammar, *[call] * MAX_STEPS)
    assert not allows(grammar, *[call] * (MAX_STEPS + 1))
    assert not allows(grammar, "# " + "very " * 50 + "long", call)


@pytest.mark.parametrize("names", [(), ("bowl",)])
def test_where_nothing_can_be_done_only_pass_is_left(names):
    there = scene(*names, containers=names)
    grammar = program_grammar(there, [GRAB], comments=True, feedback=True)
    assert allows(grammar, "pass")
    assert not allows(grammar, "grab_and_putin('bowl', 'bowl')")
