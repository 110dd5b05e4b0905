from dataclasses import replace

import pytest

from app.domain.errors import ModelUnavailable
from app.llm.backends.scripted import Answer, ScriptedModel
from app.planners.zero_shot import SAMPLES, ZeroShot

pytestmark = [pytest.mark.model, pytest.mark.timeout(1800)]


def write(text, task, canned):
    model = canned(text)
    return ZeroShot().write_program(task(name="zero_shot"), model, lambda _: False), model


def test_prompt_has_the_nearest_example_alone_and_no_objects(task, canned):
    draft, _ = write(" done", task, canned)
    assert draft.prompt.count("Task: ") == 2
    assert draft.prompt.startswith("Task: put the ")
    assert draft.prompt.endswith("\n\nTask: put the banana in the bowl\n1.")
    assert "Objects" not in draft.prompt


def test_every_step_is_sampled_anew_with_the_steps_so_far_in_the_prompt(task, canned):
    draft, model = write(" place the banana in the bowl", task, canned)
    assert "grab_and_putin('banana', 'bowl')" in draft.program
    assert len({request.seed for request in model.requests}) == len(model.requests) == 2 * SAMPLES
    assert model.requests[-1].prompt == (
        f"{draft.prompt} grab the banana and put it in the bowl\n2."
    )


def test_text_that_is_no_action_ends_the_plan(task, canned):
    draft, model = write(" whistle a merry tune", task, canned)
    assert draft.program.splitlines()[1:] == ["    pass"]
    assert len(model.requests) == SAMPLES


class Doubting(ScriptedModel):
    """Tells another log-probability than its script's certainty."""

    def __init__(self, text, logprob):
        super().__init__([Answer(text=text)])
        self.logprob = logprob

    def complete(self, request, on_text=None):
        return replace(super().complete(request, on_text), logprob=self.logprob)


def test_samples_are_weighed_by_their_log_probability(task):
    model = Doubting(" grab the banana and put it in the bowl", -2.0)
    draft = ZeroShot().write_program(task(name="zero_shot"), model, lambda _: False)
    assert "pass" in draft.program


def test_service_that_tells_no_log_probabilities_is_of_no_use(task):
    with pytest.raises(ModelUnavailable, match="does not tell log-probabilities"):
        ZeroShot().write_program(task(name="zero_shot"), Doubting(" done", None), lambda _: False)
