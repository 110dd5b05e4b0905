from pathlib import Path

import pytest

from app.domain.action import ActionSignature, Parameter
from app.domain.instruction import Instruction
from app.domain.planner import PlannerOptions, Task
from app.domain.scene import Scene, SceneObject
from app.programs.parser import parse_program
from app.programs.prompt import write_cue, write_prompt

GOLDEN = Path(__file__).parent / "golden"
SCENE = Scene(
    world="tabletop",
    objects=tuple(SceneObject(name=name) for name in ("banana", "driver's cup", "box")),
)


@pytest.fixture
def task(grab_and_putin):
    def make(sentence="put the banana in the box", actions=None, **options):
        return Task(
            scene=SCENE,
            actions=actions or (grab_and_putin,),
            instruction=Instruction(sentence),
            options=PlannerOptions(**options),
        )

    return make


@pytest.mark.parametrize(
    ("file", "options"),
    [
        ("comments.txt", {}),
        ("comments_feedback.txt", {"feedback": True}),
        ("feedback.txt", {"comments": False, "feedback": True}),
        ("neither.txt", {"comments": False}),
        ("no_examples.txt", {"examples": 0}),
        ("all_examples.txt", {"examples": 99}),
    ],
)
def test_the_prompt_is_the_golden_text(task, file, options):
    assert write_prompt(task(**options)) == (GOLDEN / file).read_text(encoding="utf-8")


def test_an_ablation_leaves_no_trace_of_what_it_drops(task):
    assert "#" not in write_prompt(task(comments=False))
    assert "assert" not in write_prompt(task(feedback=False))
    assert "else" not in write_prompt(task(feedback=False))


def test_examples_of_actions_not_on_offer_are_left_out(task):
    push = ActionSignature(name="push", parameters=(Parameter(name="obj"),), meaning="Pushes it.")
    prompt = write_prompt(task(actions=(push,)))
    assert prompt.startswith("from actions import push(obj)\n")
    assert prompt.count("def ") == 1


@pytest.mark.parametrize(
    "sentence", ["把梨放在盘子上", "pon el plátano", "put " + "it in the box and " * 20 + "stop"]
)
def test_a_sentence_the_function_s_name_cannot_hold_stands_below_it(task, sentence):
    assert repr(Instruction(sentence).text) in write_cue(task(sentence))


def test_the_cue_begins_a_program_whatever_the_sentence_says(task):
    cue = write_cue(task('it\'s \\ """ 塩 done'))
    program = parse_program(cue + "    pass\n")
    assert program.objects == SCENE.names
