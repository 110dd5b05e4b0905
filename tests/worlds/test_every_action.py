"""One test after another over every verb there is: a new file is tested at once."""

import pytest

from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.domain.perception import Perception
from app.domain.scene import Scene, SceneObject
from app.worlds.actions.tabletop import actions

PLACES = {
    "block": (0.35, 0.25), "apple": (0.5, -0.02), "box": (0.5, -0.30), "book": (0.60, 0.20),
    "can": (0.40, 0.48),
}  # fmt: skip
CASES = {
    "close": (("hinged box",), ["closed(hinged box)"]),
    "grab_and_putin": (("block", "box"), ["in(block, box)"]),
    "handover": (("block",), ["handed_over(block)"]),
    "home": ((), ["upright(block)"]),
    "open": (("drawer",), ["open(drawer)"]),
    "pick": (("block",), ["held(block)"]),
    "place_at": (("block", 0.42, 0.12), ["right_of(block, can)"]),
    "place_behind": (("block", "apple"), ["behind(block, apple)", "near(apple, block)"]),
    "place_in": (("block", "box"), ["in(block, box)"]),
    "place_in_front_of": (
        ("block", "apple"),
        ["in_front_of(block, apple)", "behind(apple, block)"],
    ),
    "place_left_of": (("block", "apple"), ["left_of(block, apple)", "near(block, apple)"]),
    "place_on": (("block", "book"), ["on(block, book)"]),
    "place_right_of": (("block", "apple"), ["right_of(block, apple)", "left_of(apple, block)"]),
    "pour": (("cup", "bowl"), ["poured(cup, bowl)", "upright(cup)"]),
    "push": (("can", "right"), ["upright(can)"]),
    "stack": (("block", "book"), ["on(block, book)"]),
    "upright": (("can",), ["upright(can)"]),
    "wipe": (("plate", "sponge"), ["wiped(plate)", "upright(plate)"]),
}
"""What each is called with, and what of the relations must hold afterwards."""
BEFORE = {"home": [("pick", ("block",))]}


@pytest.fixture
def scene():
    objects = [
        SceneObject(name=name, position=(*place, 0.0), yaw=0.3) for name, place in PLACES.items()
    ]
    return Scene(world="tabletop", objects=tuple(objects), actions=tuple(actions))


@pytest.fixture
def furnished():
    objects = (
        SceneObject(name="drawer", position=(0.52, -0.2, 0.0), yaw=-0.37),
        SceneObject(
            name="hinged box", position=(0.5, 0.25, 0.0), yaw=0.46, properties=(("state", "open"),)
        ),
    )
    return Scene(world="tabletop", objects=objects, actions=tuple(actions))


def facts_of(texts):
    parts = [text[:-1].split("(") for text in texts]
    return [Relation(name, tuple(rest.split(", "))) for name, rest in parts]


@pytest.fixture
def laid():
    objects = (
        SceneObject(
            name="cup", position=(0.45, 0.25, 0.0), yaw=0.3, properties=(("contents", "beads"),)
        ),
        SceneObject(name="bowl", position=(0.5, -0.1, 0.0), yaw=0.0),
    )
    return Scene(world="tabletop", objects=objects, actions=tuple(actions))


@pytest.fixture
def dusty():
    objects = (
        SceneObject(name="sponge", position=(0.45, 0.25, 0.0), yaw=0.3),
        SceneObject(name="plate", position=(0.5, -0.1, 0.0), yaw=0.0),
    )
    return Scene(world="tabletop", objects=objects, actions=tuple(actions))


@pytest.fixture
def prepared(scene, furnished, laid, dusty, carry_out):
    """A world of a kind as it must be before a verb's call."""

    def prepare(name, open_world):
        scenes = {"open": furnished, "close": furnished, "pour": laid, "wipe": dusty}
        world = open_world(scenes.get(name, scene))
        for action, arguments in BEFORE.get(name, []):
            carry_out(world, *arguments, action=action)
        return world

    return prepare


@pytest.mark.parametrize("name", list(actions))
def test_an_action_is_registered_under_the_name_of_its_signature(name):
    signature = actions[name].signature
    assert signature.name == name
    assert signature.meaning.endswith(".")
    for parameter in signature.parameters:
        assert bool(parameter.words) == (parameter.role == "word")


@pytest.mark.parametrize("name", list(actions))
def test_the_perfect_executor_makes_it_true(name, tabletop, prepared, carry_out):
    arguments, wanted = CASES[name]
    world = prepared(name, lambda scene: tabletop.open_perfect(scene, 0))
    carry_out(world, *arguments, action=name)
    for relation in facts_of(wanted):
        assert world.holds(relation), relation
    if name != "pick":
        assert not any(fact.name == "held" for fact in world.facts())


@pytest.mark.physics
@pytest.mark.parametrize("name", list(actions))
def test_in_physics_it_has_the_effects_it_says_it_has(name, tabletop, prepared, carry_out, move):
    arguments, wanted = CASES[name]
    sight = Perception(source="privileged")
    physical = prepared(name, lambda scene: tabletop.open(scene, 0, sight))
    perfect = prepared(name, lambda scene: tabletop.open_perfect(scene, 0))
    assert physical.facts() == perfect.facts()
    if name == "upright":
        move(physical, "can", (0.40, 0.48, 0.04), (0.5**0.5, 0.0, 0.5**0.5, 0.0))
        physical.settle()
        assert not physical.holds(Relation("upright", ("can",)))
    before = physical.place("can") if name == "push" else None
    for world in (physical, perfect):
        carry_out(world, *arguments, action=name)
        if name != "pick":
            world.settle()
    assert physical.facts() == perfect.facts()
    for relation in facts_of(wanted):
        assert physical.holds(relation), relation
    if before:
        assert 0.05 < before[1] - physical.place("can")[1] < 0.15
    if name == "place_at":
        assert physical.place("block") == pytest.approx((0.42, 0.12), abs=0.02)


@pytest.mark.physics
@pytest.mark.parametrize(
    ("name", "arguments", "reason"),
    [
        ("place_left_of", ("apple", "apple"), "itself"),
        ("place_in", ("apple", "book"), "no container"),
        ("place_on", ("apple", "box"), "put into box, not on it"),
        ("place_at", ("apple", 0.9, 0.9), "out of reach"),
        ("push", ("apple", "sideways"), "there is left, right, forward, back"),
        ("open", ("apple",), "no drawer, door or lid"),
        ("wipe", ("apple", "block"), "no level top"),
        ("wipe", ("book", "box"), "nothing to wipe with"),
    ],
)
def test_what_cannot_be_is_refused_alike_in_the_facts_and_in_physics(
    tabletop, scene, carry_out, name, arguments, reason
):
    sight = Perception(source="privileged")
    for world in (tabletop.open(scene, 0, sight), tabletop.open_perfect(scene, 0)):
        with pytest.raises(ActionFailure, match=reason):
            carry_out(world, *arguments, action=name)
        assert world.time == 0.0
