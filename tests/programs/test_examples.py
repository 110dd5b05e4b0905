import pytest

from app.domain.planner import PlannerOptions
from app.domain.program import Assertion, Comment, Pass
from app.domain.scene import Scene, SceneObject
from app.programs.examples import ablate, choose_examples, load_examples
from app.programs.grounding import ground

EXAMPLES = load_examples("tabletop")
PAPER_TASKS = {
    "put_the_banana_in_the_bowl",
    "put_the_pear_on_the_plate",
    "put_the_banana_on_the_plate_and_the_pear_in_the_bowl",
    "sort_the_fruits_on_the_plate_and_the_bottles_in_the_box",
}


def test_there_are_at_least_five_and_none_is_a_task_of_the_paper():
    names = {example.name for example in EXAMPLES}
    assert len(names) == len(EXAMPLES) >= 5
    assert not names & PAPER_TASKS


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.name)
def test_every_example_is_whole_and_grounds_in_its_own_objects(example, grab_and_putin):
    assert example.objects
    scene = Scene(
        world="tabletop", objects=tuple(SceneObject(name=name) for name in example.objects)
    )
    plan = ground(example, scene, [grab_and_putin], {"in": 2, "on": 2})
    assert not plan.rejected
    kinds = {type(statement) for statement in example.body}
    assert Comment in kinds
    assert Assertion in kinds or Pass in kinds
    recoveries = [each.recovery for each in example.body if isinstance(each, Assertion)]
    assert all(recoveries)


def test_a_world_without_examples_has_none():
    assert load_examples("nowhere") == ()


def test_so_many_examples_are_chosen_as_are_asked_for(grab_and_putin):
    for count in (0, 1, 3, 5):
        assert (
            choose_examples("tabletop", [grab_and_putin], PlannerOptions(examples=count))
            == EXAMPLES[:count]
        )


def test_an_ablated_example_keeps_its_calls():
    (example, *_) = EXAMPLES
    bare = ablate(example, comments=False, feedback=False)
    assert [type(each).__name__ for each in bare.body] == ["ActionCall"]
