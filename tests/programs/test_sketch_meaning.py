import pytest

from app.domain.scene import SceneObject
from app.programs.sketches.meaning import Meaning
from app.programs.sketches.phrase import read_description
from app.programs.sketches.sketch import Phrase
from app.programs.sketches.things import read_things

THINGS = read_things(SceneObject(name=name) for name in ("umbrella", "scarf", "bag"))
RAIN, SNOW = "rain is forecast", "snow is forecast"
LIKE = {RAIN: (0.6, 0.2, 0.1), SNOW: (0.4, 0.35, 0.1)}


@pytest.fixture
def called_for():
    def judge(text, things):
        scores = dict(zip(("umbrella", "scarf", "bag"), LIKE.get(text, (0, 0, 0)), strict=True))
        return [scores[told[0]] for told in things]

    def find(situation, text="thing i will need"):
        meaning = Meaning(THINGS, f"{situation}; put what i will need in the bag", judge)
        return [thing.name for thing, _ in meaning.perhaps(read_description(text), ())]

    return find


def test_a_situation_told_beside_says_what_is_needed(called_for):
    assert called_for(RAIN) == ["umbrella"]


def test_a_situation_that_calls_for_several_things_alike_tells_none(called_for):
    assert called_for(SNOW) == []


def test_without_anybody_to_judge_nothing_is_found():
    meaning = Meaning(THINGS, "rain; put what i need in the bag", None)
    assert meaning.perhaps(read_description("thing i need"), ()) == []
    assert meaning.plainly(read_description("thing i need"), Phrase(text="thing i need"), ()) == []


def test_words_for_a_side_tell_no_use():
    meaning = Meaning(THINGS, "the bag to your right", lambda text, things: [1.0] * len(things))
    phrase = Phrase(text="bag to your right")
    assert meaning.plainly(read_description(phrase.text), phrase, ()) == []


def test_what_was_spoken_of_some_other_time_nobody_here_can_know():
    meaning = Meaning(THINGS, "the one we talked about", lambda text, things: [0.9, 0.2, 0.1])
    described = read_description("thing we talked about yesterday")
    assert meaning.perhaps(described, ()) == []
    assert meaning.plainly(described, Phrase(text=described.text), ()) == []
