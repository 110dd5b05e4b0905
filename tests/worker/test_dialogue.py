"""Plans that follow others, plans made anew, and executions that begin where others stood."""

import pytest

from app.api.schemas.plans import ExecutionGiven
from app.api.what_if import changed_execution
from app.domain.errors import TaskDeclined
from app.domain.trace import ExecutionStarted
from app.llm.backends.scripted import Answer, ScriptedModel
from app.planners import planners
from app.planners.progprompt import ProgPrompt
from app.storage import events, executions, plans
from app.storage.handover import execution_of
from app.takeover import state_of
from app.worker.planning import Planning
from app.worker.situation import situation_of

ONE = "    grab_and_putin('banana', 'bowl')\n"
OTHER = "    grab_and_putin('apple', 'bowl')\n"
BURIED = f"    grab_and_putin('bowl', 'apple')\n{ONE}{OTHER}"
"""The bowl stands on the apple, which therefore cannot be taken."""


@pytest.fixture
def work(database, handover, simulation, read_plan):
    """Plan it and carry it out, as often as the queues would; the ids of its executions."""

    def working(plan_id, *bodies):
        left = list(bodies)
        model = ScriptedModel(lambda prompt: Answer(text=left.pop(0)))
        planning = Planning(database, handover, lambda *names: model)
        while (status := read_plan(plan_id).status) in ("queued", "executing"):
            if status == "queued":
                planning(plan_id)
            else:
                simulation(newest(plan_id))
        return of(plan_id)

    def of(plan_id):
        with database.reading() as session:
            return [found for found, _ in executions.of_plan(session, plan_id)]

    def newest(plan_id):
        return of(plan_id)[-1]

    return working


def test_a_plan_that_follows_another_begins_where_that_one_ended(
    database, make_plan, work, read_plan, read_execution
):
    parent = make_plan(instruction="put the banana in the bowl", goal=["in(banana, bowl)"])
    [before] = work(parent, ONE)
    child = make_plan(instruction="now the other one", parent=parent)
    with database.reading() as session:
        situation = situation_of(session, plans.get(session, child))
    assert [str(fact) for fact in situation.task.facts] == ["in(banana, bowl)"]
    [turn] = situation.task.history
    assert (turn.instruction, turn.outcome) == ("put the banana in the bowl", "")
    assert ONE in turn.program
    [execution] = work(child, OTHER)
    assert read_execution(execution).begins_after == before
    assert read_plan(child).status == "succeeded"
    assert read_plan(child).plan_scores["sr"] == 1, "both fruits are in the bowl"


def test_a_plan_whose_parent_was_never_carried_out_begins_with_the_scene(database, make_plan, work):
    parent = make_plan(execute=False)
    work(parent, ONE)
    with database.reading() as session:
        situation = situation_of(session, plans.get(session, make_plan(parent=parent)))
    assert situation.state is None
    assert situation.task.facts == frozenset()
    assert len(situation.task.history) == 1


def test_planner_and_execution_take_over_the_same_of_a_try_that_came_to_nothing(
    database, make_plan, work
):
    parent = make_plan()
    [before] = work(parent, ONE)
    plan_id = make_plan(parent=parent)
    with database.transaction() as session:
        plan = plans.get(session, plan_id)
        lost = execution_of(session, plan)
        lost.status, lost.program = "failed", "def f():\n    pass"
        session.add(lost)
        plan.tries = [{"program": "", "execution": lost.id, "outcome": "its worker died"}]
    with database.reading() as session:
        plan = plans.get(session, plan_id)
        state = situation_of(session, plan).state
        assert lost.begins_after == before
        assert state is not None
        assert state == state_of(session, execution_of(session, plan))


def test_what_is_left_is_planned_anew_after_a_failed_step(
    make_plan, work, read_plan, read_execution
):
    plan_id = make_plan(planner={"model": "scripted", "max_replans": 2}, goal=[])
    first, second = work(plan_id, BURIED, ONE)
    plan = read_plan(plan_id)
    assert (plan.status, plan.replans) == ("succeeded", 1)
    [tried] = plan.tries
    assert tried["execution"] == first
    assert "check: bowl is on apple itself" in tried["outcome"]
    assert BURIED in tried["program"]
    assert plan.program.endswith(ONE)
    assert read_execution(second).begins_after == first
    assert read_execution(second).program == plan.program


