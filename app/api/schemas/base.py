"""What all schemas share."""

from typing import Annotated, Any

from pydantic import AfterValidator, BaseModel, ConfigDict, Field


class Given(BaseModel):
    """Something a client sends: unknown fields and numbers that are none are refused."""

    model_config = ConfigDict(extra="forbid", allow_inf_nan=False)


class Shown(BaseModel):
    """Something a client gets."""

    model_config = ConfigDict(from_attributes=True)


def _storable(text: str) -> str:
    if any("\ud800" <= character <= "\udfff" for character in text):
        raise ValueError("has a lone surrogate, which is no character")
    return text


Text = Annotated[str, AfterValidator(_storable)]
"""JSON can spell halves of characters that no database and no terminal takes."""


class Page(Shown):
    """A part of a list."""

    items: list[dict[str, Any]] = Field(description="The entries.")
    next: str | None = Field(
        description="What to pass as `cursor` for the next part; null at the end."
    )


MAX_SEED = 2**32 - 1
Seed = Annotated[
    int,
    Field(
        ge=0,
        le=MAX_SEED,
        description="Seed of sampled positions and of the rollout; the same seed, the same rollout.",
    ),
]
