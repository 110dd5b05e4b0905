import json

import pytest

from app.domain.errors import CompletionFailed, ModelUnavailable
from app.domain.llm import CompletionRequest
from app.llm.backends.scripted import Answer, ScriptedModel, read_script

PROMPT = "def sort_the_fruits():\n    pass\n\ndef put_the_lime_in_the_box():\n"


def ask(model, prompt=PROMPT, on_text=None, **how):
    return model.complete(CompletionRequest(prompt=prompt, **how), on_text)


def test_first_answer_that_fits_the_last_function_is_given():
    script = [Answer(when="sort the fruits", text="no"), Answer(when="Put the lime!", text="yes")]
    assert ask(ScriptedModel(script)).text == "yes"


def test_sentence_in_a_docstring_fits_as_well():
    prompt = 'def task():\n    """Put the lime in the box"""\n'
    assert ask(ScriptedModel([Answer(when="lime in the", text="yes")]), prompt).text == "yes"


def test_answer_without_words_fits_everything():
    assert ask(ScriptedModel([Answer(text="yes")])).text == "yes"


def test_prompt_without_an_answer_is_a_failed_completion():
    with pytest.raises(CompletionFailed, match="no answer"):
        ask(ScriptedModel([Answer(when="wash the car")]))


def test_function_of_the_prompt_answers():
    model = ScriptedModel(lambda prompt: Answer(text=prompt[:4] + "é漢\n"))
    assert ask(model).text == "def é漢\n"


@pytest.mark.parametrize("text", ["", "?! garbage \x00", "  a\n\n  b('c')\n", " "])
def test_any_text_comes_through_unchanged_and_in_pieces(text):
    pieces = []
    completion = ask(
        ScriptedModel([Answer(text=text)]), on_text=lambda new: bool(pieces.append(new))
    )
    assert completion.text == "".join(pieces) == text
    assert completion.finish == "stop"


def test_stop_word_ends_the_text_before_it():
    completion = ask(ScriptedModel([Answer(text="a b\ndef c")]), stop=("\ndef", "#"))
    assert (completion.text, completion.finish) == ("a b", "stop")


def test_endless_text_ends_with_the_tokens():
    completion = ask(ScriptedModel([Answer(text="on and", endless=True)]), max_tokens=5)
    assert (completion.text, completion.finish) == ("on andon andon", "length")
    assert completion.completion_tokens == 5


def test_endless_text_ends_when_cancelled():
    pieces = []

    def stop(new):
        pieces.append(new)
        return len(pieces) == 7

    completion = ask(ScriptedModel([Answer(endless=True)]), on_text=stop, max_tokens=10**9)
    assert (completion.text, completion.finish) == (" " * 7, "cancelled")


def test_slow_answer_takes_its_time():
    completion = ask(ScriptedModel([Answer(text="a b c", delay=0.02)]))
    assert 0.06 <= completion.seconds < 1.0


def test_error_comes_after_the_text():
    pieces = []
    with pytest.raises(CompletionFailed, match="burnt out"):
        ask(
            ScriptedModel([Answer(text="a", error="burnt out")]),
            on_text=lambda new: bool(pieces.append(new)),
        )
    assert pieces == ["a"]


def test_script_is_read_from_a_file(tmp_path):
    path = tmp_path / "script.json"
    path.write_text(json.dumps([{"when": "lime", "text": "a", "delay": 1}, {"endless": True}]))
    assert read_script(path) == (Answer(when="lime", text="a", delay=1), Answer(endless=True))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{", "cannot be read"),
        ("{}", "not a list"),
        ('["a"]', "answer 0: an object with some of text, when"),
        ('[{}, {"txt": "a"}]', "answer 1: an object"),
        ('[{"text": 3}]', "answer 0: text is 3"),
        ('[{"endless": "yes"}]', "endless is 'yes'"),
    ],
)
def test_malformed_script_is_refused_with_the_place(tmp_path, text, message):
    path = tmp_path / "script.json"
    path.write_text(text)
    with pytest.raises(ModelUnavailable, match=message):
        read_script(path)


def test_missing_script_is_named(tmp_path):
    with pytest.raises(ModelUnavailable, match=r"gone\.json cannot be read"):
        read_script(tmp_path / "gone.json")
