"""Viewer: one viser server that shows every browser the rollout it asks for."""

import contextlib
import secrets
import threading
import time
from collections.abc import Callable, Iterator

from viser import ClientHandle

from app.view.controls import Controls
from app.view.live import Drawing
from app.view.quiet import LOOPBACK, open_server
from app.view.screening import Screening
from app.view.source import Footage, RolloutSource

PICTURE = 1 / 30
"""How long a picture is shown [s]."""
STILL = 0.5
"""How often a paused view looks whether there is more to show [s]."""
SHELF = 8
"""Footages kept at hand, the last used last: a page that is loaded again opens at once."""
ALONE = "alone-"
"""Begins the token of a browser that has no page around the view."""


class Viewer:
    """Shows rollouts in browsers, each at its own moment.

    ``rollouts`` finds a rollout by its execution's id and raises ``NotThere`` for an unknown one.
    A browser's WebSocket is led to ``url(execution_id, token)``. All that use the same token, the
    3D view and the page around it, share one ``screening``; a view alone has its own controls.
    """

    def __init__(self, rollouts: Callable[[str], RolloutSource]) -> None:
        self._rollouts = rollouts
        self._lock = threading.Lock()
        self._screenings: dict[tuple[str, str], tuple[Screening, int]] = {}
        self._shelf: dict[str, Footage] = {}
        self._gone: dict[int, threading.Event] = {}
        self._server = open_server()
        self._server.on_client_connect(self._welcome)
        self._server.on_client_disconnect(self._part)

    def close(self) -> None:
        """End all showing."""
        for gone in list(self._gone.values()):
            gone.set()
        self._server.stop()

    def url(self, execution_id: str, token: str) -> str:
        """Where viser's client finds its server, on this machine only."""
        return f"ws://{LOOPBACK}:{self._server.get_port()}/{execution_id}/{token}"

    @staticmethod
    def token_alone() -> str:
        """A fresh token for a view without a page around it."""
        return ALONE + secrets.token_hex(8)

    @contextlib.contextmanager
    def screening(self, execution_id: str, token: str) -> Iterator[Screening]:
        """The screening under this token; it is dropped when the last one has left it.

        Raises:
            NotThere: there is no such execution, or nothing to be seen of it.
        """
        key = (execution_id, token)
        with self._lock:
            screening, users = self._screenings.get(key) or (self._open(execution_id), 0)
            self._screenings[key] = (screening, users + 1)
        try:
            yield screening
        finally:
            with self._lock:
                _, users = self._screenings.pop(key)
                if users > 1:
                    self._screenings[key] = (screening, users - 1)

    def _open(self, execution_id: str) -> Screening:
        footage = self._shelf.pop(execution_id, None) or Footage(self._rollouts(execution_id))
        self._shelf[execution_id] = footage
        if len(self._shelf) > SHELF:
            del self._shelf[next(iter(self._shelf))]
        return Screening(footage)

    async def _welcome(self, client: ClientHandle) -> None:
        """Give a browser a thread that draws for it as long as it stays."""
        # viser does not say which path a client came by; the connection itself knows.
        connections = self._server._websock_server._live_connections
        connection = connections.get(client.client_id)
        if connection is None or connection.request is None:
            return
        _, execution_id, token = connection.request.path.split("/")
        gone = self._gone[client.client_id] = threading.Event()
        name = f"view of {execution_id}"
        work = (client, execution_id, token, gone)
        threading.Thread(target=self._show, args=work, name=name, daemon=True).start()

    async def _part(self, client: ClientHandle) -> None:
        if gone := self._gone.pop(client.client_id, None):
            gone.set()

    def _show(
        self, client: ClientHandle, execution_id: str, token: str, gone: threading.Event
    ) -> None:
        with self.screening(execution_id, token) as screening:
            drawing = Drawing(client, screening.footage.model)
            controls = Controls(client.gui, screening) if token.startswith(ALONE) else None
            screening.drawn = True
            shown, due = -1.0, time.monotonic()
            while not gone.is_set():
                moment = screening.tick()
                if moment != shown:
                    drawing.show(screening.footage.at(moment))
                    shown = moment
                if controls:
                    controls.show()
                # Paced by the clock: what a picture took to make is not added to its time.
                due = max(due + PICTURE, time.monotonic())
                screening.rest(playing=due - time.monotonic(), still=STILL)
