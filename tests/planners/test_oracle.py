from dataclasses import replace

import pytest

from app.domain.errors import TaskDeclined
from app.domain.instruction import Instruction
from app.domain.scene import Scene, SceneObject
from app.llm.backends.scripted import ScriptedModel
from app.planners.oracle import Oracle


def written(task, sentence, *names):
    scene = Scene(world="tabletop", objects=tuple(SceneObject(name=name) for name in names))
    given = replace(task(name="oracle"), instruction=Instruction(sentence), scene=scene)
    return Oracle().write_program(given, ScriptedModel([]), lambda _: False).program


def test_program_of_the_suite_is_found_by_its_sentence_whatever_else_lies_there(task):
    text = written(task, "Put the pear on the plate.", "drill", "plate", "pear")
    assert "grab_and_putin('pear', 'plate')" in text


def test_example_program_is_found_by_its_name(task):
    names = ("hammer", "spoon", "mug", "sponge", "jar")
    assert "grab_and_putin('spoon', 'mug')" in written(task, "put the spoon in the mug", *names)


def test_sentence_nobody_wrote_a_program_for_is_declined(task):
    with pytest.raises(TaskDeclined, match="no program is written") as caught:
        written(task, "whistle a tune", "pear")
    assert caught.value.kind == "unsure"


def test_program_for_other_objects_is_no_program_for_these(task):
    with pytest.raises(TaskDeclined, match="what is not here: pear, plate") as caught:
        written(task, "put the pear on the plate", "fork")
    assert caught.value.kind == "absent"


def test_nothing_is_done_where_the_suite_says_so(task):
    text = written(task, "put the pear on the plate", "banana", "plate", "apple")
    assert text.splitlines()[1:] == ["    pass"]
