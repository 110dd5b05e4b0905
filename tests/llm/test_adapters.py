import hashlib
import json

import pytest

from app.domain.errors import ModelUnavailable
from app.llm.adapters import SHIPPED, adapters_in, check
from app.llm.models import LlmConfig, catalogue, find_model, open_model

BASE = "1d9614638d18024d0fbb36575a15f1302a3adf044df10345688ec4f6e1c4ff32"


@pytest.fixture
def config(tmp_path):
    """Settings with an adapter for the small model in the cache."""
    folder = tmp_path / "adapters"
    folder.mkdir()
    (folder / "mine.gguf").write_bytes(b"matrices")
    digest = hashlib.sha256(b"matrices").hexdigest()
    card = {"name": "mine", "base_sha256": BASE, "adapter_sha256": digest, "figures": {}}
    (folder / "mine.json").write_text(json.dumps(card))
    return LlmConfig(cache_dir=tmp_path, fetch=False)


def test_adapter_in_the_cache_is_a_model_beside_its_base(config):
    mine, base = find_model("mine", config), find_model("small", config)
    assert mine.weights == base.weights
    assert (mine.backend, base.adapter) == ("local", None)
    assert mine.adapter
    assert mine.adapter.path.read_bytes() == b"matrices"


def test_adapter_is_taken_only_as_its_card_describes_it(config):
    adapter = find_model("mine", config).adapter
    assert adapter
    check(adapter, BASE)
    with pytest.raises(ModelUnavailable, match="trained for weights with sha256 1d96"):
        check(adapter, "f" * 64)
    adapter.path.write_bytes(b"Matrices")
    with pytest.raises(ModelUnavailable, match="is not the one of its adapter"):
        check(adapter, BASE)
    adapter.path.unlink()
    with pytest.raises(ModelUnavailable, match="cannot be read"):
        check(adapter, BASE)


def test_drafts_are_taken_only_as_the_card_describes_them(config, tmp_path):
    """The library ends the process over a file that it cannot read."""
    card = tmp_path / "adapters" / "mine.json"
    told = json.loads(card.read_text()) | {"drafts_sha256": hashlib.sha256(b"words").hexdigest()}
    card.write_text(json.dumps(told))
    adapter = find_model("mine", config).adapter
    assert adapter
    assert adapter.drafts
    with pytest.raises(ModelUnavailable, match=r"mine\.drafts cannot be read"):
        check(adapter, BASE)
    adapter.drafts.write_bytes(b"words")
    check(adapter, BASE)
    adapter.drafts.write_bytes(b"other words")
    with pytest.raises(ModelUnavailable, match=r"mine\.drafts is not the one of its adapter"):
        check(adapter, BASE)


def test_adapter_of_another_base_is_refused_when_opened(config, tmp_path):
    card = tmp_path / "adapters" / "mine.json"
    card.write_text(json.dumps(json.loads(card.read_text()) | {"base_sha256": "f" * 64}))
    with pytest.raises(ModelUnavailable, match="trained for weights with sha256 ffff"):
        open_model("mine", config)


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"name": "x"}'])
def test_what_is_no_card_is_left_out_with_a_warning(config, tmp_path, caplog, text):
    (tmp_path / "adapters" / "bad.json").write_text(text)
    assert [adapter.name for adapter in adapters_in(tmp_path / "adapters")] == ["mine"]
    assert "bad.json is no adapter's card" in caplog.text


def test_adapter_never_takes_the_name_of_a_built_in_model(config, tmp_path):
    card = tmp_path / "adapters" / "mine.json"
    card.write_text(json.dumps(json.loads(card.read_text()) | {"name": "default"}))
    assert find_model("default", config).name == "situated"


def test_every_shipped_adapter_is_the_one_of_its_card_and_fits_its_base():
    for adapter in adapters_in(SHIPPED):
        spec = find_model(adapter.name, LlmConfig())
        assert spec.weights
        check(adapter, spec.weights.sha256)
    assert len({spec.name for spec in catalogue(LlmConfig())}) == len(catalogue(LlmConfig()))
