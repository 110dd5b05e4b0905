import contextlib

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.domain.condition import AnyOf, Count, Not, Relation
from app.domain.errors import GoalRefused
from app.domain.scene import Scene, SceneObject
from app.programs.conditions import check_condition, parse_condition, parse_goal, print_condition

KNOWN = {"in": 2, "on": 2, "near": 2, "open": 1}
SCENE = Scene(
    world="tabletop",
    objects=tuple(SceneObject(name=name) for name in ("banana", "bowl", "red cup")),
)
NAMES = st.one_of(
    st.sampled_from(
        ["banana", "red cup", "soup_can", "bowl (2)", '"quoted" cup', "o'brien's mug", "a, b", ")",
         "a|b", "not", "x;y", "'", '"', "\\", " padded ", "a  b", "\n", "塩", "😀", "\U0010fffd"]
    ),
    st.text(st.characters(codec="utf-8"), max_size=200),
)  # fmt: skip
WORDS = st.sampled_from(["in", "on", "left_of", "open", "held"])
CONDITIONS = st.recursive(
    st.builds(Relation, WORDS, st.lists(NAMES, min_size=1, max_size=3).map(tuple))
    | st.builds(
        Count, NAMES, st.lists(NAMES, min_size=1, max_size=3).map(tuple), st.integers(0, 9999)
    ),
    lambda inner: st.one_of(
        inner.map(Not), st.lists(inner, min_size=1, max_size=3).map(lambda c: AnyOf(tuple(c)))
    ),
    max_leaves=3,
)


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("in(banana, bowl)", Relation("in", ("banana", "bowl"))),
        ("  on( red cup ,soup_can ) ", Relation("on", ("red cup", "soup_can"))),
        ("not open(drawer)", Not(Relation("open", ("drawer",)))),
        ("in(napkin,bowl (2))", Relation("in", ("napkin", "bowl (2)"))),
        ('in("quoted" cup,shelf)', Relation("in", ('"quoted" cup', "shelf"))),
        ("in(o'brien's mug,tray)", Relation("in", ("o'brien's mug", "tray"))),
        ("in('a, b', \"it's\")", Relation("in", ("a, b", "it's"))),
        (
            "any_of(in(a, b), not on(a, b))",
            AnyOf((Relation("in", ("a", "b")), Not(Relation("on", ("a", "b"))))),
        ),
        ("count(box; red block | blue block) = 1", Count("box", ("red block", "blue block"), 1)),
        ("count(box;a|b)==2", Count("box", ("a", "b"), 2)),
    ],
)
def test_every_form_is_read(written, meant):
    assert parse_condition(written) == meant


@settings(max_examples=400, deadline=None)
@given(CONDITIONS)
def test_reading_what_was_printed_gives_the_condition_back(condition):
    if str(condition).count("not ") + str(condition).count("any_of") < 6:
        assert parse_condition(print_condition(condition)) == condition


def test_plain_names_are_printed_without_quotes():
    condition = Not(Relation("in", ("red cup", "a,b")))
    assert print_condition(condition) == "not in(red cup, 'a,b')"


@pytest.mark.parametrize(
    "text",
    ["", "banana", "in", "in(", "in()", "in(a", "in(a,)", "in(a, b", "in(a, b) and more", "in(a)(b)",
     "not", "any_of()", "count(box; a)", "count(box; a) = x", "count(box) = 1", "count(;a) = 1",
     "count(b; a) = 12345", "🦆(a, b)", "not " * 300 + "in(a, b)", "any_of(" * 99, "(" * 500,
     "in(" * 500, "x" * 20_000, "in('" + "\\" * 9_000],
)  # fmt: skip
def test_a_malformed_condition_is_refused_by_name(text):
    with pytest.raises(GoalRefused) as refused:
        parse_condition(text, field="goal.3")
    assert refused.value.faults[0].field == "goal.3"


@settings(max_examples=400, deadline=None)
@given(
    st.lists(
        st.sampled_from(
            [
                "in",
                "not ",
                "any_of",
                "count",
                "(",
                ")",
                ",",
                ";",
                "|",
                "=",
                "'",
                '"',
                "\\",
                "a",
                " ",
            ]
        ),
        max_size=25,
    ).map("".join)
)
def test_any_text_is_read_or_refused(text):
    with contextlib.suppress(GoalRefused):
        parse_condition(text)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("inside(banana, bowl)", "no relation 'inside'; known: in, near, on, open"),
        ("in(banana)", "in speaks of 2 object(s), not 1"),
        ("in(bannana, bowl)", "did you mean 'banana'?"),
        ("in(xylophone, bowl)", "there is: banana, bowl, red cup"),
        ("in(bowl, bowl)", "different objects"),
        ("any_of(in(banana, bowl), not open(door))", "no object 'door'"),
        ("count(bowl; banana | spoon) = 1", "no object 'spoon'"),
    ],
)
def test_what_the_scene_cannot_decide_is_refused(text, message):
    with pytest.raises(GoalRefused) as refused:
        check_condition(parse_condition(text), SCENE, KNOWN, field="goal.0")
    assert refused.value.faults[0].field == "goal.0"
    assert message in refused.value.faults[0].message


def test_a_goal_names_every_condition_that_is_wrong():
    with pytest.raises(GoalRefused) as refused:
        parse_goal(["in(banana, bowl)", "in(", "in(banana, cup)"], SCENE, KNOWN)
    assert [fault.field for fault in refused.value.faults] == ["goal.1", "goal.2"]


def test_a_good_goal_is_read_whole():
    goal = parse_goal(["in(banana, bowl)", "not on(red cup, bowl)"], SCENE, KNOWN)
    assert [str(each) for each in goal.conditions] == ["in(banana, bowl)", "not on(red cup, bowl)"]
