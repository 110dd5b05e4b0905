import json

import mujoco
import numpy as np
import pytest

from app.domain.scene import Scene
from app.worlds.household import Household
from app.worlds.simulators.household_model import HomeModel

CARRY = "find magazine; grab magazine; find desk; putback magazine desk"


@pytest.fixture
def filmed(household):
    def opened(environment="env0"):
        return household.open(Scene(world="household", environment=environment), 0)

    return opened


def place_of(world, model, frame, name):
    """Of the body that shows the first thing of this name, in the model's frame [m]."""
    data = mujoco.MjData(model)
    data.qpos[:] = frame.positions
    mujoco.mj_kinematics(model, data)
    return data.body(f"{name} {world.graph.named(name)[0].id}").xpos.copy()


@pytest.mark.parametrize("environment", ["env0", "env1", "env2"])
def test_frames_fit_the_model_and_begin_as_the_home_stands(environment, filmed):
    world = filmed(environment)
    (first,) = world.frames()
    model = Household().model(world.scene)
    assert len(first.positions) == model.nq
    assert first.time == 0.0


def test_a_home_without_boxes_is_laid_out(home, small_home):
    model = Household().model(home.scene)
    assert model.nq == len(home.frames()[0].positions)
    layout = HomeModel(home.graph).layout
    cup, table = (layout.solids[home.graph.named(name)[0].id] for name in ("cup", "table"))
    assert cup.bottom == pytest.approx(table.top)
    assert len(small_home["nodes"]) - 2 == len(layout.things)


def test_what_is_put_on_something_ends_on_it(filmed, do):
    world = filmed()
    do(world, CARRY)
    frames = world.frames()
    model = Household().model(world.scene)
    home = HomeModel(world.graph)
    desk = home.layout.solids[world.graph.named("desk")[0].id]
    before, after = (place_of(world, model, frames[k], "magazine") for k in (0, -1))
    assert np.linalg.norm(after - before) > 0.1
    top = home.in_view((desk.centre[0], desk.centre[1], desk.top))
    assert after[2] == pytest.approx(top[2], abs=0.02)
    assert np.abs(after[:2] - top[:2]).max() < max(desk.size[:2]) / 2 * home.scale


def test_what_is_held_moves_with_the_agent(filmed, do):
    world = filmed()
    do(world, "find magazine; grab magazine")
    model = Household().model(world.scene)
    first = world.frames()[-1]
    do(world, "walk kitchen")
    frames = world.frames()
    for frame in frames[::7]:
        gap = place_of(world, model, frame, "magazine") - _agent(model, frame)
        assert np.linalg.norm(gap[:2]) < 0.12
    assert np.linalg.norm(_agent(model, frames[-1]) - _agent(model, first)) > 0.2


def test_what_is_in_something_carried_is_carried_with_it(filmed, do):
    world = filmed("env2")
    model = Household().model(world.scene)
    do(world, "find apple; grab bowl; find washingmachine; putback bowl washingmachine")
    frames = world.frames()
    first, last = (
        place_of(world, model, frame, "apple") - place_of(world, model, frame, "bowl")
        for frame in (frames[0], frames[-1])
    )
    assert np.allclose(first, last)


def _agent(model, frame):
    data = mujoco.MjData(model)
    data.qpos[:] = frame.positions
    mujoco.mj_kinematics(model, data)
    return data.body("character").xpos.copy()


def test_nothing_jumps_but_goes_its_way_in_many_frames(filmed, do):
    world = filmed()
    do(world, CARRY)
    rows = np.array([frame.positions for frame in world.frames()])
    assert np.abs(np.diff(rows[:, :3], axis=0)).max() < 0.03  # in a doll's house of 1.35 m
    assert world.time == pytest.approx((len(rows) - 1) / 10, abs=0.1)


def test_doors_turn_and_lamps_rise(filmed, do):
    world = filmed()
    home = HomeModel(world.graph)
    fridge, lamp = world.graph.named("fridge")[0].id, world.graph.named("floorlamp")[0].id
    world.frames()
    do(world, "find fridge; open fridge; find floorlamp; switchon floorlamp")
    last = world.frames()[-1].positions
    assert last[home.door_address[fridge]] > 1.0
    assert last[home.lamp_address[lamp]] > 0.05


def test_who_sits_is_on_the_seat(filmed, do):
    world = filmed()
    do(world, "find sofa; sit sofa")
    model = Household().model(world.scene)
    home = HomeModel(world.graph)
    sofa = home.layout.solids[world.graph.named("sofa")[0].id]
    there = home.in_view(sofa.centre)
    assert np.abs(_agent(model, world.frames()[-1])[:2] - there[:2]).max() < 0.01


def test_a_restored_film_goes_on_frame_by_frame(filmed, do):
    world, twin = filmed(), filmed()
    do(world, "find magazine; grab magazine")
    world.frames()
    twin.restore(world.save())
    for each in (world, twin):
        do(each, "find desk; putback magazine desk")
    assert twin.time == world.time
    assert twin.frames() == world.frames()
    assert twin.save() == world.save()


def test_a_film_catches_up_with_a_state_that_has_none(household, filmed, do):
    perfect, world = household.open_perfect(Scene(world="household"), 0), filmed()
    do(perfect, CARRY)
    world.restore(perfect.save())
    model = Household().model(world.scene)
    (frame,) = world.frames()
    home = HomeModel(world.graph)
    desk = home.layout.solids[world.graph.named("desk")[0].id]
    gap = place_of(world, model, frame, "magazine") - home.in_view(desk.centre)
    assert np.abs(gap[:2]).max() < max(desk.size[:2]) / 2 * home.scale


def test_a_new_rollout_begins_at_zero(filmed, do):
    world = filmed()
    do(world, "find magazine")
    world.begin()
    assert world.time == 0.0
    assert [frame.time for frame in world.frames()] == [0.0]


def test_the_perfect_executor_has_no_film(household, do):
    world = household.open_perfect(Scene(world="household"), 0)
    do(world, CARRY)
    assert (world.time, world.frames()) == (0.0, ())
    filmed = household.open(Scene(world="household"), 0)
    do(filmed, "find magazine; grab magazine")
    twin = household.open_perfect(Scene(world="household"), 0, filmed.save())
    assert twin.facts() == filmed.facts()
    assert json.loads(twin.save())[-1] is None
