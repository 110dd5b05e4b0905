import pytest

torch = pytest.importorskip("torch")
pytest.importorskip("transformers")


def test_branches_see_the_prefix_and_themselves_but_not_one_another() -> None:
    from app.training.network import _packed  # noqa: PLC0415

    ids, positions, mask, wanted = _packed([1, 2], [([3], [4, 5]), ([6], [7])])
    assert ids.tolist() == [[1, 2, 3, 4, 5, 6, 7]]
    assert positions.tolist() == [[0, 1, 2, 3, 4, 2, 3]]
    seen = (mask[0, 0] == 0).int().tolist()
    assert seen[4] == [1, 1, 1, 1, 1, 0, 0]
    assert seen[6] == [1, 1, 0, 0, 0, 1, 1]
    assert wanted == [(2, 4), (3, 5), (5, 7)]


def test_packed_branches_cost_the_same_as_each_alone() -> None:
    from transformers import Qwen2Config, Qwen2ForCausalLM  # pyright: ignore[reportMissingImports]  # noqa: PLC0415

    from app.training.network import LoraLinear, LoraShape, Network  # noqa: PLC0415

    torch.manual_seed(0)
    sizes = {"hidden_size": 16, "intermediate_size": 32, "num_hidden_layers": 2}
    heads = {"num_attention_heads": 2, "num_key_value_heads": 1, "vocab_size": 20}
    network = object.__new__(Network)
    network.model = Qwen2ForCausalLM(Qwen2Config(**sizes, **heads)).eval()
    branches = [([3, 4], [5, 6]), ([7], [8, 9, 10])]
    with torch.no_grad():
        together, count = network.loss([1, 2], branches)
        alone = [network.loss([1, 2], [branch])[0].item() for branch in branches]
    assert count == 5
    assert together.item() == pytest.approx(sum(alone), rel=1e-4)
    untouched = LoraLinear(torch.nn.Linear(4, 3), LoraShape(rank=2))
    x = torch.randn(5, 4)
    assert torch.equal(untouched(x), untouched.frozen(x))
