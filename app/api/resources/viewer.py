"""The 3D view: viser's client, its WebSocket, and the playhead it shares with the page."""

import asyncio
import contextlib
from collections.abc import AsyncIterator, Coroutine
from functools import cache
from pathlib import Path
from typing import Annotated, Literal

import viser
import websockets
from fastapi import APIRouter, Depends, Request, WebSocket, WebSocketDisconnect
from fastapi.concurrency import run_in_threadpool
from fastapi.requests import HTTPConnection
from fastapi.responses import HTMLResponse, RedirectResponse
from pydantic import BaseModel, Field, ValidationError
from websockets.asyncio.client import ClientConnection
from websockets.typing import Subprotocol

from app.domain.errors import Conflict, NotThere
from app.view.screening import Screening
from app.view.viewer import Viewer

NOT_THERE = 4404
"""WebSocket close code: there is nothing under this path."""
NOT_UNDERSTOOD = 4400
"""WebSocket close code: a command is malformed; the reason says how."""
BARE = (
    "<style>.mantine-Notifications-root, .mantine-Paper-root { display: none !important }</style>"
)
"""Hides viser's own panel and notices where a page around the picture has better ones."""
TELL_EVERY = 0.1
"""How often a page is told where its playhead is [s]; in between it reckons."""

HUNG_UP = (WebSocketDisconnect, websockets.ConnectionClosed)

router = APIRouter(prefix="/viewer", tags=["viewer"])


class Command(BaseModel, extra="forbid"):
    """What a page asks of its playhead; what is absent stays as it is."""

    time: float | None = Field(None, ge=0, allow_inf_nan=False)
    """Jump to this moment [s]."""
    mode: Literal["playing", "paused", "following"] | None = None
    speed: float | None = Field(None, gt=0, le=8)


def _viewer(connection: HTTPConnection) -> Viewer:
    viewer = connection.app.state.viewer
    if viewer is None:
        raise Conflict("this service runs without a 3D view")
    return viewer


Shown = Annotated[Viewer, Depends(_viewer)]


@router.get("/{execution_id}", include_in_schema=False)
def add_slash(request: Request) -> RedirectResponse:
    """Viser's client finds its WebSocket by its own address, which is a folder's."""
    return RedirectResponse(request.url.replace(path=f"{request.url.path}/"))


@router.get("/{execution_id}/", response_class=HTMLResponse)
def watch(execution_id: str, viewer: Shown) -> HTMLResponse:
    """The 3D view of an execution, with controls of its own: live while it runs, then a replay."""
    return _client(execution_id, viewer.token_alone(), viewer, _client_html())


@router.get("/{execution_id}/{token}/", response_class=HTMLResponse, include_in_schema=False)
def watch_beside_page(execution_id: str, token: str, viewer: Shown) -> HTMLResponse:
    """The same without controls, for a page that has the playhead of this token."""
    bare = _client_html().replace("</head>", BARE + "</head>", 1)
    return _client(execution_id, token, viewer, bare)


def _client(execution_id: str, token: str, viewer: Viewer, html: str) -> HTMLResponse:
    with viewer.screening(execution_id, token):
        return HTMLResponse(html)


@cache
def _client_html() -> str:
    return (Path(viser.__file__).parent / "client" / "build" / "index.html").read_text()


@router.websocket("/{execution_id}")
async def stream_alone(socket: WebSocket, execution_id: str, viewer: Shown) -> None:
    """Viser's messages, for a view alone."""
    await stream(socket, execution_id, viewer.token_alone(), viewer)


@router.websocket("/{execution_id}/{token}")
async def stream(socket: WebSocket, execution_id: str, token: str, viewer: Shown) -> None:
    """Viser's messages, for a view beside a page."""
    protocols = [Subprotocol(name) for name in socket.scope["subprotocols"]]
    async with _screening(socket, execution_id, token, viewer) as screening:
        if screening is None:
            return
        url = viewer.url(execution_id, token)
        async with websockets.connect(
            url, subprotocols=protocols, max_size=None, compression=None, proxy=None
        ) as behind:
            await socket.accept(subprotocol=behind.subprotocol)
            await _both(_to_browser(behind, socket), _from_browser(socket, behind))


@router.websocket("/{execution_id}/{token}/playhead")
async def playhead(socket: WebSocket, execution_id: str, token: str, viewer: Shown) -> None:
    """Tells a page where its 3D view is, as a ``Moment``, and takes ``Command``s."""
    async with _screening(socket, execution_id, token, viewer) as screening:
        if screening is None:
            return
        await socket.accept()
        await _both(_tell(screening, socket), _obey(socket, screening))


@contextlib.asynccontextmanager
async def _screening(
    socket: WebSocket, execution_id: str, token: str, viewer: Viewer
) -> AsyncIterator[Screening | None]:
    """The screening, or None after having refused the socket."""
    context = viewer.screening(execution_id, token)
    try:
        # Opening one may read the store and compile a model.
        screening = await run_in_threadpool(context.__enter__)
    except NotThere as error:
        await socket.accept()
        await socket.close(NOT_THERE, str(error)[:120])
        yield None
        return
    try:
        yield screening
    finally:
        context.__exit__(None, None, None)


async def _both(*ways: Coroutine[None, None, None]) -> None:
    """Run both ways until either side hangs up."""
    tasks = [asyncio.create_task(way) for way in ways]
    try:
        await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
    finally:
        for task in tasks:
            task.cancel()
        ends = await asyncio.gather(*tasks, return_exceptions=True)
    for end in ends:
        if isinstance(end, Exception) and not isinstance(end, HUNG_UP):
            raise end


async def _to_browser(behind: ClientConnection, socket: WebSocket) -> None:
    async for message in behind:
        assert isinstance(message, bytes)
        await socket.send_bytes(message)
    await socket.close(behind.close_code or 1000, behind.close_reason)


async def _from_browser(socket: WebSocket, behind: ClientConnection) -> None:
    async for message in socket.iter_bytes():
        await behind.send(message)


async def _tell(screening: Screening, socket: WebSocket) -> None:
    told = None
    while True:
        if (moment := screening.moment()) != told:
            await socket.send_json(moment.as_dict())
            told = moment
        await asyncio.sleep(TELL_EVERY)


async def _obey(socket: WebSocket, screening: Screening) -> None:
    async for text in socket.iter_text():
        try:
            command = Command.model_validate_json(text)
        except ValidationError as error:
            await socket.close(NOT_UNDERSTOOD, str(error.errors()[0]["msg"])[:120])
            return
        if command.speed is not None:
            screening.set_speed(command.speed)
        if command.mode is not None:
            screening.turn(command.mode)
        if command.time is not None:
            screening.seek(command.time)
