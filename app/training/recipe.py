"""Recipe: what adapter to make, of what, how and where."""

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from app.domain.errors import Conflict
from app.llm.adapters import DRAFTS


@dataclass(frozen=True, slots=True, kw_only=True)
class Recipe:
    """All that a run of training depends on."""

    name: str
    base: Path
    out: Path
    """A folder, made if need be."""
    examples: int = 6000
    minutes: float = 120.0
    threads: int = 2
    device: str = "cpu"
    seed: int = 1
    first_layer: int = 4
    rate: float = 6e-4
    """Of learning, at its height."""
    start: Path | None = None
    """An adapter of the same base and layers to go on from."""
    per_kind: int = 10
    suite: tuple[Path, ...] = ()
    data: Path | None = None
    """A folder of the user's own words."""

    @property
    def adapter(self) -> Path:
        """The file it is all for."""
        return self.out / f"{self.name}.gguf"

    @property
    def drafts(self) -> Path:
        """What usually follows in what it writes."""
        return self.adapter.with_suffix(DRAFTS)

    def choices(self) -> dict[str, object]:
        """What makes an adapter another one; the card tells it."""
        return {
            "seed": self.seed,
            "first_layer": self.first_layer,
            "rate": self.rate,
            "started_from": hashlib.sha256(self.start.read_bytes()).hexdigest()
            if self.start
            else None,
        }

    def check(self, made: Mapping[str, object]) -> None:
        """Make sure that the adapter which is there already was made by this recipe.

        Raises:
            Conflict: it was not; the choices that differ are named.
        """
        mine = self.choices()
        differing = [name for name in mine if name in made and made[name] != mine[name]]
        if differing:
            told = ", ".join(f"{name} {made[name]}" for name in differing)
            raise Conflict(
                f"{self.adapter} was trained with {told}; give another --out, or remove it first"
            )
