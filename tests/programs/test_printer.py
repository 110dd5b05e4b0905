import ast

import pytest
from hypothesis import given, settings

from app.domain.action import ActionSignature, Parameter
from app.domain.condition import Not, Relation
from app.domain.program import ActionCall, Assertion, Branch, Comment, Loop, Program
from app.programs.examples import every_statement
from app.programs.parser import parse_program
from app.programs.printer import print_program
from tests.programs.strategies import PROGRAMS


@pytest.mark.parametrize("style", ["paper", "python"])
@settings(max_examples=120, deadline=None)
@given(program=PROGRAMS)
def test_reading_what_was_printed_gives_the_program_back(style, program):
    assert parse_program(print_program(program, style)) == program


@pytest.mark.parametrize("style", ["paper", "python"])
def test_an_object_called_hands_is_not_the_robot_s(style):
    body = (
        Assertion(condition=Relation("in", ("lime", "hands"))),
        Assertion(condition=Relation("held", ("lime",))),
    )
    program = Program(name="f", body=body)
    assert parse_program(print_program(program, style)) == program


@settings(max_examples=60, deadline=None)
@given(program=PROGRAMS)
def test_the_python_style_is_valid_python(program):
    ast.parse(print_program(program, "python"))


@pytest.mark.parametrize("style", ["paper", "python"])
@settings(max_examples=40, deadline=None)
@given(program=PROGRAMS)
def test_lines_of_the_program_are_lines_of_its_text(style, program):
    text = print_program(program, style)
    lines = text.split("\n")
    for statement in every_statement(parse_program(text)):
        if isinstance(statement, ActionCall):
            assert lines[statement.line - 1].strip() == str(statement)
        if isinstance(statement, Branch | Loop):
            assert lines[statement.line - 1].strip().startswith(("if ", "for "))
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
