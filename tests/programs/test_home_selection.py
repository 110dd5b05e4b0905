"""Words are looked up among the classes of a shipped home, whose names are written in one word."""

import pytest

from app.domain.errors import TaskDeclined
from app.domain.scene import Scene, SceneObject
from app.programs.home_selection import HomeSelection
from app.programs.sketches.sketch import Phrase
from app.worlds import worlds


@pytest.fixture(scope="module")
def selection():
    household = worlds["household"]
    scene = household.complete(Scene(world="household", environment="env0"), 0)
    facts = household.open_perfect(scene, 0).facts()
    return HomeSelection(scene.objects, facts, "", lambda _, things: [0.0] * len(things))


def one(selection, text, **more):
    (thing,) = selection.one(Phrase(text=text), **more).things
    return selection.class_name(thing.name)


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("coffee table", "coffeetable"),
        ("washing machine", "washingmachine"),
        ("television", "tv"),
        ("glass of water", "waterglass"),
        ("the lamp", "ceilinglamp"),
    ],
)
def test_words_mean_a_class_though_its_name_is_written_in_one(selection, text, name):
    assert one(selection, text) == name


@pytest.mark.parametrize("text", ["couch in the living room", "living room couch"])
def test_the_room_is_told_before_or_after(selection, text):
    assert one(selection, text) == "sofa"


def test_of_things_as_good_the_room_that_is_told_decides(selection):
    assert one(selection, "cabinet in the kitchen") == "kitchencabinet"
    assert one(selection, "cabinet in the bathroom") == "bathroomcabinet"


def test_a_thing_named_after_a_room_is_not_taken_apart(selection):
    assert one(selection, "kitchen table") == "kitchentable"
    assert one(selection, "bathroom cabinet") == "bathroomcabinet"
    assert one(selection, "kitchen") == "kitchen"


def test_several_that_fit_are_not_asked_about(selection):
    assert one(selection, "cabinet") in ("bathroomcabinet", "kitchencabinet")


def test_words_too_many_are_let_go(selection):
    assert one(selection, "book on the highest shelf") == "book"


def test_a_thing_named_after_what_is_wanted_stands_in(selection):
    assert one(selection, "coffee") == "coffeemaker"


def test_what_affords_the_call_is_preferred(selection):
    assert one(selection, "coffee", affordance="surfaces") == "coffeetable"
    assert one(selection, "coffee table", affordance="grabbable") == "coffeetable"


def test_what_is_left_out_is_not_meant(selection):
    assert one(selection, "cabinet", without=("bathroom cabinet",)) == "kitchencabinet"


def test_a_set_is_every_class_that_fits(selection):
    found = selection.all(Phrase(text="fruits", quantity="all")).things
    assert [selection.class_name(each.name) for each in found] == ["apple", "banana"]


def test_a_set_of_one_that_fits_loosely_is_that_one(selection):
    found = selection.all(Phrase(text="books on the highest shelf", quantity="all")).things
    assert [each.name for each in found] == ["book"]


def test_what_is_absent_is_declined_with_what_there_is(selection):
    for ask in (selection.one, selection.all):
        with pytest.raises(TaskDeclined, match="there is no zebra here") as declined:
            ask(Phrase(text="zebra"))
        assert declined.value.kind == "absent"
    assert not selection.possible(Phrase(text="zebra"))
    assert selection.possible(Phrase(text="book on the highest shelf"))


def _home(sentence, here, **things):
    objects = tuple(
        SceneObject(name=name, category="thing", properties=(("room", room),))
        for name, room in things.items()
    )
    return HomeSelection(objects, frozenset(), sentence, lambda _, names: [0.0] * len(names), here)


def test_of_several_that_fit_the_one_in_the_agents_room_is_meant():
    for here, meant in (("kitchen", "banana"), ("livingroom", "apple")):
        home = _home("bring me some fruit", here, apple="livingroom", banana="kitchen")
        assert one(home, "fruit") == meant


def test_a_heap_stands_for_all_of_what_it_is_made_of():
    home = _home("wash clothes", None, slippers="bedroom", clothespile="bathroom", shirt="bedroom")
    assert one(home, "clothes") == "clothespile"
    [heap] = home.all(Phrase(text="clothes", quantity="all")).things
    assert home.class_name(heap.name) == "clothespile"
