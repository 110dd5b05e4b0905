import pytest

from app.domain.errors import TaskDeclined
from app.domain.planner import Turn
from app.domain.scene import SceneObject
from app.programs.sketches.others import other_named
from app.programs.sketches.things import read_things

DONE = [Turn(instruction="", program="def t():\n    grab_and_putin('banana', 'plate')\n")]


def things(*names):
    fruits = ("banana", "pear", "lemon")
    kinds = {name: "fruit" if name in fruits else "object" for name in names}
    return read_things(SceneObject(name=name, category=kinds[name]) for name in names)


def test_the_only_other_one_of_the_kind_is_named():
    here = things("banana", "pear", "sponge", "plate")
    assert other_named("now the other one", DONE, here) == "now the pear"


def test_of_several_others_it_is_asked_which():
    with pytest.raises(TaskDeclined) as declined:
        other_named("now the other one", DONE, things("banana", "pear", "lemon", "plate"))
    assert declined.value.choices == ("now the pear", "now the lemon")


def test_where_the_sentence_names_the_first_one_it_is_not_the_turn_before_that_tells():
    said = "put the spoon in the bowl and the other one on the plate"
    assert other_named(said, DONE, things("banana", "pear", "spoon", "plate")) == said
