import pytest

from app.domain.scene import SceneObject
from app.programs.sketches.rereading import without_asides
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
