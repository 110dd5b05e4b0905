import msgspec
import pytest
import viser
import zstandard

from app.view.recording import record

pytestmark = pytest.mark.filterwarnings("ignore::DeprecationWarning:websockets")


def read(recording):
    """The content of a ``.viser`` file."""
    inner = zstandard.ZstdDecompressor().decompressobj().decompress(recording[8:])
    assert len(inner) == int.from_bytes(recording[:8], "little")
    length = int.from_bytes(inner[:8], "little")
    return msgspec.msgpack.decode(inner[8 : 8 + length])


@pytest.fixture(scope="module")
def film(model, frames):
    return read(record(model, frames))


def of_kind(film, kind):
    return [(time, message) for time, message in film["messages"] if message["type"] == kind]


def test_recording_is_of_the_viewer_that_plays_it(film):
    assert film["viserVersion"] == viser.__version__


def test_recording_lasts_as_long_as_the_rollout(film, frames):
    assert film["durationSeconds"] == pytest.approx(frames[-1, 0])


def test_recording_has_every_body_that_is_to_be_seen(film):
    names = {message["name"] for _, message in of_kind(film, "GlbMessage")}
    assert names == {"/world/1/looks", "/world/2/looks"}


def test_block_is_recorded_where_it_was(film):
    rises = [
        (time, message["position"][2])
        for time, message in of_kind(film, "SetPositionMessage")
        if message["name"] == "/world/2" and time > 0
    ]
    assert len(rises) == 29
    assert all(height == pytest.approx(0.1 + time) for time, height in rises)


def test_what_does_not_move_is_not_told(film):
    moved = {message["name"] for time, message in of_kind(film, "SetPositionMessage") if time > 0}
    assert moved == {"/world/2"}


def test_no_more_than_thirty_pictures_a_second(model, frames):
    dense = frames.copy()
    dense[:, 0] /= 10
    times = {time for time, _ in read(record(model, dense))["messages"]}
    assert len(times) <= 5


def test_rollout_without_frames_is_a_picture_of_the_scene(model, frames):
    film = read(record(model, frames[:0]))
    assert film["durationSeconds"] == 0
    assert len(of_kind(film, "GlbMessage")) == 2
