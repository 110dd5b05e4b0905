import json
from pathlib import Path

from app.training.taxonomy import members, write_classes

DATA = """  1 a line of the licence
00000010 13 n 01 fruit 0 002 ~ 00000020 n 0000 ~ 00000030 n 0000 | what grows
00000020 13 n 02 apple 0 malus_pumila 0 001 @ 00000010 n 0000 | a fruit
00000030 13 n 01 berry 0 001 ~ 00000040 n 0000 | a small fruit
00000040 13 n 02 goji_berry 0 Lycium 0 000 | a berry
"""
INDEX = """  1 a line of the licence
fruit n 1 1 ~ 1 0 00000010
apple n 2 1 @ 2 0 00000020 00000099
malus_pumila n 1 1 @ 1 0 00000020
berry n 2 1 @ 2 0 00000099 00000030
goji_berry n 1 1 @ 1 0 00000040
"""


def database(folder: Path) -> Path:
    (folder / "data.noun").write_text(DATA, "utf-8")
    (folder / "index.noun").write_text(INDEX, "utf-8")
    return folder


def test_members_are_found_at_any_depth_if_it_is_their_main_meaning(tmp_path: Path) -> None:
    found = members(database(tmp_path), "fruit", lambda word: -len(word))
    assert found == ["apple", "goji berry", "malus pumila"]


def test_classes_are_written_by_name(tmp_path: Path) -> None:
    out = tmp_path / "classes.json"
    write_classes(database(tmp_path), {"berries": "berry#2"}, len, out)
    assert json.loads(out.read_text("utf-8")) == {"berries": ["goji berry"]}
