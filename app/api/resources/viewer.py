"""The 3D view: viser's client, what it is sent, and the playhead it shares with the page."""

import asyncio
import contextlib
from collections.abc import AsyncIterator, Coroutine
from functools import cache
from pathlib import Path
from typing import Annotated, Literal

import viser
from fastapi import APIRouter, Depends, Request, WebSocket, WebSocketDisconnect
from fastapi.concurrency import run_in_threadpool
from fastapi.requests import HTTPConnection
from fastapi.responses import FileResponse, HTMLResponse, RedirectResponse, Response
from pydantic import BaseModel, Field, ValidationError

from app.api.standing_page import StandingPage
from app.domain.errors import Conflict, NotThere
from app.view.screening import Screening
from app.view.viewer import PROTOCOL, Viewer, projection

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

ALONE = Path(__file__).parents[3] / "static" / "alone.html"
"""The page of a 3D view on its own."""

HUNG_UP = (WebSocketDisconnect,)

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


@router.get("/{execution_id}/", response_class=FileResponse)
def watch(execution_id: str, viewer: Shown) -> FileResponse:
    """The 3D view of an execution and its controls: live while it runs, then a replay."""
    viewer.find(execution_id)
    return FileResponse(ALONE, headers={"Cache-Control": "no-cache"})


@router.get("/{execution_id}/{token}/", response_class=HTMLResponse, include_in_schema=False)
def watch_beside_page(request: Request, execution_id: str, token: str, viewer: Shown) -> Response:
    """Viser's client without controls, for a page that has the playhead of this token."""
    del token  # Unused: the client finds its WebSocket by its own address.
    viewer.find(execution_id)
    return _client().answer(request)


@cache
def _client() -> StandingPage:
    html = (Path(viser.__file__).parent / "client" / "build" / "index.html").read_text()
    return StandingPage(html.replace("</head>", BARE + "</head>", 1))


@router.websocket("/{execution_id}/{token}")
async def stream(socket: WebSocket, execution_id: str, token: str, viewer: Shown) -> None:
    """Viser's messages, for a view beside a page."""
    async with _screening(socket, execution_id, token, viewer) as screening:
        if screening is None:
            return
        spoken = socket.scope["subprotocols"]
        await socket.accept(subprotocol=PROTOCOL if PROTOCOL in spoken else None)
        await _both(_show(screening, socket), _from_browser(socket))


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


async def _show(screening: Screening, socket: WebSocket) -> None:
    async with contextlib.aclosing(projection(screening)) as messages:
        async for message in messages:
            await socket.send_bytes(message)


async def _from_browser(socket: WebSocket) -> None:
    """Where its camera is does not matter: everything is drawn over there."""
    async for _ in socket.iter_bytes():
        pass


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
