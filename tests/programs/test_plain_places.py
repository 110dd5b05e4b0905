import pytest

from app.domain.scene import SceneObject
from app.programs.sketches.counting_off import counted_off
from app.programs.sketches.former import named_again
from app.programs.sketches.things import read_things
from app.programs.sketches.timing import timeless
from app.programs.sketches.topics import named_whole
from app.programs.sketches.wording import plain_english


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("The radio goes on the low shelf overnight.", "The radio goes on the low shelf."),
        ("put the key in the drawer for now, please", "put the key in the drawer, please"),
        ("put the overnight bag on the bed", "put the overnight bag on the bed"),
        ("push the crate across to where the ladder stands", "push the crate to the ladder"),
    ],
)
def test_a_place_is_told_without_its_time(said, meant):
    assert timeless(said) == meant


def test_the_first_and_the_other_of_two_have_their_names():
    things = read_things(SceneObject(name=name) for name in ("plate", "clay dog", "bin", "shelf"))
    said = "The plate's chipped, the clay dog isn't. Put the first in the bin, keep the other safe on the shelf."
    assert named_again(said, things).endswith(
        "Put the plate in the bin, put the clay dog on the shelf."
    )


def test_the_first_of_three_stays_as_it_was_said():
    things = read_things(SceneObject(name=name) for name in ("plate", "cup", "fork", "bin"))
    said = "a plate, a cup and a fork: put the first in the bin and the other on the shelf"
    assert named_again(said, things) == said


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        (
            "Keep me one candle for the porch and put the other three in the tin.",
            "put three candles in the tin.",
        ),
        ("leave one egg, then move the other two to the bowl", "move two eggs to the bowl"),
        ("save two figs and take the other one to the bowl", "take one fig to the bowl"),
        ("We need one fig. Put the other two in the bowl.", "Put two figs in the bowl."),
        ("put the other two in the bowl", "put the other two in the bowl"),
    ],
)
def test_of_a_kind_of_which_some_stay_the_number_of_the_others_counts(said, meant):
    assert counted_off(said) == meant


def test_all_of_it_is_what_was_spoken_of():
    said = "The bread must keep dry. Put all of it in the tin."
    assert named_whole(said) == "The bread must keep dry. Put all the bread in the tin."


def test_what_has_to_stay_cold_is_not_left_where_it_is():
    said = plain_english("The butter has to stay cold. Put it on the ice.", ["butter", "ice"])
    assert "butter" in said


def test_in_french_into_it_is_said_behind_the_verb():
    said = plain_english(
        "Ouvre la boîte et mets-y la clé, je la cherche souvent.", ["box", "key", "door"]
    )
    assert said == "open the box and put the key in."
