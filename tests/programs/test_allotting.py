import pytest

from app.domain.scene import SceneObject
from app.programs.sketches.allotting import allotted
from app.programs.sketches.selection import Selection
from app.programs.sketches.things import read_things

NAMES = ("apple 1", "apple 2", "apple 3", "pear", "basket", "crate", "red bowl", "blue bowl")


def _allotted(sentence):
    things = read_things(SceneObject(name=name) for name in NAMES)
    return allotted(sentence, Selection(things, frozenset(), sentence))


@pytest.mark.parametrize(
    ("said", "told"),
    [
        (
            "Please share the apples evenly between the basket and the crate.",
            "Please put apple 1 and apple 3 in the basket and apple 2 in the crate.",
        ),
        (
            "divide my apples among the two bowls, please",
            "put apple 1 and apple 3 in the red bowl and apple 2 in the blue bowl, please",
        ),
        (
            "the basket and the crate each get one apple",
            "put apple 1 in the basket and apple 2 in the crate",
        ),
        (
            "give the basket and the red bowl an apple each",
            "put apple 1 in the basket and apple 2 in the red bowl",
        ),
        (
            "put one apple in each of the bowls",
            "put apple 1 in the red bowl and apple 2 in the blue bowl",
        ),
    ],
)
def test_each_share_is_told_with_its_place(said, told):
    assert _allotted(said) == told


@pytest.mark.parametrize(
    "said",
    [
        "the basket and the crate each get two apples",
        "share the plums between the basket and the crate",
        "spread the apples on the crate",
    ],
)
def test_what_does_not_come_out_stays_as_it_was_said(said):
    assert _allotted(said) == said
