"""The household's own planner, with the sketch a model would write."""

import pytest

from app.domain.condition import decide
from app.domain.errors import CompletionFailed, TaskDeclined
from app.domain.goal import Goal
from app.domain.instruction import Instruction
from app.domain.planner import PlannerOptions, Task
from app.domain.scene import Scene
from app.domain.trace import ActionFailed, CallSkipped
from app.planners import planners
from app.programs.conditions import parse_condition
from app.rollout import carry_out, collect, offered, plan_task
from app.worlds import worlds

HOME = worlds["household"]
PLANNER = planners["activities"]


def _task(sentence, environment="env0"):
    scene = HOME.complete(Scene(world="household", environment=environment), 0)
    return Task(
        scene=scene,
        actions=offered(HOME, scene),
        instruction=Instruction(sentence),
        options=PlannerOptions(name="activities", feedback=True),
        facts=HOME.open_perfect(scene, 0).facts(),
    )


def _planned(task, model):
    open_home = lambda: HOME.open_perfect(task.scene, 0)  # noqa: E731
    return plan_task(task, PLANNER, model, open_home, lambda _: False)


@pytest.mark.parametrize(
    ("sentence", "sketch", "environment", "goal"),
    [
        ("put the apple in the fridge", "put('apple', 'fridge')", "env0", ["in(apple, fridge)", "closed(fridge)"]),
        ("throw the orange away", "throw_away('orange')", "env1", ["in(orange, garbagecan)"]),
        ("bring me the remote", "bring_me('remote')", "env0", ["held(remotecontrol)"]),
        ("wash the mug", "wash('mug')", "env0", ["in(mug, sink)", "washed(mug)", "in(dishsoap, sink)"]),
        ("heat the soup", "heat('soup')", "env1", ["heated(soup)", "held(soup)"]),
        ("put all the cutlery in the sink", "put(all('cutlery'), 'sink')", "env0", ["in(fork, sink)", "in(knife, sink)", "in(spoon, sink)"]),
        ("eat the cookies on the couch", "eat_on('cookies', 'couch')", "env1", ["on(character, sofa)"]),
        ("refrigerate the salmon", "refrigerate('salmon')", "env0", ["in(salmon, fridge)"]),
    ],
)  # fmt: skip
def test_what_is_asked_for_is_so_in_the_end(sentence, sketch, environment, goal, canned):
    planned = _planned(_task(sentence, environment), canned(f"    {sketch}\n\n"))
    world = HOME.open_perfect(_task(sentence, environment).scene, 0)
    events = []
    carry_out(planned.plan, Goal(()), world, collect(events))
    assert not [each for each in events if isinstance(each, ActionFailed | CallSkipped)]
    unmet = [each for each in goal if not decide(parse_condition(each), world.holds)]
    assert unmet == [], planned.text


@pytest.mark.parametrize("sketch", ["put('elephant', 'fridge')", "bring_me('dragon')"])
def test_what_is_not_there_is_declined_with_a_question(sketch, canned):
    with pytest.raises(TaskDeclined) as declined:
        _planned(_task("put it in the fridge for me"), canned(f"    {sketch}\n\n"))
    assert declined.value.kind == "absent"
    assert declined.value.question


def test_a_model_that_writes_nothing_fails(canned):
    with pytest.raises(CompletionFailed):
        _planned(_task("put the apple in the fridge"), canned(""))


def test_a_world_without_activities_is_declined(task, canned):
    with pytest.raises(TaskDeclined, match="has no activities"):
        PLANNER.write_program(
            task(name="activities"), canned("    put('a', 'b')\n\n"), lambda _: False
        )
