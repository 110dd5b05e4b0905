import json

import pytest

from app.domain.errors import Refused
from app.evaluation.household_data import PARTS, plain_name, read_household
from app.evaluation.metrics import Figure
from app.evaluation.paper import Plan, methods, paper_charts, paper_tables, units
from app.evaluation.printed import MAIN, PLACES, TASKS, Printed
from app.evaluation.runs import evaluate_units
from app.evaluation.tables import markdown
from app.llm.backends.scripted import Answer, ScriptedModel

HOME = {
    "agent_room": 2,
    "nodes": [
        [1, "character", "Characters", [], []],
        [2, "kitchen", "Rooms", [], []],
        [3, "table", "Furniture", ["SURFACES"], []],
        [4, "apple", "Food", ["GRABBABLE"], []],
        [5, "fridge", "Appliances", ["CAN_OPEN", "CONTAINERS"], ["CLOSED"]],
    ],
    "edges": [[3, "INSIDE", 2], [4, "INSIDE", 2], [5, "INSIDE", 2], [4, "ON", 3]],
}
TASK = {
    "task": "put apple in the fridge",
    "actions": [
        "[find] <apple> (4)",
        "[grab] <apple> (4)",
        "[find] <fridge> (5)",
        "[open] <fridge> (5)",
        "[putin] <apple> (4) <fridge> (5)",
    ],
    "agent_close": [3],
    "goal_relations": ["apple INSIDE fridge", "character CLOSE fridge"],
    "goal_states": ["fridge OPEN"],
    "core_goals": ["apple INSIDE fridge"],
}


@pytest.fixture
def data(tmp_path):
    """A folder laid out like the paper's data, with one small task in each home."""
    for place, part in PARTS["test"].items():
        (tmp_path / f"env{place}.json").write_text(json.dumps(HOME))
        (tmp_path / part).write_text(json.dumps([TASK]))
    return tmp_path


def test_tasks_are_read_with_their_start_goal_and_ground_truth(data):
    suite = read_household(data)
    assert [task.name for task in suite.tasks] == [
        f"env{place}: put apple in the fridge" for place in (0, 1, 2)
    ]
    task = suite.tasks[1]
    assert task.environment == "env1"
    assert plain_name(task.name) == "put apple in the fridge"
    assert task.goal == ("in(apple, fridge)", "close(character, fridge)", "open(fridge)")
    assert task.core_goal == ("in(apple, fridge)",)
    assert task.truth[-1] == "putin('apple', 'fridge')"
    assert task.steps == 5


def test_the_ground_truth_of_such_a_task_reaches_its_goal(data, try_it):
    task = read_household(data).tasks[0]
    result = try_it(task, *task.truth)
    assert result.plan.success
    assert result.plan.scores["exec"] == 1
    stopped = try_it(task, *task.truth[:-1])
    assert stopped.plan.scores["gcr"] == pytest.approx(2 / 3)
    assert stopped.plan.scores["core_gcr"] == 0


def test_a_folder_without_the_tasks_is_refused(tmp_path):
    with pytest.raises(Refused, match="does not hold the paper's tasks"):
        read_household(tmp_path)


def test_the_printed_figures_agree_with_one_another():
    mean = sum(sr.mean for sr, _, _ in TASKS.values()) / len(TASKS)
    assert mean == pytest.approx(MAIN["ProgPrompt"][0].mean)
    places = [PLACES[place][0].mean for place in ("env0", "env1", "env2")]
    assert sum(places) / 3 == pytest.approx(PLACES["average"][0].mean, abs=0.01)
    assert str(Printed(0.4, 0.11)) == ".40 ± .11"
    assert str(Printed(1)) == "1"


def test_the_tasks_to_train_on_are_a_suite_of_their_own(data):
    [file] = PARTS["train"].values()
    (data / file).write_text(json.dumps([TASK, TASK]))
    suite = read_household(data, "train")
    assert (suite.name, len(suite.tasks)) == ("paper-household-train", 1)


def test_the_papers_own_rows_know_no_affordances_and_ours_do(data):
    rows = methods(Plan(household=read_household(data)))
    assert [row.name for row in rows if row.options.affordances] == [
        *("ProgPrompt, affordances", "ProgPrompt, repair and replanning"),
        *("activities, unconstrained", "activities, no repair", "best of ours"),
    ]


def test_the_first_row_is_run_first_and_the_sweep_last(data):
    plan = Plan(household=read_household(data), models=("scripted",))
    made = units(plan)
    assert made[0].cell.name == "ProgPrompt"
    assert made[-1].cell.name == "ProgPrompt, 7 examples"
    names = [cell.name for cell in methods(plan)]
    assert names[:7] == [
        *("ProgPrompt", "ProgPrompt, no feedback", "ProgPrompt, no comments"),
        *("ProgPrompt, neither", "LangPrompt", "Huang et al.", "SayCan"),
    ]
    assert len(set(names)) == len(names)


class Script:
    """The right program for the fridge, whoever asks."""

    def __call__(self):
        return self.open

    def open(self, _name, _preferred):
        body = "".join(f"    {call}\n" for call in (
            "find('apple')", "grab('apple')", "find('fridge')", "open('fridge')",
            "putin('apple', 'fridge')",
        ))  # fmt: skip
        return ScriptedModel([Answer(text=body)])


def test_the_papers_tables_hold_our_figures_beside_the_printed_ones(data, tmp_path):
    plan = Plan(household=read_household(data), models=("scripted",))
    chosen = [
        unit for unit in units(plan) if unit.cell.name.startswith("ProgPrompt") and not unit.physics
    ]
    results = evaluate_units(chosen, Script(), tmp_path / "out")
    found = {table.name: table for table in paper_tables(plan, results)}
    assert set(found) == {"main", "by-task", "places", "sweep"}
    main = found["main"]
    row = dict(zip(main.columns, main.rows[0], strict=True))
    assert isinstance(row["SR"], Figure)
    assert (row["SR"].mean, row["SR, paper"]) == (1, MAIN["ProgPrompt"][0])
    assert [entry[0] for entry in found["places"].rows] == ["env0", "env1", "env2", "average"]
    assert len(found["sweep"].rows) == 7
    assert "1 | .34 ± .08" in markdown([main])
    [(title, svg)] = paper_charts(plan, results)
    assert "example" in title
    assert svg.count("<circle") >= 21


def test_own_tasks_stand_beside_no_printed_figures(data, tmp_path):
    plan = Plan(household=read_household(data), models=("scripted",), own=True)
    results = evaluate_units(units(plan)[:1], Script(), tmp_path / "out")
    [main, *_] = paper_tables(plan, results)
    assert not any(isinstance(entry, Printed) for row in main.rows for entry in row)
