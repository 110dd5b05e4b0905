import mujoco
import pytest

from app.api.rollouts import StoredRollout
from app.view.source import NoMotion, model_of
from app.worlds import worlds
from tests.conftest import PerfectTabletop

PROGRAM = "def f():\n    grab_and_putin('banana', 'bowl')\n"


class Painted(PerfectTabletop):
    """A world of a file of its own, which says what is drawn of it."""

    name = "painted"

    def __init__(self, canvas):
        super().__init__(worlds["tabletop"])
        self.moves = True
        self.model = lambda scene: canvas


@pytest.fixture
def executed_in(client, request_body):
    """The id of an execution in this world."""

    def execute(world):
        scene = request_body["scene"] | {"world": world}
        plan = client.post("/plans", json={"scene": scene, "program": PROGRAM}).json()
        return plan["executions"][0]

    return execute


def test_a_world_that_is_added_says_itself_what_is_drawn_of_it(parts, executed_in):
    canvas = mujoco.MjModel.from_xml_string("<mujoco/>")
    with worlds.temporarily("painted", Painted(canvas)):
        assert StoredRollout(parts.database, executed_in("painted")).model() is canvas


def test_what_is_no_model_is_not_drawn(parts, executed_in):
    with worlds.temporarily("painted", Painted("a picture")):
        rollout = StoredRollout(parts.database, executed_in("painted"))
        with pytest.raises(TypeError, match="a MuJoCo model is wanted"):
            model_of(rollout)


def test_of_a_world_that_does_not_move_nothing_is_drawn(parts, executed_in):
    with pytest.raises(NoMotion):
        StoredRollout(parts.database, executed_in("perfect"))
