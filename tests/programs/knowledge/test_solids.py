import pytest

from app.programs.knowledge.solids import is_solid


@pytest.mark.parametrize("name", ["brick", "pebble", "golf ball", "dumbbell", "spanner", "banana"])
def test_what_has_no_inside_is_not_opened(name):
    assert is_solid(name)


@pytest.mark.parametrize(
    "name", ["toolbox", "book", "umbrella", "letter", "drawer", "hutch", "scissors", "gizmo"]
)
def test_what_has_one_or_is_not_known_may_be(name):
    assert not is_solid(name)
