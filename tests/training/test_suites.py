import json
from pathlib import Path

from app.domain.scene import Scene, SceneObject
from app.training.executor import outcome
from app.training.suites import UNSEEN_VERBS, read_suite, signature
from app.training.words import load_lists

SCENE = Scene(world="tabletop", objects=tuple(SceneObject(name=n) for n in ("pear", "cup", "box")))


def body(*calls: str) -> str:
    return "def task():\n" + "".join(f"    {call}\n" for call in calls or ("pass",))


def test_unseen_verbs_are_forty_and_none_is_known_to_the_generator() -> None:
    items = read_suite(UNSEEN_VERBS)
    assert len(items) == 40
    verbs = load_lists()["verbs"]
    known = json.dumps([verbs["put"], verbs["stack"], verbs["plain"], verbs["pair"]])
    known += json.dumps([each["names"] for each in verbs["concepts"].values()])
    for item in items:
        for action in item.actions:
            assert f'"{action.name}(' not in known
            assert f'"{action.name}|' not in known


def test_the_expected_calls_are_right_and_others_wrong() -> None:
    for line, item in zip(
        UNSEEN_VERBS.read_text(encoding="utf-8").splitlines(), read_suite(UNSEEN_VERBS), strict=True
    ):
        calls = json.loads(line)["calls"]
        assert item.check(outcome(body(*calls), item.scene, item.puts)), item.name
        assert not item.check(outcome(body(*calls, calls[0] if calls else "hop()"), item.scene, {}))


def test_a_goal_is_strict(tmp_path: Path) -> None:
    entry = {
        "id": "a",
        "category": "paper",
        "actions": "A",
        "objects": {"pear": {}, "cup": {}, "box": {}},
    }
    entry |= {"instruction": "put the pear in the box", "goal": ["in(pear,box)"]}
    entry |= {"forbidden": ["changed(cup)", "changed(box)"]}
    path = tmp_path / "suite.jsonl"
    path.write_text(json.dumps(entry) + "\n", encoding="utf-8")
    (item,) = read_suite(path)
    right = body("grab_and_putin('pear', 'box')")
    assert item.check(outcome(right, item.scene))
    more = body("grab_and_putin('pear', 'box')", "grab_and_putin('cup', 'box')")
    assert not item.check(outcome(more, item.scene))
    assert not item.check(outcome(body(), item.scene))
    assert not item.check(outcome("no program", item.scene))


def test_what_cannot_be_done_must_leave_everything(tmp_path: Path) -> None:
    entry = {
        "id": "a",
        "category": "impossible",
        "actions": "A",
        "objects": {"pear": {}, "box": {}},
    }
    entry |= {"instruction": "put the mango in the box", "goal": [], "forbidden": []}
    path = tmp_path / "suite.jsonl"
    path.write_text(json.dumps(entry) + "\n", encoding="utf-8")
    (item,) = read_suite(path)
    assert item.check(outcome(body(), item.scene))
    assert not item.check(outcome(body("grab_and_putin('pear', 'box')"), item.scene))


def test_nothing_is_put_into_itself_or_into_what_it_carries() -> None:
    assert outcome(body("grab_and_putin('cup', 'cup')"), SCENE).faults
    turned = body("grab_and_putin('cup', 'box')", "grab_and_putin('box', 'cup')")
    assert outcome(turned, SCENE).faults


def test_loops_are_written_out() -> None:
    text = "def task():\n    for each in ['pear', 'cup']:\n        grab_and_putin(each, 'box')\n"
    assert outcome(text, SCENE).places == {"pear": "box", "cup": "box"}


def test_a_signature_reads_its_numbers() -> None:
    roles = [each.role for each in signature("incline(obj, degrees)").parameters]
    assert roles == ["object", "number"]
