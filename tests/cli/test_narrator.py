import io

import pytest
from rich.console import Console

from app.cli.narrator import Narrator


@pytest.fixture
def told():
    text = io.StringIO()
    console = Console(file=text, width=100, color_system=None)
    return Narrator(console), text.getvalue


def test_the_program_appears_as_it_is_written_and_only_once(told):
    narrator, text = told
    narrator.tell({"kind": "completion_grew", "text": "    grab_and_putin('a', "})
    narrator.tell({"kind": "completion_grew", "text": "'b')\n"})
    narrator.plan_ready({"program": "def f():\n    grab_and_putin('a', 'b')\n"})
    assert text().count("grab_and_putin('a', 'b')") == 1


def test_a_program_nobody_saw_being_written_is_shown(told):
    narrator, text = told
    narrator.plan_ready({"program": "def f():\n    pass\n"})
    assert "def f():" in text()


def test_a_failed_step_says_stage_and_reason(told):
    narrator, text = told
    failed = {"kind": "action_failed", "line": 3, "stage": "grasp", "reason": "no grasp [found]"}
    narrator.tell({**failed, "time": 2.5})
    assert "2.5 s    failed grasp: no grasp [found]" in text()


def test_scores_come_in_the_papers_order(told):
    narrator, text = told
    scores = {"exec": 1.0, "gcr": 0.5, "precision": None, "sr": 0.0}
    plan = {"status": "failed", "plan_scores": {"sr": 1.0}}
    narrator.execution_over(plan, {"scores": scores})
    assert "failed  SR 0  GCR 0.5  Exec 1  precision -  Plan SR 1" in text()
