import pytest

from app.domain.scene import SceneObject
from app.programs.sketches.rereading import only_order, without_asides
from app.programs.sketches.things import read_things

THINGS = read_things(
    SceneObject(name=name) for name in ("newspaper", "jam jar", "box one", "box two")
)


@pytest.mark.parametrize(
    ("said", "kept"),
    [
        ("Recycling day at the office. Newspaper in box one.", "Newspaper in box one."),
        ("Two jobs for you: the jam jar in box two.", "the jam jar in box two."),
        ("The newspaper goes in box one, it's in my way", "The newspaper goes in box one"),
    ],
)
def test_clauses_that_speak_of_nothing_that_is_there_are_left_out(said, kept):
    assert without_asides(said, THINGS) == kept


@pytest.mark.parametrize(
    "said",
    [
        "Put the newspaper in box one.",
        "Discard the hammer. Put the newspaper in box one.",
        "Fetch the hammer. Put the newspaper in box one.",
        "Recycling day at the office.",
        "The reed's gone soft, so throw it out. The jam jar goes in box two.",
    ],
)
def test_what_orders_something_is_never_left_out_nor_all_of_a_sentence(said):
    assert without_asides(said, THINGS) is None


@pytest.mark.parametrize(
    ("said", "kept"),
    [
        (
            "One jam jar in box one is enough, he's only going to the park.",
            "One jam jar in box one is enough",
        ),
        (
            "Newspaper in box two before she sees the crossword, doesn't matter how.",
            "Newspaper in box two",
        ),
    ],
)
def test_reasons_are_left_out(said, kept):
    assert without_asides(said, THINGS) == kept


def test_it_is_the_one_thing_that_is_spoken_of():
    said = "Who opened the jam jar? The wasps can smell it from the garden, so close it, will you."
    assert only_order(said, THINGS) == "close the jam jar, will you."


@pytest.mark.parametrize(
    "said",
    [
        "Put the lemon in box one and close it.",
        "The jam jar and the newspaper are a mess, so move it.",
        "Please fetch the hammer. The jam jar is open, so close it.",
        "The wasps like the jam jar.",
    ],
)
def test_what_else_is_ordered_is_not_passed_over(said):
    assert only_order(said, THINGS) is None
