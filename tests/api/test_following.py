import pytest

from app.api.submission import following
from app.domain.scene import Scene


def test_a_plan_that_follows_is_offered_what_taking_back_needs():
    assert following(Scene(world="tabletop")).actions == ("grab_and_putin", "place_at")


@pytest.mark.parametrize(
    "scene", [Scene(world="tabletop", actions=("stack",)), Scene(world="household")]
)
def test_actions_that_a_scene_names_are_all_there_are(scene):
    assert following(scene) == scene
