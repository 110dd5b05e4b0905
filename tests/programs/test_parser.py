import contextlib
import random
import time

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from app.domain.condition import AnyOf, Count, Not, Relation
from app.domain.errors import ProgramRefused
from app.domain.program import ActionCall, Assertion, Comment, Pass, Program
from app.programs.lexer import MAX_CHARACTERS
from app.programs.parser import MAX_FAULTS, MAX_STATEMENTS, parse_program

PAPER = """\
from actions import walk, find(obj), grab(obj), putin(obj, obj)

objects = ['lime', 'garbagecan']

def throw_away_lime():
\t# 0: find lime
\tfind('lime')
\tassert('close' to 'lime' )
\t\telse: find('lime')
\tgrab('lime')
\tassert('lime' in 'hands')
\t\telse: find('lime')
\t\telse: grab('lime')
\tassert('garbagecan' is 'opened')
\t\telse: open('garbagecan')
\tputin('lime', 'garbagecan')
\t# 1: Done
"""
PYTHON = """\
from actions import grab_and_putin

def tidy():
    '''Puts things away.'''
    objects = ["banana",
               "bowl",  # of wood
    ]
    # put the banana in the bowl
    grab_and_putin("banana", "bowl")  # gently
    assert 'banana' in 'bowl', grab_and_putin('banana', 'bowl')
    assert near('lime'), (find('lime'), grab('lime'))
    assert (not open('lid'))
    turn('knob', -0.5, 3)
    return
    grab_and_putin('bowl', 'banana')
"""


def call(action, *arguments):
    return ActionCall(action=action, arguments=arguments)


def body(*lines):
    return parse_program("\n".join(["def f():", *(f"    {line}" for line in lines)])).body


def test_the_paper_s_form_is_read():
    assert parse_program(PAPER) == Program(
        name="throw_away_lime",
        objects=("lime", "garbagecan"),
        body=(
            Comment(text="0: find lime"),
            call("find", "lime"),
            Assertion(condition=Relation("near", ("lime",)), recovery=(call("find", "lime"),)),
            call("grab", "lime"),
            Assertion(
                condition=Relation("held", ("lime",)),
                recovery=(call("find", "lime"), call("grab", "lime")),
            ),
            Assertion(
                condition=Relation("open", ("garbagecan",)), recovery=(call("open", "garbagecan"),)
            ),
            call("putin", "lime", "garbagecan"),
            Comment(text="1: Done"),
        ),
    )


def test_valid_python_is_read_and_return_ends_it():
    program = parse_program(PYTHON)
    assert program.objects == ("banana", "bowl")
    assert program.body == (
        Comment(text="put the banana in the bowl"),
        Comment(text="gently"),
        call("grab_and_putin", "banana", "bowl"),
        Assertion(
            condition=Relation("in", ("banana", "bowl")),
            recovery=(call("grab_and_putin", "banana", "bowl"),),
        ),
        Assertion(
            condition=Relation("near", ("lime",)),
            recovery=(call("find", "lime"), call("grab", "lime")),
        ),
        Assertion(condition=Not(Relation("open", ("lid",)))),
        call("turn", "knob", -0.5, 3.0),
    )


def test_every_statement_knows_its_line():
    lines = PAPER.splitlines()
    for statement in parse_program(PAPER).body:
        if isinstance(statement, ActionCall):
            assert lines[statement.line - 1].strip() == str(statement)
        if isinstance(statement, Assertion):
            assert lines[statement.line - 1].strip().startswith("assert(")
            for recovery in statement.recovery:
                assert lines[recovery.line - 1].strip() == f"else: {recovery}"


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("'a' in 'b'", Relation("in", ("a", "b"))),
        ("in_('a', 'b')", Relation("in", ("a", "b"))),
        ("'a' on 'b'", Relation("on", ("a", "b"))),
        ("'a' not in 'b'", Not(Relation("in", ("a", "b")))),
        ("not 'a' on 'b'", Not(Relation("on", ("a", "b")))),
        ("'a' in 'hands'", Relation("held", ("a",))),
        ("close('a')", Relation("near", ("a",))),
        ("near('a', 'b')", Relation("near", ("a", "b"))),
        ("'a' left_of 'b'", Relation("left_of", ("a", "b"))),
        ("'a' is 'closed'", Relation("closed", ("a",))),
        ("'a' is not 'switched on'", Not(Relation("switched_on", ("a",)))),
        ("'a' is 'switchoff'", Relation("switched_off", ("a",))),
        (
            "any_of('a' in 'b', upright('a'))",
            AnyOf((Relation("in", ("a", "b")), Relation("upright", ("a",)))),
        ),
        ("count('box', 'a', 'b') == 1", Count("box", ("a", "b"), 1)),
        ("'close' in 'to'", Relation("in", ("close", "to"))),
    ],
)
@pytest.mark.parametrize("form", ["assert {}", "assert({})", "assert ( ({}) )"])
def test_every_predicate_is_read(form, written, meant):
    assert body(form.format(written)) == (Assertion(condition=meant),)


