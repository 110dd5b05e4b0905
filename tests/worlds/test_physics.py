from dataclasses import dataclass
from itertools import pairwise

import pytest

from app.domain.condition import Relation
from app.domain.errors import ActionFailure

pytestmark = pytest.mark.physics
PLACES = {"banana": (0.5, 0.2), "plate": (0.5, -0.1), "can": (0.35, 0.3)}


@pytest.fixture
def opened(tabletop, scene_of):
    return lambda **places: tabletop.open(scene_of(**(places or PLACES)), 0)


def pick(world, *arguments):
    """Performs one action; the times at which its caller could look in."""
    return [world.time for _ in world.perform("grab_and_putin", arguments)]


@dataclass
class Run:
    """Two picks in a row, with what was saved between them."""

    looked_in: list
    first: tuple
    saved: bytes
    second: tuple
    saved_at_end: bytes
    facts: frozenset
    coordinates: int


_runs = []


@pytest.fixture
def recorded(opened):
    if not _runs:
        world = opened()
        looked_in = pick(world, "banana", "plate")
        first, saved = world.frames(), world.save()
        pick(world, "can", "plate")
        second, nq = world.frames(), world.physics.model.nq
        _runs.append(Run(looked_in, first, saved, second, world.save(), world.facts(), nq))
    return _runs[0]


def test_time_begins_at_zero_with_everything_at_rest(opened):
    world = opened()
    assert world.time == 0.0
    assert world.physics.resting()
    assert world.frames() == ()


def test_the_same_seed_gives_identical_frames_saved_in_between_or_not(opened, recorded):
    world = opened()
    world.save()
    pick(world, "banana", "plate")
    assert world.frames() == recorded.first
    assert world.save() == recorded.saved


def test_a_restored_world_goes_on_bit_for_bit(opened, recorded):
    world = opened()
    world.restore(recorded.saved)
    pick(world, "can", "plate")
    assert world.frames() == recorded.second
    assert world.save() == recorded.saved_at_end
    assert world.facts() == recorded.facts


def test_frames_come_thirty_a_second_with_all_coordinates(recorded):
    frames = recorded.first + recorded.second
    steps = [late.time - early.time for early, late in pairwise(frames)]
    assert max(steps) < 0.036
    assert min(steps) > 0.031
    assert len(frames) == pytest.approx(30 * frames[-1].time, abs=2)
    assert {len(frame.positions) for frame in frames} == {recorded.coordinates}
    assert frames[0].time == 0.0


def test_an_action_lets_its_caller_look_in_every_fifth_of_a_second(recorded):
    assert max(late - early for early, late in pairwise([0.0, *recorded.looked_in])) <= 0.2


def test_frames_not_yet_taken_are_saved_too(opened):
    world, fresh = opened(), opened()
    world.settle()
    fresh.restore(world.save())
    waiting = world.frames()
    assert waiting
    assert fresh.frames() == waiting


def test_a_state_of_another_scene_is_refused(opened):
    state = opened().save()
    other = opened(banana=(0.5, 0.2), bowl=(0.5, -0.1))
    with pytest.raises(ValueError, match="another scene"):
        other.restore(state)


def test_an_action_closed_in_the_middle_leaves_a_world_that_can_go_on(opened):
    world = opened()
    motion = world.perform("grab_and_putin", ("banana", "plate"))
    for stage in motion:
        if stage.name == "carry":
            break
    motion.close()
    for _ in world.perform("home", ()):
        pass
    pick(world, "can", "plate")
    assert world.holds(Relation("in", ("can", "plate")))


def test_an_unknown_object_fails_the_action(opened):
    with pytest.raises(ActionFailure, match="no moon"):
        pick(opened(), "moon", "plate")
