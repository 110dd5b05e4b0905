import pytest

from app.programs.sketches.heights import piled


@pytest.mark.parametrize(
    "sentence",
    [
        "stack the boxes, start with the biggest",
        "pile the boxes up with the large one at the bottom",
        "stack them with the smallest on top",
        "stack the boxes and top it off with the tiniest",
        "a tower of boxes, the largest first",
        "stack the boxes from small to large, upside down, so the big one is at the bottom",
    ],
)
def test_the_sentence_tells_the_order_of_a_pile(sentence):
    assert piled("smallest first", sentence) == "largest first"
    assert piled(None, sentence) == "largest first"


@pytest.mark.parametrize(
    "sentence", ["put the biggest at the bottom of the bag", "stack the small cups on the tray"]
)
def test_another_sentence_leaves_the_order_as_it_is(sentence):
    assert piled(None, sentence) is None
