"""Adapters: LoRA files (GGUF) with their drafts, each with a card that ties it to its base by checksums."""

import hashlib
import json
import logging
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from app.domain.errors import ModelUnavailable

DRAFTS = ".drafts"
"""Ending of the file of drafts beside an adapter."""
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
    drafts: Path | None = None
    """What usually follows in what it writes (``app.llm.drafts``), for speed alone."""
    drafts_sha256: str = ""


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
    _check_file(adapter.path, adapter.sha256)
    if adapter.drafts is not None:
        _check_file(adapter.drafts, adapter.drafts_sha256)


def _check_file(path: Path, sha256: str) -> None:
    try:
        with path.open("rb") as file:
            digest = hashlib.file_digest(file, "sha256").hexdigest()
    except OSError as error:
        raise ModelUnavailable(f"the adapter's {path} cannot be read: {error}") from error
    if digest != sha256:
        raise ModelUnavailable(
            f"{path} is not the one of its adapter's card: its sha256 is {digest} instead of"
            f" {sha256}; install it again, or train it anew: progprompt train"
        )


def _read(card: Path) -> Adapter:
    said = json.loads(card.read_text(encoding="utf-8"))
    return Adapter(
        name=str(said["name"]),
        path=card.with_suffix(".gguf"),
        sha256=str(said["adapter_sha256"]),
        base_sha256=str(said["base_sha256"]),
        licence=str(said.get("licence", "")),
        drafts=card.with_suffix(DRAFTS) if "drafts_sha256" in said else None,
        drafts_sha256=str(said.get("drafts_sha256", "")),
    )
