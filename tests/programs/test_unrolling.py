import time

import pytest

from app.domain.action import ActionSignature, Parameter
from app.domain.condition import Relation
from app.domain.errors import ProgramRefused
from app.domain.plan import GroundedBranch, GroundedCall, Jump, RejectedCall
from app.domain.program import Assertion, Branch, Comment, Pass
from app.domain.scene import Scene, SceneObject
from app.programs.grounding import ground
from app.programs.parser import parse_program
from app.programs.unrolling import unroll

SCENE = Scene(
    world="tabletop",
    objects=(
        SceneObject(name="banana", category="fruit", colour="yellow"),
        SceneObject(name="lime", category="Fruit", colour="#00ff00"),
        SceneObject(name="spoon", category="cutlery", properties=(("material", "steel"),)),
        SceneObject(name="bowl", container=True),
    ),
)
PUT = ActionSignature(
    name="put", parameters=(Parameter(name="item"), Parameter(name="place")), meaning="Puts it."
)
SHIFT = ActionSignature(
    name="shift",
    parameters=(
        Parameter(name="item"),
        Parameter(name="side", role="word", words=("left", "right")),
        Parameter(name="x", role="number"),
    ),
    meaning="Shifts it.",
)


def program(*lines, above=""):
    return parse_program("\n".join([above, "def f():", *(f"    {line}" for line in lines)]))


def calls(*lines, above=""):
    return [str(each) for each in unroll(program(*lines, above=above), SCENE)]


@pytest.mark.parametrize(
    ("condition", "chosen"),
    [
        ("category(o) == 'fruit'", ["banana", "lime"]),
        ("category(o) != 'fruit'", ["spoon", "bowl"]),
        ("color(o) == 'green'", ["lime"]),
        ("container(o) == True", ["bowl"]),
        ("material(o) == 'steel'", ["spoon"]),
        ("category(o) == 'fruit' and o != 'lime'", ["banana"]),
        ("o in ['lime', 'bowl']", ["lime", "bowl"]),
        ("not (o == 'lime' or container(o) == True)", ["banana", "spoon"]),
    ],
)
def test_a_loop_goes_through_what_its_filter_leaves(condition, chosen):
    head = f"for item in [o for o in objects if {condition}]:"
    assert calls(head, "    grab(item)") == [f"grab('{name}')" for name in chosen]


def test_a_program_s_own_list_and_graph_are_gone_through():
    above = "objects = {'peg': {'shape': 'round'}, 'block': {'in it': {'pin': {'shape': 'round'}}}}"
    head = "for item in [o for o in objects if shape(o) == 'round']:"
    assert calls(head, "    grab(item)", above=above) == ["grab('peg')", "grab('pin')"]
    assert calls("for item in objects:", "    grab(item)", above="objects = ['a']") == ["grab('a')"]


def test_helpers_are_written_out_with_what_they_are_given():
    above = (
        "def move(item, x):\n    place(item, x=x + 0.1)\n"
        "def twice(item):\n    move(item, 0.2)\n    move(x=-1, item=item)\n"
    )
    assert calls("for each in ['a', 'b']:", "    twice(each)", above=above) == [
        "place('a', x=0.3)",
        "place('a', x=-0.9)",
        "place('b', x=0.3)",
        "place('b', x=-0.9)",
    ]


def test_a_helper_does_not_know_those_below_it():
    above = "def one(x):\n    two(x)\ndef two(x):\n    one(x)\n"
    assert calls("two('a')", "one('b')", above=above) == ["two('a')", "two('b')"]


def test_what_only_the_world_can_tell_stays_a_branch():
    lines = ("for item in [o for o in objects if container(o) == False and o in 'bowl']:",)
    first, *rest = unroll(program(*lines, "    # out", "    grab(item)"), SCENE)
    assert isinstance(first, Branch)
    assert [type(each) for each in first.body] == [Comment, type(first.body[1])]
    assert len(rest) == 2
    decided = program(
        "if category('lime') == 'fruit':",
        "    grab('lime')",
        "else:",
        "    grab('bowl')",
        "if near('lime', 'bowl'):",
        "    for item in []:",
        "        grab(item)",
    )
    _, branch = unroll(decided, SCENE)
    assert isinstance(branch, Branch)
    assert branch.body == (Pass(),)
    assert str(unroll(decided, SCENE)[0]) == "grab('lime')"


