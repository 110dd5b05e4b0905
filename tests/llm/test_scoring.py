import math

import pytest

from app.llm.scoring import score_sequences

LIKELY = {(): {1: 0.5, 2: 0.25}, (1,): {3: 0.5, 4: 0.125}, (2,): {}, (1, 3): {5: 0.5, 6: 0.5}}


class Model:
    """Tells the probabilities above, and remembers where it was asked."""

    def __init__(self):
        self.asked = []

    def __call__(self, tokens):
        self.asked.append(tokens)
        return {token: math.log(value) for token, value in LIKELY[tokens].items()}


def scores(*sequences):
    model = Model()
    return [math.exp(score) for score in score_sequences(sequences, model)], model.asked


def test_probabilities_multiply_along_the_branches():
    found, asked = scores((1, 3), (1, 4), (2, 9))
    assert found == pytest.approx([0.25, 0.0625, 0.25])
    assert asked == [(), (1,)]


def test_what_is_common_to_all_is_not_asked_for():
    found, asked = scores((1, 3, 5), (1, 3, 6))
    assert found == pytest.approx([0.5, 0.5])
    assert asked == [(1, 3)]


def test_unlikely_token_is_worth_no_more_than_the_least_one_told():
    found, _ = scores((1,), (7,))
    assert found == pytest.approx([0.5, 0.25])


def test_candidate_that_another_goes_on_with_ends_where_it_ends():
    found, asked = scores((1,), (1, 3), (2,))
    assert found == pytest.approx([0.5, 0.25, 0.25])
    assert asked == [(), (1,)]


def test_same_candidate_twice_is_scored_alike():
    found, _ = scores((1, 3), (2,), (1, 3))
    assert found == pytest.approx([0.5, 0.25, 0.5])


def test_a_lone_candidate_or_none_is_nothing_to_choose():
    assert scores((1, 3)) == ([1.0], [])
    assert scores() == ([], [])