def test_pass_and_return_alone_decline():
    assert body("# there is no lime", "pass") == (Comment(text="there is no lime"), Pass())
    assert body("return") == (Pass(),)


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("import os", "import is not part of"),
        ("from os import system", "from is not part of"),
        ("os.system('ls')", "attributes are not part of"),
        ("grab('lime').now()", "no operators"),
        ("x = 'lime'", "only objects = [...] is assigned"),
        ("grab(x)", "in quotes"),
        ("grab(find('lime'))", "in quotes"),
        ("grab(obj=x)", "in quotes"),
        ("grab(obj='lime', obj='pie')", "given twice"),
        ("grab(obj='lime', 'pie')", "stands before"),
        ("grab(*'lime')", "has no place"),
        ("grab(f'lime')", "in quotes"),
        ("grab('li' 'me')", "commas between"),
        ("grab('lime') + 1", "no operators"),
        ("grab('lime' + 'pie')", "commas between"),
        ("grab(1 + 'pie')", "added or taken away"),
        ("grab(1e308 + 1e308)", "smaller"),
        ("grab({'lime': 1})", "in quotes"),
        ("grab('lime') - 1", "no operators"),
        ("grab('lime'); grab('pie')", "has no place"),
        ("grab", "a call reads"),
        ("(grab('lime'))", "a statement is a call"),
        ("lambda: grab('lime')", "lambda is not part of"),
        ("for x in ['lime']: grab(x)", "on the lines below"),
        ("for x in ['lime']:", "at least one statement"),
        ("for x in range(9):", "a loop reads"),
        ("for x in 'lime':", "a loop reads"),
        ("for objects in ['lime']:", "meaning of its own"),
        ("for x, y in ['lime']:", "a loop reads"),
        ("for x in [y for z in objects]:", "a filter reads"),
        ("for x in [y.name for y in objects]:", "in quotes"),
        ("for x in [y for y in objects if y]:", "between two names"),
        ("if 'lime' in 'bowl':", "at least one statement"),
        ("if 'lime' in 'bowl': grab('lime')", "on the lines below"),
        ("if True:", "an assertion reads"),
        ("elif 'lime' in 'bowl':", "elif is not part of"),
        ("else:", "stands below the if"),
        ("while 'lime' in 'bowl':", "while is not part of"),
        ("grab(1e999)", "smaller"),
        ("assert 'lime'", "between two names"),
        ("assert 'lime' in 'bowl', 'it is not'", "recovery call"),
        ("assert 'lime' is 'happy'", "after is stands one of"),
        ("assert near(3)", "names in quotes"),
        ("assert near()", "no object"),
        ("assert True", "an assertion reads"),
        ("assert 'a' in 'b' and 'c'", "between two names"),
        ("assert 'a' in 'b' xor 'c' in 'd'", "no operators"),
        ("assert 'a' in []", "between 1 and"),
        ("assert kind('a', 'b') == 'c'", "a property reads"),
        ("assert count('a') == 1", "count reads"),
        ("assert " + "not " * 200 + "near('a')", "nests deeper"),
        ("assert " + "any_of(" * 7 + "near('a')" + ")" * 7 + " or 1", "an assertion reads"),
        ("else: grab('lime')", "there is none above"),
        ("    grab('lime')", "open blocks"),
        ("def g(): pass", "one function"),
        ("class A: pass", "one function"),
        ("return 'lime'", "no value"),
        ("'just a string'", "does nothing"),
        ("objects = ['late']", "move it up"),
    ],
)
def test_other_python_is_refused_with_its_line_and_a_way_out(line, message):
    text = f"def f():\n    find('lime')\n    {line}\n"
    with pytest.raises(ProgramRefused) as refused:
        parse_program(text)
    assert refused.value.faults[0].field == "program.line 3"
    assert message in refused.value.faults[0].message


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "has no function"),
        ("# only a remark", "has no function"),
        ("grab('lime')", "before the function only"),
        ("  grab('lime')", "stands in no function"),
        ("import os\ndef f():\n  pass", "before the function only"),
        ("from os import path\ndef f():\n  pass", "remove other imports"),
        ("def f(item):\n  pass", "no parameters"),
        ("def f() -> None:\n  pass", "def name()"),
        ("def f(): pass", "on the lines below"),
        ("def f():\n", "no statement"),
        ("def f():\n  # nothing comes to mind\n", "no statement"),
        ("def f():\npass", "outside the function"),
        ("def f():\n  pass\nf()", "outside the function"),
        ("objects = [1]\ndef f():\n  pass", "names in quotes"),
        ("def f():\n  pass\n  assert near('a')\n    else:\n      b('a')", "same line"),
    ],
)
def test_a_program_without_its_frame_is_refused(text, message):
    with pytest.raises(ProgramRefused, match=r"program") as refused:
        parse_program(text)
    assert message in str(refused.value)


