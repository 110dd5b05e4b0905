import pytest

from app.domain.scene import SceneObject
from app.programs.sketches.denied import denied
from app.programs.sketches.things import read_things

THINGS = read_things(SceneObject(name=name) for name in ("lamp", "red cup", "cat", "box"))


@pytest.mark.parametrize(
    ("said", "names"),
    [
        ("everything in the box, and not the cat obviously", {"cat"}),
        ("everything but the lamp in the box, nor the red cup", {"red cup"}),
        ("not just the lamp, but the cat goes in the box", set()),
        ("not the cat, it hates the box", {"cat"}),
        ("all of it in the box, not the lamp. The lamp stays.", set()),
    ],
)
def test_what_stands_behind_not_is_denied(said, names):
    assert denied(THINGS, said) == names
