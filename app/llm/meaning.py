"""How like things are to words in meaning, by sentence embeddings."""

from collections.abc import Sequence

from app.domain.errors import ModelUnavailable
from app.llm.embeddings import sentence_embedder


def likeness(text: str, things: Sequence[Sequence[str]]) -> Sequence[float]:
    """For each thing, told by one or more phrases, how like the best of them is to the text.

    It is 0 where the weights are absent: they come with the model (``progprompt models fetch``),
    and nobody waits for them in mid-plan.
    """
    embedder = sentence_embedder(fetch=False)
    try:
        (words,) = embedder.embed([text])
        return [float((embedder.embed(phrases) @ words).max()) for phrases in things]
    except ModelUnavailable:
        return [0.0] * len(things)
