import pytest

from app.domain.errors import TaskDeclined
from app.domain.scene import SceneObject
from app.programs.sketches.greetings import answer_greeting
from app.programs.sketches.things import read_things

THINGS = read_things([SceneObject(name="pear"), SceneObject(name="bowl", container=True)])


@pytest.mark.parametrize("sentence", ["hello", "Hi there!", "thanks", "Thank you so much.", "help"])
def test_a_greeting_is_answered_with_what_can_be_asked(sentence):
    with pytest.raises(TaskDeclined, match="put the pear in the bowl") as declined:
        answer_greeting(sentence, THINGS)
    assert declined.value.choices == ()


@pytest.mark.parametrize("sentence", ["hi, put the pear in the bowl", "thanks, now the pear"])
def test_what_asks_for_something_passes(sentence):
    answer_greeting(sentence, THINGS)
