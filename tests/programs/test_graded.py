import pytest

from app.domain.scene import SceneObject
from app.programs.sketches.graded import graded
from app.programs.sketches.selection import Selection
from app.programs.sketches.things import read_things

SIZES = {"hat box": "medium", "gift box": "small", "moving box": "large"}
RISING = "put the hat box on the moving box, then put the gift box on the hat box."
FALLING = "put the hat box on the gift box, then put the moving box on the hat box."


def _graded(sentence, sizes=SIZES):
    things = read_things(
        SceneObject(name=name, properties=(("size", size),)) for name, size in sizes.items()
    )
    mat = read_things([SceneObject(name="mat")])
    return graded(sentence, Selection((*things, *mat), frozenset(), sentence))


@pytest.mark.parametrize(
    ("said", "told"),
    [
        ("Pile up the three boxes with the largest at the bottom and the smallest on top.", RISING),
        ("stack the boxes from biggest to smallest", RISING),
        ("stack the boxes by size", RISING),
        ("stack the boxes with the smallest at the bottom", FALLING),
        (
            "stack the boxes on the mat, biggest first",
            f"put the moving box on the mat, then {RISING}",
        ),
    ],
)
def test_a_tower_by_size_is_told_by_names(said, told):
    assert _graded(said) == told


def test_sizes_that_nobody_knows_tell_no_tower():
    said = "stack the boxes from biggest to smallest"
    assert _graded(said, {"hat box": "small", "gift box": "small"}) == said


def test_a_tower_in_no_order_stays_as_it_is_told():
    said = "stack the boxes, the hat box on the gift box"
    assert _graded(said) == said
