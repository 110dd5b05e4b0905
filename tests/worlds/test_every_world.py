import mujoco
import pytest

from app.domain.scene import Scene, SceneObject
from app.worlds import worlds


@pytest.mark.parametrize("name", list(worlds))
def test_a_world_describes_itself(name):
    world = worlds[name]
    assert world.name == name
    assert world.actions
    assert {"in", "on"} <= set(world.relations)
    kinds = [kind.name for kind in world.catalogue()]
    assert len(kinds) == len(set(kinds)) > 0


@pytest.mark.parametrize("name", list(worlds))
def test_the_perfect_executor_starts_from_the_same_completed_scene(name):
    world = worlds[name]
    scene = Scene(world=name, objects=tuple(SceneObject(name=n) for n in ("apple", "bowl")))
    completed = world.complete(scene, 3)
    assert world.open_perfect(scene, 3).scene == completed
    assert world.complete(completed, 4) == completed


@pytest.mark.physics
@pytest.mark.parametrize("name", [name for name, world in worlds.items() if world.moves])
def test_frames_fit_the_model_that_is_drawn(name):
    scene = Scene(world=name, objects=tuple(SceneObject(name=n) for n in ("apple", "bowl")))
    world = worlds[name].open(scene, 3)
    world.settle()
    drawn = mujoco.MjData(worlds[name].model(world.scene))
    assert len(world.frames()[0].positions) == len(drawn.qpos)
