from app.programs.knowledge.synonyms import mean_the_same
from app.programs.knowledge.wordnet import nouns


def test_a_noun_is_a_kind_of_what_is_above_it():
    assert nouns().kind_of("poodle", "dog") > 0.5
    assert nouns().kind_of("dog", "poodle") == 0


def test_words_for_the_same_thing_are_known():
    assert mean_the_same("sofa", "couch")
    assert mean_the_same("torch", "flashlight")
    assert not mean_the_same("lemon", "lime")
