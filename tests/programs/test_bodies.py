from typing import Any

import pytest

from app.domain.condition import AnyOf, Not, Property, Relation, all_of
from app.domain.errors import ProgramRefused
from app.domain.program import ActionCall, Assertion, Branch, Comment, Helper, Loop, Pass, Variable
from app.programs.bodies import MAX_NESTING
from app.programs.parser import parse_program

ITEM = Variable("item")


def call(action, *arguments, **keywords):
    return ActionCall(action=action, arguments=arguments, keywords=tuple(keywords.items()))


def body(*lines) -> tuple[Any, ...]:
    return parse_program("\n".join(["def f():", *(f"    {line}" for line in lines)])).body


def refusal(text):
    with pytest.raises(ProgramRefused) as refused:
        parse_program(text)
    return refused.value.faults[0]


def test_a_loop_goes_over_names_numbers_or_the_objects():
    assert body("for item in ['lime', 'pie']:", "    put(item, 'bowl')", "go()") == (
        Loop(variable="item", items=("lime", "pie"), body=(call("put", ITEM, "bowl"),)),
        call("go"),
    )
    assert body("for x in [0.1, -2]:", "  place('lime', x=x + 0.25 - 0.5)") == (
        Loop(
            variable="x",
            items=(0.1, -2.0),
            body=(call("place", "lime", x=Variable("x", -0.25)),),
        ),
    )
    assert body("for item in objects:", "    put(item)")[0] == Loop(
        variable="item", items=None, body=(call("put", ITEM),)
    )


def test_a_filter_speaks_of_the_loop_s_variable_whatever_its_own_is_called():
    fruit = Property("category", ITEM, "fruit")
    others = Not(AnyOf((Property("name", ITEM, "lime"), Property("name", ITEM, "pie"))))
    head = (
        "for item in [o for o in objects if category(o) == 'fruit' and o not in ['lime', 'pie']]:"
    )
    assert body(head, "    put(item)") == (
        Loop(
            variable="item",
            items=None,
            condition=all_of(fruit, others),
            body=(call("put", ITEM),),
        ),
    )


def test_a_branch_has_two_sides_and_blocks_nest():
    assert body(
        "for item in objects:",
        "    if item in 'bowl' or not near(item, 'box'):",
        "        # leave it",
        "        pass",
        "    else:  # out with it",
        "        put(item, 'box')",
        "        assert(item in 'box')",
        "            else: put(item, 'box')",
        "    # next",
        "go()",
    ) == (
        Loop(
            variable="item",
            items=None,
            body=(
                Branch(
                    condition=AnyOf(
                        (Relation("in", (ITEM, "bowl")), Not(Relation("near", (ITEM, "box"))))
                    ),
                    body=(Comment(text="leave it"), Pass()),
                    otherwise=(
                        Comment(text="out with it"),
                        call("put", ITEM, "box"),
                        Assertion(
                            condition=Relation("in", (ITEM, "box")),
                            recovery=(call("put", ITEM, "box"),),
                        ),
                    ),
                ),
                Comment(text="next"),
            ),
        ),
        call("go"),
    )


def test_a_comment_belongs_to_the_block_it_is_indented_with():
    loop = ("for item in objects:", "    put(item)")
    assert body(*loop, "    # of the loop", "go()")[0].body[-1] == Comment(text="of the loop")
    assert body(*loop, "# after it", "go()")[1] == Comment(text="after it")
    assert body("for item in objects:", "# too far left", "    put(item)")[0].body == (
        Comment(text="too far left"),
        call("put", ITEM),
    )


def test_helpers_stand_above_the_task_and_are_called():
    program = parse_program(
        "def put_away(item, place):\n"
        "    put(item, place)\n"
        "def both():\n"
        "    '''Two of them.'''\n"
        "    put_away('lime', place='bowl')\n"
        "# a remark\n"
        "def tidy_up():\n"
        "    both()\n"
    )
    assert program.name == "tidy_up"
    assert program.helpers == (
        Helper(
            name="put_away",
            parameters=("item", "place"),
            body=(call("put", ITEM, Variable("place")),),
        ),
        Helper(name="both", parameters=(), body=(call("put_away", "lime", place="bowl"),)),
    )
    assert program.body == (call("both"),)


@pytest.mark.parametrize(
    ("helper", "line", "message"),
    [
        ("def g(a):\n    put(a)", "go()", "nothing calls g"),
        ("def g(a):\n    put(a)", "g()", "call it with exactly these"),
        ("def g(a):\n    put(a)", "g('x', 'y')", "call it with exactly these"),
        ("def g(a):\n    put(a)", "g('x', a='y')", "call it with exactly these"),
        ("def g(a):\n    put(a)", "g(b='x')", "call it with exactly these"),
        ("def g(a, a):\n    put(a)", "g('x', 'y')", "in use already"),
        ("def g(a):\n    put(b)", "g('x')", "in quotes"),
        ("def g(a):\n    # nothing", "g('x')", "does nothing"),
        ("def g(a):\n    pass\ndef g(a):\n    pass", "g('x')", "defined twice"),
        ("def g(a):\n    for a in ['x']:\n        put(a)", "g('x')", "in use already"),
        ("def g(a):\n    put(a)", "assert near('x'), g('x')", "is an action"),
    ],
)
def test_a_helper_is_checked_before_anything_runs(helper, line, message):
    assert message in refusal(f"{helper}\ndef f():\n    {line}\n").message


def test_a_helper_that_names_itself_calls_the_robot_s_action():
    program = parse_program("def grab(x):\n    grab(x)\ndef f():\n    grab('lime')\n")
    assert program.helpers[0].body == (call("grab", Variable("x")),)


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        (["for x in objects:", "    pass", "put(x)"], "in quotes"),
        (["for x in objects:", "    for x in objects:", "        put(x)"], "in use already"),
        (["for x in objects:", "    return"], "does not stand in a block"),
        (["for x in objects:", "    # only this", "go()"], "at least one statement"),
        (["if near('a'):", "    go()", "else:", "    # only this"], "at least one statement"),
        (["if near('a'):", "    go()", "else: stay()"], "on the lines below"),
        (["if near('a'):", "    go()", "else:", "    go()", "else:", "    go()"], "below the if"),
        (["if near('a'):", "        go()", "    go()"], "align it"),
        (["for x in objects:", "    objects = ['late']"], "move it up"),
    ],
)  # fmt: skip
def test_a_malformed_block_is_refused(lines, message):
    assert message in refusal("\n".join(["def f():", *(f"    {each}" for each in lines)])).message


def test_blocks_nest_so_deep_and_no_deeper():
    def nested(depth):
        heads = [f"{'  ' * (n + 1)}for x{n} in objects:" for n in range(depth)]
        return "\n".join(["def f():", *heads, f"{'  ' * (depth + 1)}go()"])

    assert parse_program(nested(MAX_NESTING)).body
    assert "nest deeper" in refusal(nested(MAX_NESTING + 1)).message
