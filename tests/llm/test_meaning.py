from typing import ClassVar

import numpy as np
import pytest

from app.domain.errors import ModelUnavailable
from app.llm import meaning
from app.llm.meaning import likeness


class Known:
    """Sentences on a plane, by their angle."""

    angles: ClassVar = {"sit": 0, "chair": 30, "seat with a back": 10, "lemon": 90}

    def embed(self, texts):
        radians = np.radians([self.angles[text] for text in texts])
        return np.stack((np.cos(radians), np.sin(radians)), axis=1)


class Absent:
    def embed(self, texts):
        raise ModelUnavailable("the weights are absent")


@pytest.fixture
def with_embedder(monkeypatch):
    asked = []

    def use(embedder):
        monkeypatch.setattr(
            meaning, "sentence_embedder", lambda *, fetch: asked.append(fetch) or embedder
        )
        return asked

    return use


def test_a_thing_is_as_like_as_the_best_of_its_phrases(with_embedder):
    with_embedder(Known())
    found = likeness("sit", [("chair", "seat with a back"), ("chair",), ("lemon",)])
    assert found == pytest.approx(np.cos(np.radians([10, 30, 90])))


def test_nothing_is_like_anything_where_the_weights_are_absent(with_embedder):
    asked = with_embedder(Absent())
    assert likeness("sit", [("chair", "seat with a back"), ("lemon",)]) == [0.0, 0.0]
    assert asked == [False], "nobody waits for the weights"


@pytest.mark.model
@pytest.mark.timeout(1800)
def test_words_are_likest_to_the_thing_they_describe():
    things = [("corkscrew", "gets the cork out of a bottle"), ("pillow", "soft thing for the head")]
    cork, pillow = likeness("something to open wine with", things)
    assert cork > pillow
