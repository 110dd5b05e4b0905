import pytest

from app.programs.knowledge.english import is_english


@pytest.mark.parametrize(
    "word", ["thin", "wild", "cutting", "carried", "closes", "largest", "ran", "might", "queasy"]
)
def test_words_are_known_in_their_forms(word):
    assert is_english(word)


@pytest.mark.parametrize("word", ["opne", "borwn", "vineger", "sope", "bananna"])
def test_slips_are_not(word):
    assert not is_english(word)
