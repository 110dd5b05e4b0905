import struct
from dataclasses import replace
from typing import Any

import pytest

from app.domain.llm import Completion, CompletionRequest
from app.llm.backend import Closable, LlmConfig, ModelSpec
from app.llm.backends import backends
from app.llm.drafts import RARE, followers, write_drafts
from app.llm.llama import Stream
from app.llm.models import find_model

PROMPT = """from actions import grab_and_putin(obj1, obj2)
# put the pear on the plate and the spoon in the mug
def task():
"""
SKETCH = """    grab_and_putin('pear', 'plate')
    grab_and_putin('spoon', 'mug')
"""


def test_it_is_told_what_usually_follows_two_tokens():
    pairs = [((9, 1), (2, 3, 4))] * RARE + [((1,), (2, 3, 5))]
    assert followers(pairs)[(2, 3)] == {4: RARE, 5: 1}
    assert followers(pairs)[(9, 1)] == {2: RARE}, "the end of the prompt counts"


def test_what_is_rare_or_undecided_foresees_nothing():
    assert followers([((1,), (2, 3))] * (RARE - 1)) == {}
    undecided = [((1,), (2, token)) for token in (3, 4, 5) for _ in range(RARE)]
    assert (1, 2) not in followers(undecided)


def test_every_two_tokens_have_followers():
    """The library ends the whole process over an entry without any."""
    many = [((1,), (2, 3))] * 20 + [((1,), (2, token)) for token in range(10, 20)]
    table = followers(many)
    assert table == {(1, 2): {3: 20}}


def test_the_file_is_laid_out_as_the_library_reads_it(tmp_path):
    path = tmp_path / "my.drafts"
    write_drafts(path, {(7, 8): {4: 6, 3: 2}})
    assert struct.unpack("<9i", path.read_bytes()) == (7, 8, -1, -1, 2, 3, 2, 4, 6)


@pytest.mark.model
@pytest.mark.timeout(1800)
def test_with_drafts_the_same_is_written_and_most_of_it_was_foreseen(monkeypatch, small_config):
    spec = find_model("situated", small_config)
    assert spec.adapter
    assert spec.adapter.drafts
    plain = replace(spec, adapter=replace(spec.adapter, drafts=None))
    told: list[dict[str, Any]] = []
    take = Stream.__call__

    def noting(stream: Stream, chunk: dict[str, Any]) -> bool:
        told.append(chunk.get("timings", {}))
        return take(stream, chunk)

    monkeypatch.setattr(Stream, "__call__", noting)
    done = [_written(each, small_config) for each in (plain, spec)]
    assert done[0].text == done[1].text == SKETCH.rstrip()
    assert done[0].logprob is not None
    assert done[1].logprob is None, "of all tokens, or of none"
    assert told[-1]["draft_n_accepted"] > done[1].completion_tokens / 3


def _written(spec: ModelSpec, config: LlmConfig) -> Completion:
    model = backends[spec.backend].open(spec, config)
    assert isinstance(model, Closable)
    done = model.complete(CompletionRequest(prompt=PROMPT, stop=("\n\n",), logprob=True))
    model.close()
    return done