def test_an_assertion_of_a_property_is_decided_at_once():
    (kept,) = unroll(program("assert 'lime' in 'bowl'"), SCENE)
    assert isinstance(kept, Assertion)
    assert calls("assert category('lime') == 'fruit', grab('lime')") == []
    assert calls("assert category('bowl') == 'fruit', grab('lime')") == ["grab('lime')"]


def test_a_property_nobody_has_is_rejected_where_it_is_asked():
    (step, *_) = ground(program("if taste('lime') == 'sour':", "    grab('lime')"), SCENE, []).steps
    assert isinstance(step, RejectedCall)
    assert "nothing is known of the 'taste'" in step.reason


def test_branches_become_steps_that_pass_over_one_side():
    steps = ground(
        program("if 'lime' in 'bowl':", "    put('lime', 'spoon')", "else:", "    # in",
                "    put('lime', 'bowl')", "put('spoon', 'bowl')"),
        SCENE, [PUT], {"in": 2},
    ).steps  # fmt: skip
    assert steps == (
        GroundedBranch(line=3, condition=Relation("in", ("lime", "bowl")), skip=2),
        GroundedCall(line=4, action="put", arguments=("lime", "spoon")),
        Jump(skip=2),
        Comment(text="in"),
        GroundedCall(line=7, action="put", arguments=("lime", "bowl"), comment="in"),
        GroundedCall(line=8, action="put", arguments=("spoon", "bowl"), comment="in"),
    )


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ("shift('lime', 'left', 0.5)", ("lime", "left", 0.5)),
        ("shift('lime', x=-0.5, side='right')", ("lime", "right", -0.5)),
        ("shift('lime', 'up', 0.5)", "side is one of 'left', 'right'"),
        ("shift('lime', 'left')", "takes 3 argument(s), not 2"),
        ("shift('lime', 'left', y=2)", "has no parameter 'y'"),
        ("shift('lime', 'left', item='bowl')", "given item twice"),
        ("shift('lime', 'left', x='far')", "x is a number"),
    ],
)
def test_words_numbers_and_names_are_bound_to_their_parameters(line, found):
    (step,) = ground(program(line), SCENE, [SHIFT]).steps
    if isinstance(found, str):
        assert isinstance(step, RejectedCall)
        assert found in step.reason
    else:
        assert isinstance(step, GroundedCall)
        assert step.arguments == found


def test_an_offset_of_a_name_is_no_object():
    (step,) = ground(program("for a in ['lime']:", "    put(a + 1, 'bowl')"), SCENE, [PUT]).rejected
    assert "no object 'lime + 1.0'" in step.reason


@pytest.mark.parametrize(
    ("above", "lines"),
    [
        ("", ["for a in objects:"] + [f"{'  ' * n}for {'abcd'[n]} in objects:" for n in (1, 2, 3)]
         + ["        grab(a)"] * 30),
        ("", [f"{'  ' * n}for {'abcd'[n]} in [{', '.join('1' * 1000)}]:" for n in range(3)]
         + ["        if name(a) == 'b':", "          grab('x')"]),
        ("def h0():\n  pass\n" + "".join(
            f"def h{n}():\n  h{n - 1}()\n  h{n - 1}()\n" for n in range(1, 20)), ["h19()"]),
    ],
    ids=["statements", "rounds", "helpers"],
)  # fmt: skip
def test_a_program_that_grows_without_measure_is_refused_at_once(above, lines):
    written = program(*lines, above=above)
    started = time.process_time()
    with pytest.raises(ProgramRefused, match="written out"):
        ground(written, SCENE, [])
    assert time.process_time() - started < 2
