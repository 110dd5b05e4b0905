import json
from pathlib import Path

from app.training.executor import outcome
from app.training.suites import held_out, read_suite


def entry(**fields: object) -> dict[str, object]:
    objects: dict[str, object] = {"cup": {}, "mug": {}, "box": {}}
    usual = {"id": "a", "category": "simple", "actions": "A", "objects": objects}
    return {**usual, "instruction": "put the cup in the box", **fields}


def suite_of(tmp_path: Path, **fields: object) -> Path:
    path = tmp_path / "suite.jsonl"
    path.write_text(json.dumps(entry(**fields)) + "\n", "utf-8")
    return path


def test_a_goal_that_is_met_is_right(tmp_path: Path) -> None:
    [item] = read_suite(suite_of(tmp_path, goal=["in(cup, box)"], forbidden=["changed(mug)"]))
    assert item.check(outcome("    grab_and_putin('cup', 'box')\n", item.objects))
    assert not item.check(outcome("    pass\n", item.objects))


def test_moving_anything_else_is_wrong(tmp_path: Path) -> None:
    [item] = read_suite(suite_of(tmp_path, goal=["in(cup, box)"], forbidden=["changed(mug)"]))
    body = "    grab_and_putin('cup', 'box')\n    grab_and_putin('mug', 'box')\n"
    assert not item.check(outcome(body, item.objects))


def test_counts_and_open_things_are_decided(tmp_path: Path) -> None:
    goal = ["count(box; cup | mug) = 1", "open(box)"]
    [item] = read_suite(suite_of(tmp_path, actions="B", goal=goal, forbidden=[]))
    body = "    open('box')\n    grab_and_putin('mug', 'box')\n"
    assert item.check(outcome(body, item.objects))
    assert not item.check(outcome(body + "    close('box')\n", item.objects))


def test_the_held_out_suite_is_the_same_each_time_and_has_every_kind_alike() -> None:
    first, second = held_out(2), held_out(2)
    assert [item.sentence for item in first] == [item.sentence for item in second]
    kinds = [item.kind for item in first]
    assert all(kinds.count(kind) <= 2 for kind in kinds)
    assert len(set(kinds)) > 20
