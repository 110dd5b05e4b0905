import pytest

from app.domain.errors import ProgramRefused
from app.domain.program import Described
from app.programs.parser import parse_program
from app.programs.printer import print_program


def read(line):
    return parse_program(f"def f():\n    objects = {line}\n    pass\n")


def test_a_scene_graph_is_read_and_its_names_are_the_objects():
    program = read(
        "{'tray': {'material': 'wood', 'high': 0.02, 'flat': True,\n"
        "          'on it': {'cup': {'in it': ['tea bag']}, 'plum': 'ripe fruit'}},\n"
        " 'lime': {'state': ['cut', 'washed']}}"
    )
    assert program.objects == ("tray", "cup", "tea bag", "plum", "lime")
    tray, lime = program.described
    assert tray.properties == (("material", "wood"), ("high", 0.02), ("flat", True))
    assert lime == Described(name="lime", properties=(("state", ("cut", "washed")),))
    assert tray.holds == (
        (
            "on it",
            (
                Described(name="cup", holds=(("in it", (Described(name="tea bag"),)),)),
                Described(name="plum", properties=(("is", "ripe fruit"),)),
            ),
        ),
    )
    assert parse_program(print_program(program)) == program


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("{'lime': {'at': {'x': 1}}}", "stand under 'in it' or 'on it' only"),
        ("{'lime'}", "what is known of it"),
        ("{lime: {}}", "names in quotes"),
        ("{'lime': {colour: 'red'}}", "a name in quotes"),
        ("{'lime': {'colour': red}}", "in quotes"),
        ("{'lime': {'on it': 'cup'}}", "what an object holds"),
        ("('lime',)", "the object list reads"),
        ("{'a': {'in it': " * 5 + "{}" + "}}" * 5, "brackets nest deeper"),
    ],
)
def test_anything_else_is_refused(line, message):
    with pytest.raises(ProgramRefused) as refused:
        read(line)
    assert message in refused.value.faults[0].message
