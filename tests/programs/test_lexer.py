import pytest

from app.domain.errors import ProgramRefused
from app.programs.lexer import MAX_BRACKET_DEPTH, MAX_CHARACTERS, read_lines


def strings(text):
    return [token.text for line in read_lines(text) for token in line.tokens]


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        (r"'driver\'s cup'", "driver's cup"),
        (r'"say \"hi\""', 'say "hi"'),
        (r"'two\nlines'", "two\nlines"),
        (r"'\x41\u00e9\U0001F600\101'", "Aé😀A"),
        (r"'back\\slash \q'", "back\\slash \\q"),
        ("'😀 塩'", "😀 塩"),
        ('"""three\n"quoted" lines"""', 'three\n"quoted" lines'),
    ],
)
def test_a_string_means_what_it_means_in_python(written, meant):
    assert strings(written) == [meant]


def test_brackets_carry_a_line_over_several_lines_of_text():
    lines = list(read_lines("a(\n  'x',\n\n'y')\nb()\r\nc()\rd()"))
    assert [(line.number, len(line.tokens)) for line in lines] == [(1, 6), (5, 3), (6, 3), (7, 3)]


def test_a_tab_indents_to_the_next_multiple_of_eight():
    assert [line.indent for line in read_lines("a\n  b\n\tc\n  \td")] == [0, 2, 8, 8]


@pytest.mark.parametrize(
    ("text", "field", "message"),
    [
        ("ok()\nfind('lime)", "program.line 2", "never closed"),
        ("'''never\nclosed", "program.line 1", "never closed"),
        ("a(\n(\n'x'", "program.line 2", "never closed"),
        ("a)\n", "program.line 1", "closes nothing"),
        ("\n\nf'{x}' @ 3", "program.line 3", "'@' has no place"),
        ("a('\\ud800')", "program.line 1", "surrogate"),
        ("a('x\ud800')", "program.line 1", "surrogate"),
        ("\na('x\x00')", "program.line 2", "NUL"),
        ("a('\\U00110000')", "program.line 1", "no character"),
        ("a('\\N{BULLET}')", "program.line 1", "escape"),
        ("a(12x)", "program.line 1", "a number is written like"),
        ("a(٣)", "program.line 1", "a number is written like"),
        ("(" * 200, "program.line 1", f"deeper than {MAX_BRACKET_DEPTH}"),
        ("#" * (MAX_CHARACTERS + 1), "program", f"at most {MAX_CHARACTERS}"),
    ],
)
def test_what_has_no_place_is_refused_with_its_line(text, field, message):
    with pytest.raises(ProgramRefused) as refused:
        list(read_lines(text))
    assert refused.value.faults[0].field == field
    assert message in refused.value.faults[0].message
