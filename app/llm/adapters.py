"""Adapters: LoRA files (GGUF), each with a card that ties it to its base by checksums."""

import hashlib
import json
import logging
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from app.domain.errors import ModelUnavailable

SHIPPED = Path(__file__).resolve().parents[2] / "static" / "adapters"

log = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True, kw_only=True)
class Adapter:
    """An adapter's file, and what its card says of it."""

    name: str
    path: Path
    sha256: str
    base_sha256: str
    """Of the only file of weights that it fits."""
    licence: str


def adapters_in(folder: Path) -> Iterator[Adapter]:
    """Every adapter that has a card ``<name>.json`` beside it, by name; the files are not read.

    What is no card is left out with a warning, for the other models go on working.
    """
    for card in sorted(folder.glob("*.json")):
        try:
            yield _read(card)
        except (OSError, ValueError, KeyError, TypeError) as error:
            log.warning("%s is no adapter's card: %r", card, error)


def check(adapter: Adapter, base_sha256: str) -> None:
    """Make sure that the file is the one of its card, and was trained for this base.

    Raises:
        ModelUnavailable: it is absent, altered, or made for another base.
    """
    if base_sha256 != adapter.base_sha256:
        raise ModelUnavailable(
            f"the adapter {adapter.name} was trained for weights with sha256"
            f" {adapter.base_sha256}; these have {base_sha256}: name its own base"
        )
    try:
        with adapter.path.open("rb") as file:
            digest = hashlib.file_digest(file, "sha256").hexdigest()
    except OSError as error:
        raise ModelUnavailable(f"the adapter {adapter.path} cannot be read: {error}") from error
    if digest != adapter.sha256:
        raise ModelUnavailable(
            f"{adapter.path} is not the adapter of its card: its sha256 is {digest} instead of"
            f" {adapter.sha256}; install it again, or train it anew: progprompt train"
        )


def _read(card: Path) -> Adapter:
    said = json.loads(card.read_text(encoding="utf-8"))
    return Adapter(
        name=str(said["name"]),
        path=card.with_suffix(".gguf"),
        sha256=str(said["adapter_sha256"]),
        base_sha256=str(said["base_sha256"]),
        licence=str(said.get("licence", "")),
    )
