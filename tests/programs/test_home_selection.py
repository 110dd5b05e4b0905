from app.domain.scene import SceneObject
from app.programs.home_selection import HomeSelection
from app.programs.sketch import Phrase


def _home(sentence, here, **things):
    objects = tuple(
        SceneObject(name=name, category="thing", properties=(("room", room),))
        for name, room in things.items()
    )
    return HomeSelection(objects, frozenset(), sentence, lambda _, names: [0.0] * len(names), here)


def _one(home, text):
    [thing] = home.one(Phrase(text=text)).things
    return home.class_name(thing.name)


def test_of_several_that_fit_the_one_in_the_agents_room_is_meant():
    for here, meant in (("kitchen", "banana"), ("livingroom", "apple")):
        home = _home("bring me some fruit", here, apple="livingroom", banana="kitchen")
        assert _one(home, "fruit") == meant


def test_a_heap_stands_for_all_of_what_it_is_made_of():
    home = _home("wash clothes", None, slippers="bedroom", clothespile="bathroom", shirt="bedroom")
    assert _one(home, "clothes") == "clothespile"
    [heap] = home.all(Phrase(text="clothes", quantity="all")).things
    assert home.class_name(heap.name) == "clothespile"
