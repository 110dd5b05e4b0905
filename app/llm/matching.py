"""Matching: which of several phrases says the same as a step, by sentence embeddings."""

import re
from collections.abc import Sequence

import numpy as np

from app.llm.embeddings import sentence_embedder

NAMED = 1.0
"""What a name's appearing in the text adds to its likeness."""


def nearest(text: str, phrases: Sequence[str]) -> tuple[int, float]:
    """The place of the likest phrase, and its likeness: the cosine of their vectors.

    Raises:
        ModelUnavailable: the weights of the sentence embeddings cannot be had.
        ValueError: there is no phrase.
    """
    likeness = _likeness(text, phrases)
    best = int(np.argmax(likeness))
    return best, float(likeness[best])


def ranked(text: str, phrases: Sequence[str]) -> tuple[int, ...]:
    """The places of the phrases, the one most like the text first.

    Raises:
        ModelUnavailable: the weights of the sentence embeddings cannot be had.
    """
    return tuple(np.argsort(-_likeness(text, phrases), kind="stable").tolist())


def likeliest_names(text: str, names: Sequence[str], most: int) -> tuple[str, ...]:
    """The names, at most so many, that the text most likely speaks of; in the order given.

    Names that stand in the text come first, then those nearest in meaning.

    Raises:
        ModelUnavailable: the weights of the sentence embeddings cannot be had.
    """
    if len(names) <= most:
        return tuple(names)
    words = _words(text)
    told = np.array([NAMED * (_words(name) <= words) for name in names])
    order = np.argsort(-(_likeness(text, names) + told), kind="stable")[:most]
    return tuple(names[int(place)] for place in sorted(order))


def _likeness(text: str, phrases: Sequence[str]) -> np.ndarray:
    """Cosines, (n,)."""
    embedder = sentence_embedder()
    (vector,) = embedder.embed([text])
    return embedder.embed(phrases) @ vector


def _words(text: str) -> set[str]:
    """Without the plural's s: good enough to tell what is named."""
    return {word.rstrip("s") for word in re.findall(r"\w+", text.lower())}
