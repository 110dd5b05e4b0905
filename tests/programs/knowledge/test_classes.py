import json
from pathlib import Path

import pytest

from app.domain.scene import SceneObject
from app.programs.knowledge.classes import classes
from app.programs.knowledge.membership import belonging
from app.programs.sketches.matching import SETS, fit
from app.programs.sketches.phrase import read_description
from app.programs.sketches.things import read_things

MEMBERSHIPS = json.loads(Path(__file__).with_name("memberships.json").read_text(encoding="utf-8"))


def _fits(name, phrase):
    return fit(read_things([SceneObject(name=name)])[0], read_description(phrase)) >= SETS


def test_nearly_every_thing_is_told_to_be_of_a_class_or_not():
    asked = [
        (name, phrase, wanted == "yes")
        for phrase, names in MEMBERSHIPS.items()
        for wanted in ("yes", "no")
        for name in names[wanted]
    ]
    wrong = [(name, phrase) for name, phrase, is_one in asked if _fits(name, phrase) != is_one]
    assert len(asked) > 1000
    assert len(wrong) <= 0.02 * len(asked), wrong


@pytest.mark.parametrize(
    ("phrase", "name"),
    [
        ("something to write with", "writing tool"),
        ("what a monkey likes", "something monkeys like"),
        ("edible things", "food"),
        ("pieces of cutlery", "cutlery"),
        ("the citrus", "citrus fruit"),
        ("things that tell the time", "timepiece"),
    ],
)
def test_a_class_is_known_by_what_people_call_it(phrase, name):
    found = classes().find(phrase)
    assert found
    assert found.name == name


def test_the_head_of_a_name_counts_and_its_modifier_does_not():
    fruit = classes().named("fruit")
    assert belonging("red_apple_2", fruit) == 1
    assert belonging("apple juice", fruit) == 0
    assert belonging("slice of lemon", fruit) == 1


def test_a_bottle_of_something_counts_where_its_contents_do():
    assert belonging("ketchup bottle", classes().named("condiment")) > 0.5
    assert belonging("peach can", classes().named("fruit")) < 0.5


def test_a_name_listed_as_a_whole_counts_whatever_its_head_is():
    tinned, onions = classes().named("tinned fish"), classes().named("allium")
    assert belonging("tin of tuna", tinned) == 1
    assert belonging("tuna steak", tinned) == 0
    assert belonging("onion ring", onions) == 0
    assert belonging("onion slice", onions) > 0.5


def test_what_counts_alone_counts_in_no_longer_name():
    glass = classes().named("glass recycling")
    assert belonging("old jar", glass) == 1
    assert belonging("pile of jars", glass) == 1
    assert belonging("clay jar", glass) == 0
    assert belonging("jar of honey", glass) == 0


def test_every_class_named_in_the_file_can_be_read():
    for name in classes().names():
        assert classes().named(name).name == name
