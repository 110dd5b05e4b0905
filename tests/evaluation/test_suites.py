import json

import pytest

from app.domain.errors import Refused, UnknownName
from app.evaluation.linter import lint
from app.evaluation.suites import find_suite, read_suite, suites


@pytest.mark.parametrize("name", suites())
def test_every_shipped_task_is_reached_by_its_ground_truth_and_changes_nothing_else(name, try_it):
    for task in find_suite(name).tasks:
        result = try_it(task, *(task.truth or ("pass",)))
        assert result.plan.strict, (task.name, result.plan, result.reason)
        assert not result.plan.problems, task.name
        assert result.mistakes == ()


@pytest.mark.parametrize("name", suites())
def test_the_linter_finds_nothing_in_a_shipped_suite(name):
    assert lint(find_suite(name).tasks) == []


def test_the_tabletop_suite_is_large_varied_and_speaks_several_languages():
    tasks = find_suite("tabletop").tasks
    assert len(tasks) >= 120
    assert len({task.category for task in tasks}) >= 12
    assert {code for task in tasks for code in task.variants} >= {"de", "fr", "es", "it"}
    assert sum(not task.goal for task in tasks) >= 10
    test = sum(task.split == "test" for task in tasks)
    assert 0.4 < test / len(tasks) < 0.6


def test_a_tasks_half_depends_on_nothing_but_its_name(make_task):
    assert make_task(name="pear on the tray").split == make_task(name="pear on the tray").split
    assert make_task(name="pear on the tray").split == "test"
    assert make_task(name="banana in the bowl").split == "train"


def test_the_papers_robot_tasks_come_with_every_number_of_distractors():
    tasks = find_suite("robot-tasks").tasks
    assert len(tasks) == 20
    assert {len(task.distractors) for task in tasks} == {0, 1, 2, 3, 4}
    assert all(set(task.distractors) <= set(task.scene.names) for task in tasks)


def test_a_generated_scene_has_other_things_in_it_and_the_same_ones_every_time(tmp_path):
    entry = {
        "name": "banana",
        "category": "generated",
        "objects": ["banana", "bowl"],
        "instruction": "put the banana in the bowl",
        "goal": ["in(banana, bowl)"],
        "truth": ["grab_and_putin('banana', 'bowl')"],
        "generator": {"distractors": 3, "seed": 5},
    }
    file = tmp_path / "own.jsonl"
    file.write_text(json.dumps(entry) + "\n")
    first, again = read_suite(file).tasks[0], read_suite(file).tasks[0]
    assert first == again
    assert len(first.distractors) == 3
    assert len(set(first.scene.names)) == 5


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("nonsense", "cannot be read"),
        ('{"name": "a"}', "it needs name, scene"),
        ('{"name": "a", "category": "b", "instruction": "c", "gaol": []}', "unknown fields gaol"),
        (
            '{"name": "a", "category": "b", "instruction": "c", "goal": ["in(a"]}',
            "lacks a",
        ),
    ],
)
def test_a_file_that_is_no_suite_is_refused_with_the_place_and_the_reason(tmp_path, text, words):
    file = tmp_path / "own.jsonl"
    file.write_text(text + "\n")
    with pytest.raises(Refused, match=words):
        read_suite(file)


def test_two_tasks_of_one_name_are_refused(tmp_path):
    line = json.dumps({"name": "a", "category": "b", "instruction": "c", "objects": ["cup"]})
    file = tmp_path / "own.jsonl"
    file.write_text(f"{line}\n{line}\n")
    with pytest.raises(Refused, match="a name is a task's key"):
        read_suite(file)


def test_an_unknown_suite_is_refused_with_the_names_of_those_there_are():
    with pytest.raises(UnknownName, match="tabletop"):
        find_suite("../tabletop")


@pytest.mark.parametrize(
    ("values", "code"),
    [
        ({"goal": ("in(banana, basin)",)}, "refused"),
        ({"goal": ("not in(banana, bowl)",), "truth": ()}, "already true"),
        ({"goal": ("near(banana, bowl)",)}, "proximity only"),
        ({"goal": ("held(banana)",)}, "not reached"),
        ({"goal": ("closed(bowl)",), "truth": ()}, "unreachable"),
        ({"goal": ()}, "no goal"),
    ],
)
def test_the_linter_tells_what_is_wrong_with_a_goal(make_task, values, code):
    assert code in [finding.code for finding in lint([make_task(**values)])]


def test_tasks_are_chosen_by_split_category_name_and_number():
    suite = find_suite("tabletop")
    assert {task.split for task in suite.chosen(split="test").tasks} == {"test"}
    assert {task.category for task in suite.chosen(categories=["size"]).tasks} == {"size"}
    assert len(suite.chosen(names=["typo"]).tasks) == 1
    assert len({task.category for task in suite.chosen(limit=20).tasks}) > 8


def test_a_language_a_task_does_not_have_is_refused(make_task):
    assert make_task().spoken("de").startswith("Leg")
    with pytest.raises(Refused, match="it has en, de"):
        make_task().spoken("ja")
