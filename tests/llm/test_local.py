import time
from dataclasses import replace

import pytest

from app.domain.errors import CompletionFailed, ModelUnavailable
from app.domain.llm import CompletionRequest
from app.llm.backends.local import LocalModel
from app.llm.models import LlmConfig, open_model

pytestmark = [pytest.mark.model, pytest.mark.timeout(1800)]

PREFIX = "".join(
    f"def put_{fruit}_in_bowl():\n    grab_and_putin('{fruit}', 'bowl')\n\n"
    for fruit in ("apple", "banana", "cherry", "lemon", "lime", "orange")
)


def test_it_goes_on_as_the_examples_do(small_model):
    prompt = PREFIX + "def put_pear_in_bowl():\n"
    completion = small_model.complete(CompletionRequest(prompt=prompt, stop=("\ndef",)))
    assert completion.text.strip() == "grab_and_putin('pear', 'bowl')"
    assert completion.finish == "stop"
    assert completion.prompt_tokens > 100


def test_grammar_binds_it(small_model):
    grammar = 'root ::= "grab(\'" ("driver\\\\\'s cup" | "é漢🍌") "\')\\n"'
    asked = CompletionRequest(prompt="def f():\n", grammar=grammar, max_tokens=40)
    texts = {small_model.complete(replace(asked, seed=seed)).text for seed in (0, 1)}
    assert texts <= {"grab('driver\\'s cup')\n", "grab('é漢🍌')\n"}


def test_grammar_that_cannot_be_read_fails_the_completion(small_model, capfd):
    with pytest.raises(CompletionFailed, match="failed to parse grammar"):
        small_model.complete(CompletionRequest(prompt="a", grammar="root ::= ("))


def test_prompt_longer_than_the_context_says_so(small_model):
    with pytest.raises(CompletionFailed, match=r"prompt has \d+ tokens and .* takes 8192"):
        small_model.complete(CompletionRequest(prompt="a b " * 9000))


def test_it_stops_within_half_a_second(small_model):
    asked_at = []

    def stop(text):
        if text:
            asked_at.append(time.perf_counter())
        return len(asked_at) >= 3

    asked = CompletionRequest(prompt="one, two, three", max_tokens=500)
    completion = small_model.complete(asked, stop)
    assert time.perf_counter() - asked_at[-1] < 0.5
    assert completion.finish == "cancelled"
    assert small_model.complete(replace(asked, max_tokens=2)).completion_tokens == 2


def test_what_the_watcher_raises_comes_out(small_model):
    def raise_it(text):
        raise LookupError("from the watcher")

    with pytest.raises(LookupError, match="from the watcher"):
        small_model.complete(CompletionRequest(prompt="one, two"), raise_it)


def cpu_seconds(model, request):
    began = time.process_time()
    text = model.complete(request).text
    return time.process_time() - began, text


def test_state_after_a_prefix_spares_reading_it_also_after_a_restart(small_model, small_config):
    prefix = "# Six fruits and a bowl.\n" + PREFIX
    asked = CompletionRequest(prompt=prefix + "def put_pear_in_bowl():\n", max_tokens=8)
    other = CompletionRequest(prompt="something else", max_tokens=1)
    cold, text = cpu_seconds(small_model, asked)
    small_model.complete(other)
    assert not small_model.warm(prefix)
    small_model.complete(other)
    brought_back, same = cpu_seconds(small_model, asked)
    assert brought_back < 0.6 * cold
    assert same == text

    restarted = open_model("small", small_config)
    assert isinstance(restarted, LocalModel)
    assert restarted.warm(prefix)
    warm, warm_text = cpu_seconds(restarted, asked)
    restarted.close()
    assert warm < 0.6 * cold
    assert warm_text == text


def test_damaged_state_is_dropped_and_made_again(small_model, small_config):
    before = set((small_config.cache / "slots").iterdir())
    assert not small_model.warm("one, two, three")
    (state,) = set((small_config.cache / "slots").iterdir()) - before
    state.write_bytes(b"damaged")
    assert not small_model.warm("one, two, three")
    assert small_model.warm("one, two, three")


def test_file_that_is_no_model_cannot_be_loaded(tmp_path):
    path = tmp_path / "bad.gguf"
    path.write_bytes(b"no model")
    with pytest.raises(ModelUnavailable, match=r"bad\.gguf could not be loaded"):
        LocalModel(path, "bad", LlmConfig(cache_dir=tmp_path), "bad")


def test_candidates_are_scored_as_their_tokens_are_likely(small_model):
    prompt = PREFIX + "def put_pear_in_bowl():\n    grab_and_putin('"
    fruits = ["pear', 'bowl')", "lime', 'bowl')", "pear', 'box')", "bowl', 'pear')"]
    scores = small_model.score(prompt, fruits)
    assert max(scores) == scores[0]
    assert -1.0 < scores[0] < 0.0
    assert all(score < -2.0 for score in scores[1:])
    assert small_model.score(prompt, ["pear"]) == (0.0,)
    assert small_model.score(prompt, []) == ()


def test_score_agrees_with_the_text_it_writes(small_model):
    asked = CompletionRequest(prompt="one, two, three,", max_tokens=1, logprob=True)
    written = small_model.complete(asked)
    score, _ = small_model.score("one, two, three,", [written.text, " nine"])
    assert score == pytest.approx(written.logprob, abs=0.1)


def test_many_candidates_are_scored_in_seconds(small_model):
    calls = [
        f"put('{a}', '{b}')"
        for a in ("cup", "red mug", "lime", "coke can", "sponge", "pear")
        for b in ("bowl", "box", "bin", "tray")
    ]
    prompt = PREFIX + "def put_lime_in_box():\n    "
    began = time.process_time()
    scores = small_model.score(prompt, calls)
    assert time.process_time() - began < 12
    assert calls[scores.index(max(scores))] == "put('lime', 'box')"
