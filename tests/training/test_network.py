import pytest

torch = pytest.importorskip("torch")
pytest.importorskip("transformers")


def test_examples_padded_to_one_length_cost_the_same_as_each_alone() -> None:
    from transformers import Qwen2Config, Qwen2ForCausalLM  # pyright: ignore[reportMissingImports]  # noqa: PLC0415

    from app.training.network import LoraLinear, LoraShape, Network  # noqa: PLC0415

    torch.manual_seed(0)
    sizes = {"hidden_size": 16, "intermediate_size": 32, "num_hidden_layers": 2}
    heads = {"num_attention_heads": 2, "num_key_value_heads": 1, "vocab_size": 20}
    network = object.__new__(Network)
    network.device = "cpu"
    network.tokenizer = type("Ends", (), {"convert_tokens_to_ids": lambda self, token: 0})()
    network.model = Qwen2ForCausalLM(Qwen2Config(**sizes, **heads)).eval()
    pairs = [([1, 2, 3, 4], [5, 6]), ([1, 7], [8, 9, 10])]
    with torch.no_grad():
        together, count = network.loss(pairs)
        alone = [network.loss([pair])[0].item() for pair in pairs]
    assert count == 5
    assert together.item() == pytest.approx(sum(alone), rel=1e-4)
    untouched = LoraLinear(torch.nn.Linear(4, 3), LoraShape(rank=2))
    x = torch.randn(5, 4)
    assert torch.equal(untouched(x), untouched.frozen(x))


def test_rare_tokens_of_the_batch_compete_with_the_frequent_ones() -> None:
    from app.training import network as module  # noqa: PLC0415

    network = object.__new__(module.Network)
    head = torch.nn.Linear(4, module.FREQUENT + 9, bias=False)
    network.model = type("Model", (), {"lm_head": head})()
    ids = torch.tensor([[1, module.FREQUENT + 7, module.FREQUENT + 2]])
    targets = torch.tensor([1, module.FREQUENT + 7])
    hidden = torch.randn(2, 4)
    with torch.no_grad():
        logits, places = network._contest(hidden, ids, targets)
        assert logits.shape == (2, module.FREQUENT + 2)
        wanted = head(hidden).gather(1, targets[:, None])
        assert torch.allclose(logits.gather(1, places[:, None]), wanted, atol=1e-6)
