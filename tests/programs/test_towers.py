import pytest

from app.domain.scene import SceneObject
from app.programs.sketches.things import read_things
from app.programs.sketches.towers import tower

CUBES = ("red cube", "green cube", "blue cube", "box")


def told(sentence, *names):
    return tower(sentence, read_things(SceneObject(name=name) for name in names))


@pytest.mark.parametrize(
    "sentence",
    [
        "Stack them: red at the bottom, then green, with blue on top.",
        "from top to bottom the pile should read blue cube, green cube, red cube",
        "a tower from the bottom up: red, green, blue",
        "build a tower: blue on top, green, and red at the bottom",
        "stack the green cube on the red cube and then the blue cube on the green cube",
        "red cube lowest, blue cube highest, the green cube between them: such a tower, please",
        "the red cube stays; set the green cube on it, then the blue cube on the green cube",
        "start with the red cube, set the green cube on it, then the blue cube on the green cube",
        "a tower: underneath all is the red cube, then the green cube, on top of it all the blue cube",
        "stack red, blue and green, with green in between and blue on top",
        "build a tower: the red one first, then the green one, then the blue one",
        "stack them all so that red ends up at the very bottom and blue at the very top",
        "the red one goes under the green one, the green one goes under the blue one",
        "the blue cube must lie on the green cube, which itself must lie on the red cube",
    ],
)
def test_the_words_tell_what_stands_on_what(sentence):
    assert told(sentence, *CUBES) == [("green cube", "red cube"), ("blue cube", "green cube")]


@pytest.mark.parametrize(
    "sentence",
    [
        "I want the green cube on the red cube and the blue cube crowning the pile",
        "put the green cube on the red cube, and finish it off with the blue cube",
        "the green cube goes on the red cube, then top it all off with the blue cube",
    ],
)
def test_what_a_pile_is_finished_with_comes_onto_its_top(sentence):
    assert told(sentence, *CUBES) == [("green cube", "red cube"), ("blue cube", "green cube")]


def test_a_tower_may_stand_on_something():
    pairs = told(
        "on the tray build a tower: red at the bottom, then green, then blue on top", *CUBES, "tray"
    )
    assert pairs == [("red cube", "tray"), ("green cube", "red cube"), ("blue cube", "green cube")]


def test_what_is_only_said_to_be_no_part_is_left_out():
    pairs = told(
        "a pile, from top to bottom: blue cube, green cube, red cube. The box isn't part of it.",
        *CUBES,
    )
    assert pairs == [("green cube", "red cube"), ("blue cube", "green cube")]


@pytest.mark.parametrize(
    "sentence",
    [
        "put the red cube, the green cube and the blue cube in the box",
        "stack the red cube on the blue cube",
        "stack the cubes",
        "put the red cube on top of the green cube, then the blue cube on top",
        "the red cube on the box and the green cube on the box",
    ],
)
def test_where_the_words_do_not_tell_it_plainly_nothing_is_said(sentence):
    assert told(sentence, *CUBES) is None


@pytest.mark.parametrize(
    "said", ["build a tower with green at the bottom and red on top", "stack red on green"]
)
def test_a_tower_of_colours_is_of_blocks_not_of_bowls(said):
    things = read_things(
        SceneObject(name=name, container="bowl" in name)
        for name in ("red block", "green block", "red bowl", "green bowl")
    )
    assert tower(said, things) == [("red block", "green block")]


def test_what_goes_without_something_has_none_of_it():
    said = "a burger from the bottom up: bun bottom, patty, bun top, and no onion or pickle for me"
    assert told(said, "bun bottom", "patty", "bun top", "pickle") == [
        ("patty", "bun bottom"),
        ("bun top", "patty"),
    ]


def test_a_slice_is_called_by_what_it_is_of():
    said = "slice of rye on the plate, cheese on the rye, cress on the cheese"
    assert told(said, "slice of rye", "slice of cheese", "cress", "plate") == [
        ("slice of rye", "plate"),
        ("slice of cheese", "slice of rye"),
        ("cress", "slice of cheese"),
    ]


def test_ones_are_told_apart_by_all_that_stands_before_their_noun():
    said = "pile the cushions: garden chair one first, sofa one on top of that, cat one last"
    assert told(said, "garden chair cushion", "sofa cushion", "cat cushion") == [
        ("sofa cushion", "garden chair cushion"),
        ("cat cushion", "sofa cushion"),
    ]