def test_a_planner_never_learns_which_goal_conditions_were_missed(
    database, make_plan, work, read_plan
):
    plan_id = make_plan(planner={"model": "scripted", "max_replans": 1}, goal=["in(apple, banana)"])
    assert len(work(plan_id, ONE)) == 1, "nothing failed that could be seen: no second try"
    assert "in(apple, banana)" in read_plan(plan_id).error
    buried = make_plan(planner={"model": "scripted", "max_replans": 1}, goal=["in(apple, banana)"])
    work(buried, BURIED, ONE)
    with database.reading() as session:
        failed = situation_of(session, plans.get(session, buried)).task.failed
    assert failed is not None
    assert "in(apple, banana)" not in failed.outcome


def test_no_more_is_planned_anew_than_was_asked_for(make_plan, work, read_plan):
    plan_id = make_plan(planner={"model": "scripted", "max_replans": 1}, goal=[])
    again = "    grab_and_putin('apple', 'cat')\n"
    assert len(work(plan_id, BURIED, again)) == 2
    assert read_plan(plan_id).status == "failed"


def test_a_what_if_that_fails_does_not_have_the_plan_made_anew(
    database, handover, make_plan, work, simulation, read_plan
):
    plan_id = make_plan(planner={"model": "scripted", "max_replans": 1}, goal=[])
    work(plan_id, ONE)
    with database.transaction() as session:
        plan = plans.get(session, plan_id)
        row = changed_execution(session, plan, ExecutionGiven(seed=1))
        row.scene = row.scene | {"objects": row.scene["objects"][1:]}
        what_if = handover.approved(session, plan, row).id
    simulation(what_if)
    assert (read_plan(plan_id).status, read_plan(plan_id).replans) == ("succeeded", 0)


class Declining:
    """Plans nothing, ever."""

    model = "scripted"
    repairs = False

    def write_program(self, task, model, report):
        raise TaskDeclined(
            "there are two cups",
            kind="ambiguous",
            question="Which cup?",
            choices=("take the red cup", "take the blue cup"),
        )


@pytest.fixture
def declining():
    with planners.temporarily("declining", Declining()):
        yield "declining"


def test_a_declined_task_moves_nothing_and_asks_back(
    database, make_plan, work, read_plan, declining
):
    plan_id = make_plan(planner={"name": declining, "model": "scripted"})
    assert work(plan_id) == []
    plan = read_plan(plan_id)
    assert (plan.status, plan.error) == ("failed", "there are two cups")
    assert plan.declined == {
        "kind": "ambiguous",
        "reason": "there are two cups",
        "question": "Which cup?",
        "choices": ["take the red cup", "take the blue cup"],
    }
    answer = make_plan(instruction="the red one", parent=plan_id)
    with database.reading() as session:
        [turn] = situation_of(session, plans.get(session, answer)).task.history
    assert (turn.program, turn.outcome) == ("", "Which cup?")


def test_an_execution_can_take_over_the_state_before_a_line(
    database, handover, make_plan, work, simulation, read_execution
):
    plan_id = make_plan(goal=[])
    [first] = work(plan_id, f"    # the fruits\n{ONE}{OTHER}")
    line = read_execution(first).program.split("\n").index(OTHER.rstrip()) + 1
    with database.transaction() as session:
        plan = plans.get(session, plan_id)
        assert plan.program is not None
        row = execution_of(session, plan)
        row.begins_after, row.begins_at_line = first, line
        row.program = plan.program.replace("'apple', 'bowl'", "'apple', 'banana'")
        handover.approved(session, plan, row)
    simulation(row.id)
    execution = read_execution(row.id)
    assert {"in(banana, bowl)", "on(apple, banana)"} <= set(execution.final_state)
    with database.reading() as session:
        started = events.all_of(session, row.id)[0]
    assert isinstance(started, ExecutionStarted)
    assert [str(fact) for fact in started.facts] == ["in(banana, bowl)"]


def test_the_models_hear_of_the_failed_try(database, make_plan, work):
    prompts = []

    class Hearing(ProgPrompt):
        def write_program(self, task, model, report):
            prompts.append(task.failed)
            return super().write_program(task, model, report)

    planner = {"name": "hearing", "model": "scripted", "max_replans": 1}
    with planners.temporarily("hearing", Hearing()):
        work(make_plan(planner=planner, goal=[]), BURIED, ONE)
    assert prompts[0] is None
    assert "apple" in prompts[1].outcome
