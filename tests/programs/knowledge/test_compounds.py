import pytest

from app.programs.knowledge.classes import classes, normal
from app.programs.knowledge.compounds import _PIECES, apart
from app.programs.knowledge.wordnet import nouns
from app.worlds import worlds

NAMES = [kind.name for kind in worlds["household"].catalogue()]


def is_word(text):
    return any(
        knows(each) for knows in (nouns().knows, classes().knows) for each in (text, normal(text))
    )


@pytest.mark.parametrize("name", NAMES)
def test_every_class_of_the_shipped_homes_reads_as_words(name):
    said = apart(name)
    assert said.replace(" ", "") == name
    assert all(is_word(each) or each in _PIECES for each in said.split())


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("washingmachine", "washing machine"),
        ("bathroomcabinet", "bathroom cabinet"),
        ("tvstand", "tv stand"),
        ("cpuscreen", "cpu screen"),
        ("childrensroom", "childrens room"),
        ("armchair", "armchair"),
        ("bedroom", "bedroom"),
        ("newspaper", "newspaper"),
        ("toothbrush", "toothbrush"),
        ("xyzzyqux", "xyzzyqux"),
        ("coffee pot", "coffee pot"),
        ("red_block", "red_block"),
        ("Toybox", "Toybox"),
        ("洗衣机", "洗衣机"),
        ("", ""),
    ],
)
def test_a_name_is_taken_apart_where_it_is_no_word_of_its_own(name, said):
    assert apart(name) == said


def test_what_is_taken_apart_stays_so():
    assert [apart(apart(name)) for name in NAMES] == [apart(name) for name in NAMES]