def test_every_faulty_line_is_told_of_up_to_a_limit():
    faulty = [f"  x = {number}" for number in range(30)]
    with pytest.raises(ProgramRefused) as refused:
        parse_program("\n".join(["def f():", *faulty]))
    assert [fault.field for fault in refused.value.faults] == [
        f"program.line {number + 2}" for number in range(MAX_FAULTS)
    ]


def test_a_program_holds_so_many_statements_and_no_more():
    lines = ["  a('x')"] * MAX_STATEMENTS
    assert len(parse_program("\n".join(["def f():", *lines])).body) == MAX_STATEMENTS
    with pytest.raises(ProgramRefused, match="more than"):
        parse_program("\n".join(["def f():", *lines, "  a('x')"]))


@pytest.mark.parametrize(
    "text",
    [
        "(" * MAX_CHARACTERS,
        "'" * MAX_CHARACTERS,
        '"""' * (MAX_CHARACTERS // 3),
        "''' " + "\\'" * 49_000,
        "a " * (MAX_CHARACTERS // 2),
        "\n" * MAX_CHARACTERS,
        "\\" * MAX_CHARACTERS,
        "def f():\n  x(" + "1," * 49_000 + ")",
        "def f():\n  assert " + "not " * 20_000,
        "def f():\n  assert near('a')\n" + "    else: b('a')\n" * 6_000,
        "objects = [" + "'a'," * 20_000 + "]\ndef f():\n  pass",
    ],
    ids=lambda text: f"{text[:12]!r}…",
)
def test_no_text_takes_long(text):
    started = time.process_time()
    with contextlib.suppress(ProgramRefused):
        parse_program(text)
    assert time.process_time() - started < 5


PIECES = [
    "def ", "f", "()", ":", "\n", "    ", "\t", "'lime'", '"', "'", "\\", "(", ")", "[", "]", ",",
    "assert", " in ", " is ", "not ", "else: ", "# why", "objects = ", "pass", "return", "#", "=",
    "any_of(", "count(", "0.5", "-", "1e9", "from actions import ", "'''", "\r", "\x00", "é", "😀",
    "\ud800", "lambda ", "f''", "\\u12", "\u2028", "==", "find('lime')", "3x", ".", "\x0c",
]  # fmt: skip


@settings(max_examples=500, deadline=None)
@given(st.lists(st.sampled_from(PIECES), max_size=60).map("".join))
@example("def f():\n  assert any_of()")
def test_any_mixture_of_the_language_s_pieces_is_read_or_refused(text):
    assert_read_or_refused(text)


@settings(max_examples=300, deadline=None)
@given(st.text(st.characters(), max_size=200))
def test_any_text_is_read_or_refused(text):
    assert_read_or_refused(text)
    assert_read_or_refused(f"def f():\n    {text}")


def test_thousands_of_mutated_programs_are_read_or_refused():
    dice = random.Random(7)
    read = sum(assert_read_or_refused(mutated(dice)) for _ in range(4000))
    assert 200 < read < 3800, "the mutations neither all pass nor all fail"


def mutated(dice):
    text = dice.choice([PAPER, PYTHON])
    for _ in range(dice.randint(1, 3)):
        at, until = sorted(dice.randrange(len(text) + 1) for _ in range(2))
        until = min(until, at + dice.randint(0, 12))
        kind = dice.randrange(4)
        if kind == 0:
            text = text[:at] + text[until:]
        elif kind == 1:
            text = text[:at] + dice.choice(PIECES) + text[at:]
        elif kind == 2:
            text = text[:at] + text[at:until] * 2 + text[until:]
        else:
            text = text[:at] + chr(dice.randrange(1, 0x3000)) + text[at + 1 :]
    return text


def assert_read_or_refused(text):
    faults = faults_of(text)
    assert all(fault.field.startswith("program") for fault in faults)
    return not faults


def faults_of(text):
    try:
        parse_program(text)
    except ProgramRefused as refused:
        return refused.faults
    return ()
