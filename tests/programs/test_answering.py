import pytest

from app.domain.errors import TaskDeclined
from app.domain.planner import Turn
from app.domain.scene import SceneObject
from app.programs.sketches.answering import clear_history, done, heard
from app.programs.sketches.things import read_things

PLACES = {
    "green block": (0.6, 0.2, 0.0),
    "blue block": (0.4, 0.3, 0.0),
    "red bowl": (0.5, -0.3, 0.0),
    "blue bowl": (0.5, 0.1, 0.0),
}
THINGS = read_things(SceneObject(name=name, position=place) for name, place in PLACES.items())
RED, BLUE = (f"put the green block in the {colour} bowl" for colour in ("red", "blue"))
ASKED = Turn(
    instruction="put the green block in the bowl",
    program="",
    outcome="Which bowl do you mean: red bowl or blue bowl?",
    choices=(RED, BLUE),
)
PUT = "def t():\n    grab_and_putin('green block', 'red bowl')\n"


@pytest.mark.parametrize(
    ("answer", "meant"),
    [
        ("red", RED),
        ("the red bowl", RED),
        ("the red one", RED),
        ("blue bowl", BLUE),
        ("no, the blue one please", BLUE),
        ("in the blue bowl", BLUE),
        ("not the red one", BLUE),
        ("the first one", RED),
        ("the second", BLUE),
        ("the last one", BLUE),
        ("the left one", BLUE),
        ("either", RED),
        ("it doesn't matter", RED),
        (BLUE, BLUE),
    ],
)
def test_an_answer_makes_the_sentence_clear(answer, meant):
    assert heard(answer, [ASKED], THINGS) == meant


@pytest.mark.parametrize(
    "sentence",
    ["the blue block", "put the blue block in the blue bowl", "put it back", "hello", "thanks"],
)
def test_what_is_no_answer_stands_for_itself(sentence):
    assert heard(sentence, [ASKED], THINGS) == sentence


def test_without_a_question_nothing_is_an_answer():
    put = Turn(instruction=RED, program=PUT)
    assert heard("blue", [ASKED, put], THINGS) == "blue"


def test_an_answer_that_leaves_it_open_is_asked_again():
    with pytest.raises(TaskDeclined) as declined:
        heard("the bowl", [ASKED], THINGS)
    assert (declined.value.question, declined.value.choices) == (ASKED.outcome, ASKED.choices)


def test_only_what_was_planned_was_done_and_says_what_it_answered():
    answer = Turn(instruction="red", program=PUT)
    assert done(clear_history([ASKED, answer, ASKED], THINGS)) == (
        Turn(instruction=RED, program=PUT),
    )
