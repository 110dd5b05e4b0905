import numpy as np
import pytest

from app.worlds.simulators.mujoco.scene_builder import build
from app.worlds.simulators.mujoco.workcell import Workcell

pytestmark = pytest.mark.physics


@pytest.fixture
def cell(tabletop, scene_of):
    scene = scene_of(red_block=(0.5, 0.2), bowl=(0.5, -0.2), pen=(0.35, 0.0), apple=(0.6, 0.0))
    return Workcell.over(build(tabletop.complete(scene, 1)))


def test_every_object_is_seen_even_a_thin_one(cell):
    assert set(cell.cameras.overview()) == {"red block", "bowl", "pen", "apple"}


def test_the_cloud_of_a_block_lies_on_its_faces(cell):
    cloud = cell.look_at("red block")["red block"]
    size = np.array(cell.physics.bodies["red block"].height)
    assert len(cloud) > 500
    assert cloud.highest[2] == pytest.approx(size, abs=0.002)
    assert np.allclose(np.linalg.norm(cloud.normals, axis=1), 1.0)
    middle = (cloud.lowest + cloud.highest) / 2
    outward = ((cloud.points - middle) * cloud.normals).sum(axis=1)
    assert np.all(outward > 0)


def test_a_look_at_one_object_never_coarsens_another(cell):
    together = cell.look_at("apple", "bowl")
    alone = cell.look_at("apple")
    assert len(together["apple"]) >= len(alone["apple"])


def test_looking_changes_nothing(cell):
    before = cell.physics.save()
    cell.look_at("apple", "bowl")
    assert cell.physics.save() == before
