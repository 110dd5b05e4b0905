from pathlib import Path
from types import SimpleNamespace

import pytest

torch = pytest.importorskip("torch")
transformers = pytest.importorskip("transformers")

VOCABULARY = 50


def tiny_network():  # a Network is not importable without torch
    from app.training.network import PROJECTIONS, LoraLinear, LoraShape, Network  # noqa: PLC0415

    torch.manual_seed(0)
    sizes = {"hidden_size": 32, "intermediate_size": 48, "num_hidden_layers": 1}
    heads = {"num_attention_heads": 2, "num_key_value_heads": 1}
    more = {"vocab_size": VOCABULARY, "initializer_range": 0.3}
    network = object.__new__(Network)
    network.model = transformers.Qwen2ForCausalLM(
        transformers.Qwen2Config(**sizes, **heads, **more)
    ).eval()
    network.model.requires_grad_(False)
    network.tokenizer = Letters()
    network.device = "cpu"
    layer = network.model.model.layers[0]
    network.adapters = {}
    for part in (layer.self_attn, layer.mlp):
        for name in PROJECTIONS:
            if hasattr(part, name):
                adapter = LoraLinear(getattr(part, name), LoraShape(rank=8))
                setattr(part, name, adapter)
                network.adapters[f"0.{name}"] = adapter
    return network


class Letters:
    def __call__(self, text: str, add_special_tokens: bool) -> SimpleNamespace:
        del add_special_tokens  # Unused.
        return SimpleNamespace(input_ids=[ord(letter) % VOCABULARY for letter in text])

    def convert_tokens_to_ids(self, token: str) -> int:
        del token  # Unused.
        return 0


def learn(checkpoint: Path, examples: int, network=None):
    from app.training.training import Schedule, train  # noqa: PLC0415

    network = network or tiny_network()
    schedule = Schedule(examples=examples, rate=0.02, batch=1)
    return network, train(network, schedule, checkpoint, lambda text: None)


def test_learning_lowers_the_loss(tmp_path: Path) -> None:
    _, first = learn(tmp_path / "short.npz", 1)
    _, last = learn(tmp_path / "long.npz", 30)
    assert last.loss < first.loss - 0.3


def test_a_stopped_run_goes_on_where_it_stood(tmp_path: Path) -> None:
    checkpoint = tmp_path / "checkpoint.npz"
    first, _ = learn(checkpoint, 3)
    resumed, progress = learn(checkpoint, 3)
    assert (progress.examples, progress.steps) == (3, 3)
    for name, array in first.arrays().items():
        assert (resumed.arrays()[name] == array).all()
    _, further = learn(checkpoint, 5)
    assert further.steps == 5
    assert further.tokens > progress.tokens
