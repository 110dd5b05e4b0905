import time

import pytest

from app.domain.errors import ModelUnavailable
from app.domain.llm import Completion
from app.evaluation.model_speed import CANDIDATES, bench_model


class Slow:
    """Reads 4,000 tokens/s in pieces of 20 and writes 200 tokens/s; scores at 1 ms a candidate."""

    name = "slow"
    follows_grammar = False

    def __init__(self, scores=True):
        self.scores = scores

    def complete(self, request, on_text=None):
        read = len(request.prompt) // 4
        said = 0
        finish = "length"
        for step in range(read // 20 + request.max_tokens):
            reading = step < read // 20
            time.sleep(0.005)
            said += not reading
            if on_text and on_text("" if reading else "a "):
                finish = "cancelled"
                break
        return Completion(text="a " * said, model=self.name, finish=finish, prompt_tokens=read,
                          completion_tokens=said, seconds=0.0)  # fmt: skip

    def score(self, prompt, candidates):
        if not self.scores:
            raise ModelUnavailable("it tells no probabilities")
        time.sleep(0.001 * len(candidates))
        return (0.0,) * len(candidates)


@pytest.fixture(scope="module")
def measured():
    return bench_model(Slow())


def test_reading_and_writing_are_told_apart(measured):
    assert 1500 < measured.read_per_second <= 4100
    assert 80 < measured.written_per_second <= 200


def test_an_ending_is_timed_from_when_it_was_asked_for(measured):
    assert 0 < measured.cancel_writing[0] < 0.2


def test_the_scoring_of_all_candidates_is_timed(measured):
    assert measured.score_seconds >= 0.001 * CANDIDATES


def test_a_model_without_probabilities_is_measured_all_the_same():
    assert bench_model(Slow(scores=False)).score_seconds is None
