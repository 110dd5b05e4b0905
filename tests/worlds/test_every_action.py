import pytest

from app.domain.condition import Relation
from app.worlds.actions.tabletop import actions

NAMES = ("strawberry", "box")


@pytest.mark.parametrize("name", list(actions))
def test_an_action_is_registered_under_the_name_of_its_signature(name):
    signature = actions[name].signature
    assert signature.name == name
    assert signature.parameters
    assert signature.meaning.endswith(".")


@pytest.mark.parametrize("name", list(actions))
def test_the_perfect_executor_can_do_it(name, tabletop, scene_of, carry_out):
    world = tabletop.open_perfect(scene_of(strawberry=(0.5, 0.2), box=(0.5, -0.2)), 0)
    before = world.facts()
    carry_out(world, *NAMES[: len(actions[name].signature.parameters)], action=name)
    assert world.facts() != before


@pytest.mark.physics
@pytest.mark.parametrize("name", list(actions))
def test_in_physics_it_has_the_effects_it_says_it_has(name, tabletop, scene_of, carry_out):
    scene = scene_of(strawberry=(0.5, 0.2), box=(0.5, -0.2), apple=(0.6, 0.0))
    arguments = NAMES[: len(actions[name].signature.parameters)]
    physical, perfect = tabletop.open(scene, 0), tabletop.open_perfect(scene, 0)
    assert physical.facts() == perfect.facts()
    for world in (physical, perfect):
        carry_out(world, *arguments, action=name)
        world.settle()
    assert physical.facts() == perfect.facts()
    assert physical.holds(Relation("in", NAMES))
