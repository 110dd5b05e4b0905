"""Slots: the model's state after a fixed prefix, kept on disk and taken up in milliseconds."""

import hashlib
import logging
import os
from collections.abc import Sequence
from pathlib import Path

import httpx

from app.domain.errors import ModelError
from app.llm.transport import Patience, Transport

MOST_KEPT = 16
"""State files; the ones longest unused go first. After 800 tokens one has 23 MB."""

BETWEEN = -1
"""Stands between the tokens of two texts; no token has this number."""

log = logging.getLogger(__name__)


class Slots:
    """The one slot of a llama.cpp server, and the states saved from it.

    Saving and restoring only saves time, so what goes wrong with it is logged and not raised.
    """

    def __init__(self, socket: Path, folder: Path, identity: str) -> None:
        """Connect to the server.

        Args:
            socket: Unix socket of the server.
            folder: Where the server reads and writes states.
            identity: Of the model and whatever else a state depends on.
        """
        network = httpx.HTTPTransport(uds=str(socket))
        self._server = Transport(
            "http://llm/", transport=network, patience=Patience(read=30.0, attempts=1)
        )
        self._folder = folder
        self._identity = identity
        self._known: set[str] = set()
        self._held = ""

    def close(self) -> None:
        """Let go of the server."""
        self._server.close()

    def holds(self, prompt: str) -> None:
        """The slot now holds the state after this prompt."""
        self._held = prompt

    def prepare(self, prompt: str) -> None:
        """Bring back the longest known prefix of the prompt, unless the slot still holds it."""
        fitting = [prefix for prefix in self._known if prompt.startswith(prefix)]
        longest = max(fitting, key=len, default="")
        if longest and not self._held.startswith(longest):
            self.restore(longest)

    def restore(self, prefix: str) -> bool:
        """Take up the state after ``prefix``; False where none is saved or it is of no use."""
        path = self._path(prefix)
        if not path.exists():
            return False
        if not self._do("restore", path.name):
            path.unlink(missing_ok=True)
            self._known.discard(prefix)
            return False
        os.utime(path)
        self._known.add(prefix)
        self._held = prefix
        return True

    def save(self, prefix: str) -> None:
        """Keep the slot's state, which is the one after ``prefix``."""
        path = self._path(prefix)
        # Under a name of our own until it is whole: another process may save the same.
        part = path.with_name(f"{path.name}.{os.getpid()}.part")
        if self._do("save", part.name):
            part.replace(path)
            self._known.add(prefix)
            self._drop_oldest()

    def tokens(self, texts: Sequence[str]) -> list[tuple[int, ...]]:
        """Each text in the model's tokens.

        Raises:
            ModelError: the server gives none.
        """
        mixed = [part for text in texts for part in (text, BETWEEN)]
        answer = self._server.post("tokenize", {"content": mixed, "parse_special": False})
        found: list[list[int]] = [[]]
        for token in answer["tokens"]:
            if token == BETWEEN:
                found.append([])
            else:
                found[-1].append(token)
        return [tuple(each) for each in found[:-1]]

    def _do(self, action: str, filename: str) -> bool:
        try:
            self._server.post(f"slots/0?action={action}", {"filename": filename})
        except ModelError as error:
            log.warning("could not %s the state in %s: %s", action, filename, error)
            return False
        return True

    def _path(self, prefix: str) -> Path:
        key = hashlib.sha256(f"{self._identity}\n{prefix}".encode()).hexdigest()[:24]
        return self._folder / f"{key}.slot"

    def _drop_oldest(self) -> None:
        saved = sorted(self._folder.glob("*.slot"), key=lambda path: path.stat().st_mtime)
        for path in saved[:-MOST_KEPT]:
            path.unlink(missing_ok=True)
