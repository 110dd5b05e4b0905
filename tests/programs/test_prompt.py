from dataclasses import replace
from pathlib import Path

import pytest

from app.domain.action import ActionSignature, Parameter
from app.domain.condition import Relation
from app.domain.instruction import Instruction
from app.domain.planner import PlannerOptions, Task, Turn
from app.domain.scene import Scene, SceneObject
from app.programs.parser import parse_program
from app.programs.prompt import write_cue, write_prompt

GOLDEN = Path(__file__).parent / "golden"
SCENE = Scene(
    world="tabletop",
    objects=tuple(SceneObject(name=name) for name in ("banana", "driver's cup", "box")),
)
EARLIER = """\
def put_the_cup_away():
    objects = ['banana', 'driver\\'s cup', 'box']
    grab_and_putin('driver\\'s cup', 'box')
"""
FAILED = """\
def put_the_banana_in_the_box():
    # 1: put the banana in the box
    grab_and_putin('banana', 'box')
"""


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
        ("global.txt", {"objects": "global", "examples": 2}),
        ("properties.txt", {"objects": "properties", "examples": 2}),
        ("no_cue.txt", {"cue": False, "examples": 2}),
        ("random.txt", {"choice": "random", "seed": 5, "examples": 2}),
    ],
)
def test_the_prompt_is_the_golden_text(task, file, options):
    assert write_prompt(task(**options)) == (GOLDEN / file).read_text(encoding="utf-8")


def test_what_came_before_and_what_failed_stand_above_the_cue(task):
    went_wrong = "grab_and_putin('banana', 'box')\n failed in grasp: it slipped"
    asked = replace(
        task(examples=0),
        history=(
            Turn(instruction="put the cup away", program=EARLIER),
            Turn(instruction="and 'that'", program="no program at all", outcome="declined"),
        ),
        failed=Turn(instruction="put the banana in the box", program=FAILED, outcome=went_wrong),
    )
    assert write_prompt(asked) == (GOLDEN / "dialogue.txt").read_text(encoding="utf-8")
    assert parse_program(write_cue(asked) + "    pass\n").name == "finish_put_the_banana_in_the_box"


def test_nothing_that_was_said_before_breaks_out_of_its_comment(task):
    said = "stop\nimport os\x00\u2028\ud800" + "so " * 1000
    asked = replace(task(), history=(Turn(instruction=said, program="", outcome=said),))
    told = write_prompt(asked).removeprefix(write_prompt(task()).removesuffix(write_cue(task())))
    lines = told.removesuffix(write_cue(asked)).splitlines()
    assert [line[:2] for line in lines] == ["# ", "# ", ""]
    assert max(map(len, lines)) < 700
    assert all(line.isprintable() for line in lines)


def test_a_household_lists_its_objects_once_and_those_of_a_new_one_below(task):
    asked = task(examples=2, objects="global")
    first, second = (line for line in write_prompt(asked).split("\n") if "objects = " in line)
    assert "'hammer'" in first
    assert second == "objects = ['banana', 'driver\\'s cup', 'box']"
    here = tuple(
        SceneObject(name=name)
        for name in (
            "hammer",
            "spoon",
            "mug",
            "sponge",
            "jar",
            "book",
            "lemon",
            "drill",
            "key",
            "cup",
        )
    )
    at_home = replace(asked, scene=Scene(world="tabletop", objects=here))
    assert write_prompt(at_home).count("objects = ") == 1
    assert "objects" not in write_cue(at_home)


def test_properties_affordances_states_and_places_are_told(task):
    asked = replace(
        task(objects="properties"),
        scene=Scene(
            world="tabletop",
            objects=(
                SceneObject(name="fridge", container=True, properties=(("material", "steel"),)),
                SceneObject(name="milk", category="food", colour="#ffffff"),
            ),
        ),
        facts=frozenset(
            {
                Relation("closed", ("fridge",)),
                Relation("switched_on", ("fridge",)),
                Relation("in", ("milk", "fridge")),
                Relation("near", ("milk", "fridge")),
            }
        ),
    )
    *_, line = write_cue(asked).splitlines()
    assert line.strip() == (
        "objects = {'fridge': {'container': True, 'material': 'steel', "
        "'state': ['closed', 'switched_on']}, "
        "'milk': {'category': 'food', 'colour': 'white', 'in': 'fridge'}}"
    )


def test_examples_are_drawn_by_the_seed_or_by_their_likeness(task):
    def chosen(ranking=None, **options):
        prompt = write_prompt(task(examples=3, **options), ranking)
        return [line for line in prompt.split("\n") if line.startswith("def ")][:-1]

    drawn = [chosen(choice="random", seed=seed) for seed in range(6)]
    assert drawn[0] == chosen(choice="random", seed=0)
    assert len({tuple(each) for each in drawn}) > 3

    def longest_first(sentence, texts):
        assert sentence == "put the banana in the box"
        return sorted(range(len(texts)), key=lambda place: -len(texts[place]))

    lengths = [len(each) for each in chosen(longest_first, choice="similar")]
    assert lengths == sorted(lengths), "the one most like the sentence stands next to it"
    with pytest.raises(ValueError, match="ranking"):
        chosen(choice="similar")


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
