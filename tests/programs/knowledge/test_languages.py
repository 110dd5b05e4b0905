import pytest

from app.programs.knowledge.languages import in_english
from app.programs.sketches.wording import plain_english


@pytest.mark.parametrize(
    ("foreign", "english"),
    [
        ("der rote Würfel", "red cube"),
        ("plátano", "banana"),
        ("bloc rouge", "red block"),
        ("roten Äpfel", "red apple"),
        ("mug", None),
        ("red block", None),
    ],
)
def test_names_of_other_languages_are_put_into_english(foreign, english):
    assert in_english(foreign) == english


@pytest.mark.parametrize(
    ("typed", "english"),
    [
        ("lege den Apfel in die Schüssel", "put the apple in the bowl"),
        ("pon el plátano en el plato", "put the banana in the plate"),
        ("mets toutes les pommes dans la boîte rouge", "put all the apples in the red box"),
        ("leg de appel in de kom", "put the apple in the bowl"),
        ("把梨放在盘子上", "put the pear in the plate"),
        ("leg de appel en de banaan in de kom", "put the apple and the banana in the bowl"),
        ("leg die Birne in die Küchenschublade", "put the pear in the kitchen drawer"),
        ("put teh bananna in the bwol", "put the banana in the bowl"),
        ("put the banana in the bowl", "put the banana in the bowl"),
    ],
)
def test_a_sentence_is_put_into_plain_english(typed, english):
    assert plain_english(typed, ["banana", "bowl", "bannana peel", "kitchen drawer"]) == english
