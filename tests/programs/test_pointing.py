import pytest

from app.domain.scene import SceneObject
from app.programs.sketches.pointing import pointed
from app.programs.sketches.selection import Selection
from app.programs.sketches.things import read_things

LEFT, MIDDLE, RIGHT = (0.5, 0.2, 0.0), (0.5, 0.0, 0.0), (0.5, -0.2, 0.0)
ROW = {
    "plate": LEFT,
    "cup 1": LEFT,
    "cup 2": MIDDLE,
    "cup 3": RIGHT,
    "bowl": RIGHT,
    "box 1": (0.5, 0.15, 0.0),
    "box 2": (0.5, -0.15, 0.0),
    "marble": None,
}


def _pointed(sentence, **places):
    items = (SceneObject(name=name, position=place) for name, place in {**ROW, **places}.items())
    return pointed(sentence, Selection(read_things(items), frozenset(), sentence))


@pytest.mark.parametrize(
    ("said", "named"),
    [
        (
            "put the cup between the plate and the bowl in box 1",
            "put cup 2 in box 1",
        ),
        ("the cup that stands next to the plate goes in box 1", "cup 1 goes in box 1"),
        ("put the marble in the box closest to the bowl", "put the marble in box 2"),
        ("put the cup farthest from the plate in box 1", "put cup 3 in box 1"),
        ("put the two outer cups in box 1", "put cup 1 and cup 3 in box 1"),
        ("put the cups at both ends in box 1", "put cup 1 and cup 3 in box 1"),
        ("toss the two cups at the far ends into box 1", "toss cup 1 and cup 3 into box 1"),
        ("put the two leftmost cups in box 1", "put cup 1 and cup 2 in box 1"),
        ("put the rightmost two cups in box 1", "put cup 2 and cup 3 in box 1"),
        ("put the two cups on the right side in box 1", "put cup 2 and cup 3 in box 1"),
    ],
)
def test_the_sentence_has_the_names_of_things_told_by_their_places(said, named):
    assert _pointed(said) == named


@pytest.mark.parametrize(
    "said",
    [
        "put the marble next to the bowl",  # Where it is to go.
        "put the cup next to the marble in box 1",  # Nobody knows where the marble is.
        "put the cup closest to me in box 1",
        "put the cup by noon in box 1",
        "put the two outer boxes in the bowl",
        "put the three leftmost cups in box 1",
    ],
)
def test_the_sentence_stays_where_the_scene_does_not_tell(said):
    assert _pointed(said) == said


def test_of_two_that_are_as_near_none_is_named():
    said = "put the cup nearest to the marble in box 1"
    assert _pointed(said, marble=(0.5, 0.1, 0.0)) == said
