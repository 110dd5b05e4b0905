import pytest

from app.domain.errors import TaskDeclined
from app.domain.planner import PlannerOptions
from app.evaluation.attempt import Unit, attempt
from app.evaluation.results import Cell
from app.llm.backends.scripted import Answer, ScriptedModel
from app.planners import planners

RIGHT = "grab_and_putin('banana', 'bowl')"


def test_a_right_plan_is_right_strictly_too(make_task, try_it):
    result = try_it(make_task(), RIGHT)
    assert (result.plan.success, result.plan.strict, result.mistakes) == (True, True, ())
    assert result.plan.scores["exec"] == 1
    assert result.physics is None


@pytest.mark.parametrize(
    ("calls", "mistakes"),
    [
        (["grab_and_putin('apple', 'bowl')"], ("missing step", "additional step")),
        ([RIGHT, "grab_and_putin('cup', 'bowl')"], ("additional step",)),
        (["grab_and_putin('mango', 'bowl')"], ("hallucinated object", "missing step")),
        (["grab_and_putin('bowl', 'bowl')"], ("affordance", "missing step")),
        (["teleport('banana', 'bowl')"], ("hallucinated action", "missing step")),
        (["pass"], ("wrongly declined",)),
        (["import os"], ("unusable program",)),
    ],
)
def test_the_kind_of_mistake_is_told(make_task, try_it, calls, mistakes):
    result = try_it(make_task(), *calls)
    assert not result.plan.strict
    assert result.mistakes == mistakes


def test_what_was_to_be_left_alone_costs_strictness_and_not_success(make_task, try_it):
    result = try_it(make_task(), RIGHT, "grab_and_putin('cup', 'bowl')")
    assert result.plan.success
    assert result.plan.changed == ("in(cup, bowl)",)


def test_what_may_change_may(make_task, try_it):
    task = make_task(may_change=("cup",))
    assert try_it(task, RIGHT, "grab_and_putin('cup', 'bowl')").plan.strict


def test_the_right_steps_in_the_wrong_order_fail_where_order_matters(make_task, try_it):
    apple = "grab_and_putin('apple', 'bowl')"
    goal = ("in(banana, bowl)", "in(apple, bowl)")
    task = make_task(goal=goal, truth=(RIGHT, apple), order=goal)
    assert try_it(task, RIGHT, apple).plan.strict
    result = try_it(task, apple, RIGHT)
    assert not result.plan.success
    assert result.mistakes == ("wrong order",)
    assert try_it(make_task(goal=goal, truth=(RIGHT, apple)), apple, RIGHT).plan.strict


def test_what_must_always_hold_may_not_be_broken_on_the_way(make_task, try_it):
    calls = ("grab_and_putin('banana', 'cup')", RIGHT)
    assert try_it(make_task(), *calls).plan.success
    task = make_task(always=("not in(banana, cup)",))
    assert "not in(banana, cup)" in try_it(task, *calls).plan.unmet


def test_a_goal_that_must_have_held_for_some_steps_comes_too_late(make_task, try_it):
    apple = "grab_and_putin('apple', 'cup')"
    task = make_task(hold=2, may_change=("apple",))
    assert not try_it(task, apple, RIGHT).plan.success
    assert try_it(task, RIGHT, apple).plan.success


def test_an_impossible_task_is_right_where_nothing_is_changed(make_task, try_it):
    task = make_task(goal=(), truth=(), decline="absent", instruction="put the moon in the bowl")
    assert try_it(task, "pass").plan.strict
    result = try_it(task, RIGHT)
    assert not result.plan.strict
    assert result.mistakes == ("wrongly accepted",)


class Declines:
    """A planner that will do nothing."""

    model = "scripted"
    repairs = False

    def write_program(self, task, model, report):
        raise TaskDeclined("there is no moon", kind="absent")


@pytest.fixture
def declining():
    if "declines" not in planners:
        planners.add("declines", Declines())


@pytest.mark.parametrize("impossible", [True, False])
def test_declining_is_right_exactly_where_the_task_cannot_be_done(make_task, declining, impossible):
    task = make_task(goal=(), truth=(), decline="absent") if impossible else make_task()
    unit = Unit(task=task, cell=Cell(name="d", options=PlannerOptions(name="declines")))
    result = attempt(unit, lambda *_: ScriptedModel([Answer()]))
    assert result.status == "declined"
    assert result.reason == "there is no moon"
    assert result.plan.strict is impossible
    assert result.mistakes == (() if impossible else ("wrongly declined",))


def test_a_failed_step_is_planned_again_from_where_things_stand(make_task, make_cell):
    written = iter(["    grab_and_putin('bananna', 'bowl')\n", f"    {RIGHT}\n"])
    model = ScriptedModel(lambda _prompt: Answer(text=next(written)))
    unit = Unit(task=make_task(), cell=make_cell(max_replans=1))
    result = attempt(unit, lambda *_: model)
    assert result.tries == 2
    assert result.plan.strict
    assert result.plan.scores["exec"] == 0.5


@pytest.mark.physics
def test_physics_is_judged_beside_the_perfect_executor(make_task, try_it):
    result = try_it(make_task(), RIGHT, physics=True)
    assert result.physics is not None
    assert result.physics.success
    assert result.physics.scores["sr"] == 1
