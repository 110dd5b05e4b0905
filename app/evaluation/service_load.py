"""Load on a running service: reads and accepted writes over HTTP, beside browsers that watch."""

import asyncio
import json
import time
from collections.abc import Sequence
from dataclasses import dataclass
from urllib.parse import urlsplit

import msgspec
import numpy as np
import viser
from websockets.asyncio.client import connect
from websockets.typing import Subprotocol

CONNECTIONS = 8
"""Kept open at the same time; each sends its next request when it has its answer."""
WARM_UP = 1.0  # [s], not counted
CAMERA = msgspec.msgpack.encode(
    {
        "type": "ViewerCameraMessage",
        "wxyz": (1.0, 0.0, 0.0, 0.0),
        "position": (1.0, 1.0, 1.0),
        "fov": 1.0,
        "near": 0.01,
        "far": 100.0,
        "image_height": 100,
        "image_width": 100,
        "look_at": (0.0, 0.0, 0.0),
        "up_direction": (0.0, 0.0, 1.0),
    }
)
"""What viser's client sends first, and whenever its camera is turned."""


@dataclass(frozen=True, slots=True, kw_only=True)
class LoadRow:
    """One kind of request, sent without a pause for some seconds."""

    request: str
    viewers: int
    answered: int
    refused: int
    """Answers of another status than 2xx."""
    per_second: float
    p50: float
    """Median time from request to answer [s]."""
    p95: float
    """Time that 95 % of the answers take at most [s]."""
    pictures_per_second: float
    """What a viewer gets meanwhile, the mean of all; 0 without viewers."""


def bench_request(
    url: str, request: bytes, name: str, seconds: float, films: Sequence[str] = ()
) -> LoadRow:
    """Send ``request`` again and again for ``seconds`` [s], while browsers watch ``films``.

    ``films`` are executions' ids, one for each browser.
    """
    return asyncio.run(_bench(url, request, name, seconds, films))


def http_request(url: str, method: str, path: str, body: object = None) -> bytes:
    """A request as it goes over the wire."""
    content = b"" if body is None else json.dumps(body).encode()
    lines = (
        f"{method} {path} HTTP/1.1",
        f"Host: {urlsplit(url).netloc}",
        "Content-Type: application/json",
        f"Content-Length: {len(content)}",
    )
    return "\r\n".join(lines).encode() + b"\r\n\r\n" + content


async def _bench(
    url: str, request: bytes, name: str, seconds: float, films: Sequence[str]
) -> LoadRow:
    watching = [_Watcher(url, execution_id) for execution_id in films]
    views = [asyncio.create_task(watcher.watch()) for watcher in watching]
    for watcher in watching:
        await watcher.opened.wait()
    start = time.perf_counter() + WARM_UP
    end = start + seconds
    seen = asyncio.create_task(_pictures(watching, start, end))
    rows = await asyncio.gather(*(_send(url, request, end) for _ in range(CONNECTIONS)))
    pictures = await seen
    for view in views:
        view.cancel()
    await asyncio.gather(*views, return_exceptions=True)
    answers = [row for part in rows for row in part if row[0] >= start]
    taken = [took for _, took, _ in answers]
    return LoadRow(
        request=name,
        viewers=len(films),
        answered=len(answers),
        refused=sum(status // 100 != 2 for _, _, status in answers),
        per_second=len(answers) / seconds,
        p50=float(np.percentile(taken, 50)),
        p95=float(np.percentile(taken, 95)),
        pictures_per_second=pictures,
    )


async def _send(url: str, request: bytes, end: float) -> list[tuple[float, float, int]]:
    """Each answer's moment, how long it took [s], and its status."""
    place = urlsplit(url)
    reader, writer = await asyncio.open_connection(place.hostname, place.port)
    answers: list[tuple[float, float, int]] = []
    while (sent := time.perf_counter()) < end:
        writer.write(request)
        head = await reader.readuntil(b"\r\n\r\n")
        length = head.lower().partition(b"content-length:")[2].split(maxsplit=1)[0]
        await reader.readexactly(int(length))
        now = time.perf_counter()
        answers.append((now, now - sent, int(head[9:12])))
    writer.close()
    await writer.wait_closed()
    return answers


async def _pictures(watching: Sequence["_Watcher"], start: float, end: float) -> float:
    """Pictures a second of a watcher between two moments, the mean of all."""
    await asyncio.sleep(start - time.perf_counter())
    before = sum(watcher.pictures for watcher in watching)
    await asyncio.sleep(end - time.perf_counter())
    shown = sum(watcher.pictures for watcher in watching) - before
    return shown / (end - start) / len(watching) if watching else 0.0


class _Watcher:
    """A browser: the 3D view and the page around it, which plays the film over and over."""

    def __init__(self, url: str, execution_id: str) -> None:
        self._url = f"{url.replace('http', 'ws', 1)}/viewer/{execution_id}/bench-{id(self)}"
        self.pictures = 0
        self.opened = asyncio.Event()

    async def watch(self) -> None:
        """Take pictures until cancelled."""
        protocol = Subprotocol(f"viser-v{viser.__version__}")
        async with (
            connect(f"{self._url}/playhead", max_size=None, compression=None) as page,
            connect(self._url, subprotocols=[protocol], max_size=None, compression=None) as view,
        ):
            await view.send(CAMERA)
            await asyncio.gather(self._look(view), self._replay(page))

    async def _look(self, view) -> None:  # noqa: ANN001 - what ``connect`` gives
        async for _ in view:
            self.pictures += 1
            self.opened.set()

    async def _replay(self, page) -> None:  # noqa: ANN001
        async for told in page:
            moment = json.loads(told)
            if moment["mode"] == "paused" and moment["finished"]:
                await page.send(json.dumps({"mode": "playing"}))
