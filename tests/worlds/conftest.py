import pytest

from app.domain.scene import Scene, SceneObject
from app.worlds import worlds


@pytest.fixture(scope="session")
def tabletop():
    return worlds["tabletop"]


@pytest.fixture
def scene_of():
    """A scene of objects by name: at a place (x, y), or anywhere where it is None."""

    def build(**places):
        objects = [
            SceneObject(
                name=name.replace("_", " "),
                position=None if place is None else (*place, 0.0),
                yaw=None if place is None else 0.0,
            )
            for name, place in places.items()
        ]
        return Scene(world="tabletop", objects=tuple(objects))

    return build


@pytest.fixture
def carry_out():
    """Performs an action to its end; the stages it went through, in order."""

    def run(world, *arguments, action="grab_and_putin"):
        stages = []
        for stage in world.perform(action, arguments):
            if not stages or stages[-1] != stage:
                stages.append(stage)
        return stages

    return run


@pytest.fixture
def move():
    """Puts an object of a physical world somewhere else, as if somebody had taken it there."""

    def put(world, name, position, quaternion=(1.0, 0.0, 0.0, 0.0)):
        physics = world.physics
        address = physics.bodies[name].qpos_address
        physics.data.qpos[address : address + 3] = position
        physics.data.qpos[address + 3 : address + 7] = quaternion

    return put
