import pytest

from app.domain.action import ActionSignature, Parameter
from app.domain.errors import TaskDeclined
from app.domain.scene import SceneObject
from app.programs.sketches.leaving_out import completed
from app.programs.sketches.selection import Selection
from app.programs.sketches.things import read_things

WIPE = ActionSignature(
    name="wipe", parameters=(Parameter(name="obj"), Parameter(name="tool")), meaning=""
)
HOLDERS = ("box", "bin", "tray", "bottle")


def filled(sentence, actions, *names):
    things = read_things(SceneObject(name=name, container=name in HOLDERS) for name in names)
    return completed(sentence, Selection(things, frozenset(), sentence), actions)


@pytest.mark.parametrize(
    ("sentence", "told"),
    [
        ("put away the hammer", "put the hammer in the box"),
        ("please put the hammer away", "put the hammer in the box"),
        ("clear the table", "put everything in the box"),
        ("tidy up!", "put everything in the box"),
        ("put the hammer in the box", "put the hammer in the box"),
        ("put the drum away", "put the drum away"),
    ],
)
def test_things_are_put_away_to_the_one_place_there_is(grab_and_putin, sentence, told):
    assert filled(sentence, [grab_and_putin], "hammer", "bottle", "box") == told


def test_of_several_places_it_is_asked_which(grab_and_putin):
    with pytest.raises(TaskDeclined) as declined:
        filled("put away the saw and the hammer", [grab_and_putin], "hammer", "saw", "box", "tray")
    assert declined.value.question == "Where should they go?"
    assert declined.value.choices == (
        "put the saw and the hammer in the box",
        "put the saw and the hammer in the tray",
    )


@pytest.mark.parametrize(
    "sentence", ["throw out the onion", "throw the onion away", "chuck the onion", "bin the onion"]
)
def test_what_is_thrown_out_goes_to_the_bin(grab_and_putin, sentence):
    told = "put the onion in the bin"
    assert filled(sentence, [grab_and_putin], "onion", "box", "bin") == told


def test_a_can_is_thrown_into_the_trash_can(grab_and_putin):
    told = "put the can in the trash can"
    assert filled("throw away the can", [grab_and_putin], "can", "trash can", "box") == told


def test_without_a_bin_it_is_asked_where(grab_and_putin):
    with pytest.raises(TaskDeclined) as declined:
        filled("throw out the onion", [grab_and_putin], "onion", "box")
    assert declined.value.choices == ("put the onion in the box",)


def test_a_verb_on_offer_takes_the_sentence_as_it_is():
    clear = ActionSignature(name="clear", parameters=(Parameter(name="obj"),), meaning="")
    assert filled("clear the table", [clear], "table", "box") == "clear the table"


def test_it_is_wiped_with_what_there_is_to_wipe_with(grab_and_putin):
    said = "wipe the plate"
    assert filled(said, [WIPE], "plate", "sponge") == "wipe the plate with the sponge"
    assert filled(said, [grab_and_putin], "plate", "sponge") == said
    with pytest.raises(TaskDeclined, match="nothing here to wipe"):
        filled(said, [WIPE], "plate", "fork")
