import pytest

from app.domain.errors import Conflict
from app.training.recipe import Recipe


def test_an_adapter_of_another_recipe_is_not_taken_for_this_one(tmp_path):
    start = tmp_path / "start.gguf"
    start.write_bytes(b"weights")
    made = Recipe(name="mine", base=tmp_path / "base", out=tmp_path, seed=1, start=start).choices()
    again = Recipe(name="mine", base=tmp_path / "base", out=tmp_path, seed=1, start=start)
    again.check({**made, "examples": 512})
    with pytest.raises(Conflict, match=r"was trained with seed 1;.*another --out"):
        Recipe(name="mine", base=tmp_path / "base", out=tmp_path, seed=2, start=start).check(made)
    with pytest.raises(Conflict, match="started_from"):
        Recipe(name="mine", base=tmp_path / "base", out=tmp_path, seed=1).check(made)
