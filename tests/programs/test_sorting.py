import pytest

from app.domain.scene import SceneObject
from app.programs.sketches.selection import Selection
from app.programs.sketches.sorting import sorted_out
from app.programs.sketches.things import read_things

NAMES = ("egg shell", "newspaper", "beer bottle", "compost bin", "paper bin", "glass bin", "sponge")


def _sorted(sentence):
    things = read_things(SceneObject(name=name) for name in NAMES)
    return sorted_out(sentence, Selection(things, frozenset(), sentence))


@pytest.mark.parametrize(
    "said",
    [
        "Sort the rubbish into the right bins.",
        "Please divide the waste between the compost bin, the paper bin and the glass bin properly.",
    ],
)
def test_each_thing_goes_into_the_container_of_its_kind(said):
    told = "put the egg shell in the compost bin, the newspaper in the paper bin, the beer bottle in the glass bin."
    assert _sorted(said).removeprefix("Please ") == told


def test_what_the_containers_do_not_tell_is_not_sorted():
    said = "sort the pens into the two boxes"
    assert _sorted(said) == said
