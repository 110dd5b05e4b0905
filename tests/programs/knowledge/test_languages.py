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
        (
            "Mach bitte die Kiste auf und leg die Birne in den Korb",
            "open the box and put the pear in the basket",
        ),
        ("doe de la dicht", "close the drawer"),
        ("Kannst du den Apfel in die Schüssel legen?", "put the apple in the bowl?"),
        ("gieß den Saft in die Tasse", "pour the juice in the cup"),
        ("versa il succo nella tazza", "pour the juice in the cup"),
        ("pon el plátano en el plato", "put the banana in the plate"),
        ("mets toutes les pommes dans la boîte rouge", "put all the apples in the red box"),
        ("leg de appel in de kom", "put the apple in the bowl"),
        ("把梨放在盘子上", "put the pear in the plate"),
        ("leg de appel en de banaan in de kom", "put the apple and the banana in the bowl"),
        ("leg die Birne in die Küchenschublade", "put the pear in the kitchen drawer"),
        ("metti tutte le mele rosse nel piatto", "put all the red apples in the plate"),
        ("põe a maçã na caixa de ferramentas", "put the apple in the toolbox"),
        ("put teh bananna in the bwol", "put the banana in the bowl"),
        (
            "opne the box and put the banana in the boul",
            "open the box and put the banana in the bowl",
        ),
        ("put the borwn bananas in the bowl", "put the brown bananas in the bowl"),
        ("putthe banana inthe bowl", "put the banana in the bowl"),
        ("put thebanana in thebowl", "put the banana in the bowl"),
        ("put the banana in the bowl", "put the banana in the bowl"),
    ],
)
def test_a_sentence_is_put_into_plain_english(typed, english):
    assert plain_english(typed, ["banana", "bowl", "bannana peel", "kitchen drawer"]) == english


def test_a_word_that_exists_is_mended_in_a_sentence_full_of_slips_alone():
    names = ["strawberry", "bowl", "plate"]
    assert "in the bowl" in plain_english("strawbery in the bowel, rest on the plaet", names)
    assert "bowel" in plain_english("put the strawberry in the bowel", names)


@pytest.mark.parametrize(
    "typed",
    [
        "Mete el tomate en la cacerola, pero deja el limón donde está.",
        "No toques el limón, mete el tomate en la cacerola",
    ],
)
def test_what_is_left_is_not_put(typed):
    assert "leave the lemon" in plain_english(typed, ["lemon", "tomato", "saucepan"]).lower()


@pytest.mark.parametrize(
    "typed",
    [
        "keep the thin book, the cold would kill it, and it might be meant for you",
        "not the wild one: it sleeps, minus any fuss, in a pair of boxes",
        "the box is closed and it's blocking my view of the class on the 24th",
    ],
)
def test_words_that_are_english_are_no_slips(typed):
    names = ["thing", "toy sheep", "meat", "money", "bowl"]
    assert plain_english(typed, names) == typed
