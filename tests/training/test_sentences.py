import itertools
import re

from app.programs.sketches.grammar import vocabulary
from app.programs.sketches.parser import parse_sketch
from app.training.sentences import Sentence, sentences

_SAID = re.compile(r"(?:where=|order=|same\()'[^']+'|'((?:[^'\\]|\\.)+)'")


def _lines(sentence: Sentence) -> str:
    return "".join(f"    put({', '.join(step.given.values())})\n" for step in sentence.steps)


def test_every_line_is_a_sketch():
    assert len(sentences()) > 2000
    for each in sentences():
        assert parse_sketch(_lines(each)).body, each.text


def test_no_line_has_a_word_that_the_grammar_would_not_let_through():
    for each in sentences():
        known = set(vocabulary(each.text, ()))
        said = " ".join(_SAID.findall(_lines(each))).replace("\\'", "'")
        assert set(said.split()) <= known, each.text


def test_other_things_stand_in_the_sentence_and_in_the_sketch_alike():
    made = (f"gizmo {number}" for number in itertools.count())
    changed = [(each, each.about(lambda: next(made))) for each in sentences()]
    others = [(each, other) for each, other in changed if other != each]
    assert len(others) > 60
    for each, other in others:
        assert len(other.steps) == len(each.steps)
        shown = "".join(value for step in other.steps for value in step.given.values())
        named = re.findall(r"'(gizmo \d+s?)'", shown)
        assert named, other.text
        assert all(name in other.text for name in named), other.text


def test_what_is_said_in_other_words_stays_as_it_is():
    (told,) = (each for each in sentences() if each.text.startswith("The sun is blinding me. What"))
    assert told.about(lambda: "gizmo") == told
