"""Viewer: shows every browser the rollout it asks for, each at its own moment."""

import contextlib
import threading
import time
from collections.abc import AsyncGenerator, Callable, Iterator

import viser

from app.view.film import BEGINNING, Film
from app.view.screening import Screening
from app.view.source import Footage, RolloutSource

PROTOCOL = f"viser-v{viser.__version__}"
"""The WebSocket protocol that viser's client speaks."""
PICTURE = 1 / 30
"""How long a picture is shown [s]."""
STILL = 0.5
"""How often a paused view looks whether there is more to show [s]."""
SHELF = 8
"""Films kept at hand, the last used last: a page that is loaded again opens at once."""


class Viewer:
    """Rollouts as films that all who watch share.

    ``rollouts`` finds a rollout by its execution's id and raises ``NotThere`` for an unknown one.
    All that use the same token, the 3D view and the page around it, share one ``screening``.
    """

    def __init__(self, rollouts: Callable[[str], RolloutSource]) -> None:
        self._rollouts = rollouts
        self._opening = threading.Lock()
        """One film is opened at a time: two that ask for the same one share it."""
        self._lock = threading.Lock()
        """For the blink of an eye only: whoever leaves does so on the event loop."""
        self._screenings: dict[tuple[str, str], tuple[Screening, int]] = {}
        self._shelf: dict[str, Film] = {}

    @contextlib.contextmanager
    def screening(self, execution_id: str, token: str) -> Iterator[Screening]:
        """The screening under this token; it is dropped when the last one has left it.

        Raises:
            NotThere: there is no such execution, or nothing to be seen of it.
        """
        key = (execution_id, token)
        screening = self._enter(key)
        try:
            yield screening
        finally:
            with self._lock:
                _, users = self._screenings.pop(key)
                if users > 1:
                    self._screenings[key] = (screening, users - 1)

    def find(self, execution_id: str) -> None:
        """Make sure there is something to be seen.

        Raises:
            NotThere: there is no such execution, or nothing to be seen of it.
        """
        if execution_id not in self._shelf:
            self._rollouts(execution_id)

    def _enter(self, key: tuple[str, str]) -> Screening:
        with self._opening:
            with self._lock:
                known = self._screenings.get(key)
            screening = known[0] if known else self._open(key[0])
            with self._lock:
                _, users = self._screenings.get(key, (screening, 0))
                self._screenings[key] = (screening, users + 1)
        return screening

    def _open(self, execution_id: str) -> Screening:
        film = self._shelf.pop(execution_id, None)
        if film is None:
            film = Film(Footage(self._rollouts(execution_id)))
        self._shelf[execution_id] = film
        if len(self._shelf) > SHELF:
            del self._shelf[next(iter(self._shelf))]
        return Screening(film)


async def projection(screening: Screening) -> AsyncGenerator[bytes, None]:
    """What to send to a browser, each when it is due; without an end."""
    yield screening.film.opening
    with screening.drawing():
        shown, due = BEGINNING, time.monotonic()
        while True:
            moment = await screening.tick()
            if moment != shown:
                if picture := screening.film.picture(shown, moment):
                    yield picture
                shown = moment
            # Paced by the clock: what a picture took to make is not added to its time.
            due = max(due + PICTURE, time.monotonic())
            await screening.rest(playing=due - time.monotonic(), still=STILL)
