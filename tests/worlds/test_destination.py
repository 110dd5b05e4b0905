import numpy as np
import pytest

from app.worlds.simulators.mujoco.destination import Destination
from app.worlds.simulators.mujoco.picking import TURNS
from app.worlds.simulators.mujoco.scene_builder import build
from app.worlds.simulators.mujoco.workcell import Workcell

pytestmark = pytest.mark.physics


@pytest.fixture
def landings(tabletop, scene_of):
    """Where an object may be put into a bowl, and how high the bowl's rim is [m]."""

    def find(name):
        scene = tabletop.complete(scene_of(**{name: (0.4, 0.2)}, bowl=(0.5, -0.2)), 1)
        cell = Workcell.over(build(scene, visuals=False))
        clouds = cell.look_at(name, "bowl")
        body = cell.physics.bodies["bowl"]
        room = Destination(cell.outlines, body, clouds, moved=name)
        points, middle = cell.collisions.shape(name)
        return room.landings(points, middle[:2], TURNS), room.rim

    return find


def test_what_is_too_long_to_lie_in_a_bowl_leans_with_one_end_inside(landings):
    found, rim = landings("cucumber")
    lying = min(each.spot.height for each in found if each.sunk == 0)
    assert lying > rim - 0.01
    assert found[0].spot.height < rim - 0.02
    up = found[0].lean[2, 2]
    assert 0.8 < up < 0.99


def test_what_has_room_lies_as_it_is(landings):
    found, _ = landings("strawberry")
    assert all(np.array_equal(each.lean, np.eye(3)) for each in found)
