import pytest

from app.domain.scene import SceneObject
from app.programs.sketches.correcting import corrected, correction
from app.programs.sketches.things import read_things

THINGS = read_things(
    SceneObject(name=name, container=name in ("box", "bowl"))
    for name in ("lemon", "pear", "box", "bowl")
)


@pytest.mark.parametrize(
    ("sentence", "meant"),
    [
        ("put the lemon in the box, no wait, the pear", "put the pear in the box"),
        ("put the lemon in the box, no, in the bowl", "put the lemon in the bowl"),
        ("put the lemon in the box - sorry, I meant the bowl", "put the lemon in the bowl"),
        ("hand me the lemon, actually the pear please", "hand me the pear"),
    ],
)
def test_what_plays_the_same_part_is_put_right(sentence, meant):
    assert corrected(sentence, THINGS) == meant


@pytest.mark.parametrize(
    "sentence",
    ["put the lemon in the box", "put the lemon in the box, no, the drum", "no pears in the box"],
)
def test_what_puts_nothing_right_is_left(sentence):
    assert corrected(sentence, THINGS) == sentence


@pytest.mark.parametrize(
    ("sentence", "meant"),
    [
        ("no, I meant the pear", "put the pear in the box"),
        ("sorry, not the lemon, the pear", "put the pear in the box"),
        ("no, in the bowl", "put the lemon in the bowl"),
        ("put the pear in the bowl", None),
        ("no, that is fine", None),
    ],
)
def test_a_sentence_puts_the_one_before_right(sentence, meant):
    assert correction(sentence, "put the lemon in the box", THINGS) == meant
