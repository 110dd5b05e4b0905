import threading
import time

import pytest

from app.storage import events, executions, plans
from app.storage.handover import execution_of
from app.worlds import worlds
from app.worlds.simulators.symbolic import SymbolicWorld


class Killed(BaseException):
    """The process dies; nobody may catch this."""


@pytest.fixture
def dying(monkeypatch):
    """The next so many turns of an action kill the process, beginning with the given one."""

    def arrange(turn, times=1):
        perform = SymbolicWorld.perform
        left = {"turns": turn, "deaths": times}

        def performing(self, action, arguments):
            left["turns"] -= 1
            if left["turns"] < 0 and left["deaths"]:
                left["deaths"] -= 1
                raise Killed
            return perform(self, action, arguments)

        monkeypatch.setattr(SymbolicWorld, "perform", performing)

    return arrange


def told(database, execution_id):
    with database.reading() as session:
        return events.all_of(session, execution_id)


def test_a_plan_carried_out_to_its_goal_succeeds_with_scores_and_final_state(
    make_execution, simulation, read_execution, read_plan
):
    execution_id = make_execution()
    simulation(execution_id)
    execution = read_execution(execution_id)
    assert execution.status == "succeeded"
    assert execution.scores == {"sr": 1, "gcr": 1, "exec": 1, "precision": 1}
    assert "in(banana, bowl)" in execution.final_state
    assert read_plan(execution.plan_id).status == "succeeded"


def test_a_goal_not_reached_is_told_by_name(make_execution, simulation, read_execution, read_plan):
    execution_id = make_execution(goal=["in(banana, bowl)", "in(bowl, banana)"])
    simulation(execution_id)
    execution = read_execution(execution_id)
    assert (execution.status, execution.scores["gcr"]) == ("failed", 0.5)
    assert "not reached: in(bowl, banana)" in execution.error
    assert read_plan(execution.plan_id).error == execution.error


def test_without_a_goal_every_step_has_to_be_performed(make_execution, simulation, read_execution):
    good = make_execution(goal=[])
    program = "def f():\n    grab_and_putin('banana', 'bowl')\n    grab_and_putin('cat', 'bowl')\n"
    bad = make_execution(goal=[], program=program)
    simulation(good)
    simulation(bad)
    assert read_execution(good).status == "succeeded"
    execution = read_execution(bad)
    assert (execution.status, execution.failure["line"]) == ("failed", 3)
    assert execution.failure["stage"] == "grounding"


@pytest.mark.parametrize("turn", [0, 1])
def test_a_run_taken_up_after_a_death_tells_the_same_story_once(
    database, make_execution, simulation, read_execution, dying, turn
):
    whole, broken = make_execution(), make_execution()
    simulation(whole)
    dying(turn)
    with pytest.raises(Killed):
        simulation(broken)
    assert read_execution(broken).next_step == 2 * turn
    simulation(broken)
    assert read_execution(broken).status == "succeeded"
    assert told(database, broken) == told(database, whole)


def test_an_execution_that_kills_its_worker_three_times_at_a_step_is_given_up(
    make_execution, simulation, read_execution, read_plan, dying
):
    execution_id = make_execution()
    dying(1, times=99)
    for _ in range(3):
        with pytest.raises(Killed):
            simulation(execution_id)
    simulation(execution_id)
    execution = read_execution(execution_id)
    assert execution.status == "failed"
    assert "died 3 times" in execution.error
    assert read_plan(execution.plan_id).status == "failed"


def test_an_error_in_the_world_ends_as_a_failed_execution_with_the_reason(
    make_execution, simulation, read_execution, monkeypatch
):
    def broken(*_):
        raise MemoryError("no room for this scene")

    monkeypatch.setattr(worlds["perfect"], "open", broken)
    execution_id = make_execution()
    simulation(execution_id)
    assert read_execution(execution_id).error == "unexpected MemoryError: no room for this scene"


def test_an_execution_cancelled_under_way_keeps_what_happened_until_then(
    database, make_execution, simulation, read_execution, read_plan, monkeypatch
):
    execution_id = make_execution()
    perform = SymbolicWorld.perform

    def performing(self, action, arguments):
        with database.transaction() as session:
            executions.get(session, execution_id).cancel_requested = True
        return perform(self, action, arguments)

    monkeypatch.setattr(SymbolicWorld, "perform", performing)
    simulation(execution_id)
    execution = read_execution(execution_id)
    assert (execution.status, execution.error) == ("cancelled", None)
    assert [event.kind for event in told(database, execution_id)][-1] == "action_performed"
    assert read_plan(execution.plan_id).status == "cancelled"


def test_a_plan_waits_for_the_last_of_its_executions(
    database, handover, make_execution, simulation, read_execution, read_plan
):
    first = make_execution()
    plan_id = read_execution(first).plan_id
    with database.transaction() as session:
        plan = plans.get(session, plan_id)
        second = handover.approved(session, plan, execution_of(session, plan)).id
    simulation(first)
    assert read_plan(plan_id).status == "executing"
    simulation(second)
    assert read_plan(plan_id).status == "succeeded"


def test_a_plan_cancelled_in_the_moment_its_execution_ends_is_not_in_its_way(
    database, make_execution, simulation, read_execution, read_plan
):
    execution_id = make_execution()
    plan_id = read_execution(execution_id).plan_id
    with database.transaction() as session:
        plans.get(session, plan_id, lock=True)
        ending = threading.Thread(target=simulation, args=[execution_id])
        ending.start()
        time.sleep(1)  # By now it waits for the plan, or on SQLite for its first transaction.
        executions.request_cancel(session, plan_id)
    ending.join()
    execution = read_execution(execution_id)
    assert execution.status in ("succeeded", "cancelled")
    assert read_plan(plan_id).status == execution.status
