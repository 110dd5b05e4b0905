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
from app.llm.grammar import GROUP, MAX_STEPS, program_grammar
from app.programs.grounding import ground
from app.programs.parser import parse_program
from app.programs.prompt import write_cue

GRAB = ActionSignature(
    name="grab_and_putin",
    parameters=(Parameter(name="obj1"), Parameter(name="obj2", role="container")),
    meaning="Takes up one object and puts it down in another.",
)
STACK = ActionSignature(
    name="stack",
    parameters=(Parameter(name="obj1"), Parameter(name="obj2", role="support")),
    meaning="Puts one object into or onto another.",
)
SLIDE = ActionSignature(
    name="slide",
    parameters=(
        Parameter(name="obj"),
        Parameter(name="side", role="word", words=("left", "right", "it's \n odd")),
        Parameter(name="x", role="number"),
    ),
    meaning="Slides an object to a side by so much [m].",
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
    actions = (GRAB, TURN, WAIT, STACK, SLIDE)
    grammar = program_grammar(there, actions, comments=comments, feedback=feedback)
    pattern = expression(grammar).replace(f"{{1,{MAX_STEPS}}}", "{1,4}").replace("{1,100}", "{1,9}")
    cue = write_cue(
        Task(scene=there, actions=actions, instruction=Instruction("go"), options=PlannerOptions())
    )

    @settings(max_examples=50, deadline=None)
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


def test_a_support_may_be_any_object_but_the_one_put_onto_it():
    there = scene("block", "cube", "bowl", containers=("bowl",))
    grammar = program_grammar(there, [STACK], comments=False, feedback=False)
    assert allows(grammar, "stack('block', 'cube')", "stack('cube', 'bowl')")
    assert not allows(grammar, "stack('cube', 'cube')")


def test_words_and_numbers_stand_in_order_or_by_name():
    grammar = program_grammar(scene("cube"), [SLIDE], comments=False, feedback=False)
    assert allows(grammar, "slide('cube', 'left', -0.25)", "slide('cube', side='right', x=3)")
    for call in ("'up', 1", "'left', x=1", "'left'", "'left', 1e9", "side='left'"):
        assert not allows(grammar, f"slide('cube', {call})")
    unsaid = ActionSignature(
        name="say", parameters=(Parameter(name="word", role="word"),), meaning="Says it."
    )
    assert allows(program_grammar(scene(), [unsaid], comments=False, feedback=False), "pass")


def test_the_paper_s_assertions_are_allowed_where_they_are_asked_for():
    there = scene("pear", "fridge", containers=("fridge",))
    relations = ("near", "held", "open", "in")
    grammar = program_grammar(there, [TURN], comments=False, feedback=True, relations=relations)
    for asserted in (
        "'close' to 'pear'", "'pear' in 'hands'", "'fridge' is 'opened'", "'pear' in 'fridge'",
    ):  # fmt: skip
        assert allows(grammar, f"assert({asserted})", "    else: turn('pear', 1)")
    for asserted in ("'pear' on 'fridge'", "'fridge' is 'closed'", "'close' to 'plum'"):
        assert not allows(grammar, f"assert({asserted})", "    else: turn('pear', 1)")


def test_a_body_that_was_begun_may_have_nothing_left():
    there = scene("pear", "bowl", containers=("bowl",))
    whole = program_grammar(there, [GRAB], comments=True, feedback=False)
    rest = program_grammar(there, [GRAB], comments=True, feedback=False, begun=True)
    assert allows(rest)
    assert allows(rest, "# 2: Done")
    assert allows(rest, "grab_and_putin('pear', 'bowl')")
    assert not allows(whole)


def test_in_a_crowded_scene_nothing_goes_onto_itself_and_everything_onto_all_else():
    names = [f"thing {n}" for n in range(2 * GROUP + 1)]
    grammar = program_grammar(scene(*names), [STACK], comments=False, feedback=False)
    pattern = re.compile(expression(grammar))
    for one in names:
        for other in names:
            body = f"    stack('{one}', '{other}')\n\n"
            assert bool(pattern.fullmatch(body)) == (one != other)


def test_the_grammar_of_a_crowded_scene_stays_small():
    names = [f"thing number {n}" for n in range(200)]
    grammar = program_grammar(scene(*names), [GRAB, STACK], comments=True, feedback=True)
    assert len(grammar) < 100_000


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


def test_only_what_affords_an_action_is_offered_for_it():
    told = {"fridge": "can_open", "apple": "grabbable", "shelf": ""}
    objects = tuple(
        SceneObject(name=name, properties=(("affordances", words),)) for name, words in told.items()
    )
    room = SceneObject(name="kitchen", category="room")
    home = Scene(world="home", objects=(*objects, room))
    held = Parameter(name="obj1", affordance="grabbable")
    actions = (
        ActionSignature(
            name="open", parameters=(Parameter(name="obj", affordance="can_open"),), meaning=""
        ),
        ActionSignature(
            name="lay", parameters=(held, Parameter(name="obj2", role="support")), meaning=""
        ),
        ActionSignature(
            name="ring", parameters=(Parameter(name="obj", affordance="has_bell"),), meaning=""
        ),
    )
    asserted = ("held", "open", "switched_on")
    text = program_grammar(home, actions, comments=False, feedback=True, relations=asserted)
    for line in ("open('fridge')", "lay('apple', 'fridge')", "lay('apple', 'shelf')"):
        assert allows(text, line)
    assert allows(text, "assert('apple' in 'hands')", "    else: open('fridge')")
    for line in ("open('apple')", "lay('fridge', 'shelf')", "lay('apple', 'kitchen')"):
        assert not allows(text, line)
    assert not allows(text, "assert('apple' is 'opened')", "    else: open('fridge')")
    assert "ring" not in text
    assert "switchon" not in text


def test_affordances_can_be_left_out_as_in_the_paper():
    told = {"fridge": "can_open", "apple": "grabbable"}
    objects = tuple(
        SceneObject(name=name, properties=(("affordances", words),)) for name, words in told.items()
    )
    opening = ActionSignature(
        name="open", parameters=(Parameter(name="obj", affordance="can_open"),), meaning=""
    )
    bound, plain = (
        program_grammar(
            Scene(world="home", objects=objects),
            (opening,),
            comments=False,
            feedback=False,
            affordances=affordances,
        )
        for affordances in (True, False)
    )
    assert not allows(bound, "open('apple')")
    assert allows(plain, "open('apple')")


def test_where_no_object_tells_of_its_affordances_all_are_offered():
    home = scene("fridge", "apple")
    action = ActionSignature(
        name="open", parameters=(Parameter(name="obj", affordance="can_open"),), meaning=""
    )
    text = program_grammar(home, (action,), comments=False, feedback=False)
    assert "'fridge'" in text
    assert "'apple'" in text
