from dataclasses import replace

import pytest

from app.domain.errors import ModelUnavailable
from app.planners.saycan import SayCan


class Wishing:
    """Gives each candidate the score of the first wish it holds."""

    name = "wishing"
    follows_grammar = False

    def __init__(self, *wishes):
        self.wishes = wishes
        self.asked = []

    def score(self, prompt, candidates):
        self.asked.append((prompt, candidates))
        places = [
            next((n for n, wish in enumerate(self.wishes) if wish in each), 99)
            for each in candidates
        ]
        return tuple(float(-place) for place in places)


def steps(model, task):
    draft = SayCan().write_program(task, model, lambda _: False)
    return draft.program.splitlines()[1:], draft


def test_likeliest_of_what_can_be_done_is_next_and_then_not_possible_any_more(task):
    model = Wishing("put it in the banana", "put it in the bowl", "done")
    lines, draft = steps(model, task(name="saycan"))
    assert lines == ["    grab_and_putin('banana', 'bowl')"]
    (first, candidates), (second, left) = model.asked
    assert candidates == [" grab the banana and put it in the bowl\n", " done\n"]
    assert left == [" done\n"]
    assert first == draft.prompt
    assert second == f"{first} grab the banana and put it in the bowl\n2."


def test_model_that_wants_nothing_done_gets_an_empty_plan(task):
    assert steps(Wishing("done"), task(name="saycan"))[0] == ["    pass"]


def test_without_a_world_to_ask_it_does_not_plan(task):
    with pytest.raises(ModelUnavailable, match="no world was given"):
        steps(Wishing("done"), replace(task(name="saycan"), rehearsal=None))
