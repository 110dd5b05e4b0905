import itertools
import re

from app.programs.sketches.parser import parse_sketch
from app.training.sentences import sentences


def test_every_line_is_a_sketch():
    assert len(sentences()) > 200
    for each in sentences():
        lines = (f"    put({step.given['x']}, {step.given['y']})\n" for step in each.steps)
        assert parse_sketch("".join(lines)).body, each.text


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
    (told,) = (each for each in sentences() if each.text.startswith("The sun is blinding me"))
    assert told.about(lambda: "gizmo") == told
