import ast

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.domain.action import ActionSignature, Parameter
from app.domain.condition import AnyOf, Count, Not, Relation
from app.domain.program import ActionCall, Assertion, Comment, Pass, Program
from app.programs.parser import parse_program
from app.programs.printer import print_program

NAMES = st.one_of(
    st.sampled_from(
        ["lime", "hands", "close", "to", "driver's cup", '"quoted" cup', "a\nb", "\\", "'''", "😀",
         "x'); import os; os.system('ls", "bowl (2)", "", "#", "é" * 200, "\u2028", "\x00", "{}%s"]
    ),
    st.text(st.characters(codec="utf-8"), max_size=200),
)  # fmt: skip
WORDS = st.sampled_from(["grab", "grab_and_putin", "find", "open", "put2"])
NUMBERS = st.floats(allow_nan=False, allow_infinity=False)
CALLS = st.builds(
    ActionCall,
    action=WORDS,
    arguments=st.lists(NAMES | NUMBERS, max_size=3).map(tuple),
)
RELATIONS = st.one_of(
    st.builds(
        lambda name, only: Relation(name, (only,)),
        st.sampled_from(
            ["near", "held", "open", "closed", "switched_on", "switched_off", "upright"]
        ),
        NAMES,
    ),
    st.builds(
        lambda name, first, second: Relation(name, (first, second)),
        st.sampled_from(["in", "on", "near", "left_of", "right_of"]),
        NAMES,
        NAMES,
    ),
    st.builds(Count, NAMES, st.lists(NAMES, min_size=1, max_size=3).map(tuple), st.integers(0, 99)),
)
CONDITIONS = st.recursive(
    RELATIONS,
    lambda inner: st.one_of(
        inner.map(Not), st.lists(inner, min_size=1, max_size=2).map(lambda c: AnyOf(tuple(c)))
    ),
    max_leaves=3,
)
COMMENTS = st.text(st.characters(codec="utf-8", exclude_characters="\r\n\x00"), max_size=60).map(
    lambda text: Comment(text=text.strip())
)
STATEMENTS = st.one_of(
    COMMENTS,
    CALLS,
    st.builds(Assertion, condition=CONDITIONS, recovery=st.lists(CALLS, max_size=3).map(tuple)),
    st.just(Pass()),
)
PROGRAMS = st.builds(
    Program,
    name=st.sampled_from(["tidy_up", "put_the_lime_in_the_bowl", "task_2"]),
    objects=st.none() | st.lists(NAMES, max_size=4).map(tuple),
    body=st.lists(STATEMENTS, max_size=6)
    .map(tuple)
    .filter(lambda body: any(not isinstance(statement, Comment) for statement in body)),
)


def depth(condition):
    match condition:
        case Not(inner):
            return 1 + depth(inner)
        case AnyOf(conditions):
            return 1 + max(map(depth, conditions))
        case _:
            return 0


@pytest.mark.parametrize("style", ["paper", "python"])
@settings(max_examples=250, deadline=None)
@given(program=PROGRAMS)
def test_reading_what_was_printed_gives_the_program_back(style, program):
    if all(depth(each.condition) < 6 for each in program.body if isinstance(each, Assertion)):
        assert parse_program(print_program(program, style)) == program


@pytest.mark.parametrize("style", ["paper", "python"])
def test_an_object_called_hands_is_not_the_robot_s(style):
    body = (
        Assertion(condition=Relation("in", ("lime", "hands"))),
        Assertion(condition=Relation("held", ("lime",))),
    )
    program = Program(name="f", body=body)
    assert parse_program(print_program(program, style)) == program


@settings(max_examples=200, deadline=None)
@given(program=PROGRAMS)
def test_the_python_style_is_valid_python(program):
    ast.parse(print_program(program, "python"))


@pytest.mark.parametrize("style", ["paper", "python"])
@settings(max_examples=100, deadline=None)
@given(program=PROGRAMS)
def test_lines_of_the_program_are_lines_of_its_text(style, program):
    text = print_program(program, style)
    lines = text.split("\n")
    for statement in parse_program(text).body:
        if isinstance(statement, ActionCall):
            assert lines[statement.line - 1].strip() == str(statement)
        if isinstance(statement, Assertion):
            assert lines[statement.line - 1].strip().startswith("assert")
            assert all(str(call) in lines[call.line - 1] for call in statement.recovery)


def test_the_paper_style_writes_as_the_paper_does():
    grab = ActionSignature(name="grab", parameters=(Parameter(name="obj"),), meaning="Takes it up.")
    program = Program(
        name="take_lime",
        objects=("lime",),
        body=(
            Comment(text="1: take it"),
            Assertion(
                condition=Relation("near", ("lime",)),
                recovery=(ActionCall(action="find", arguments=("lime",)),),
            ),
            ActionCall(action="grab", arguments=("lime",)),
            Assertion(condition=Not(Relation("held", ("lime",)))),
        ),
    )
    assert print_program(program, "paper", [grab]) == (
        "from actions import grab(obj)\n"
        "\n"
        "def take_lime():\n"
        "    objects = ['lime']\n"
        "    # 1: take it\n"
        "    assert('close' to 'lime')\n"
        "        else: find('lime')\n"
        "    grab('lime')\n"
        "    assert(not 'lime' in 'hands')\n"
    )
