"""Parts: what the service's endpoints work with."""

from dataclasses import dataclass, field
from typing import Annotated

from fastapi import Depends, Request

from app.api.streams import EventTail
from app.llm.models import LlmConfig
from app.storage.database import Database
from app.storage.handover import Handover
from app.storage.jobs import Jobs


@dataclass(frozen=True, slots=True, kw_only=True)
class Parts:
    """Made once at start by the composition root."""

    database: Database
    jobs: Jobs
    handover: Handover
    llm: LlmConfig
    default_model: str
    vision: bool = False
    """Whether the cameras' detector can be a vision model."""
    tail: EventTail = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "tail", EventTail(self.database))


def _parts(request: Request) -> Parts:
    return request.app.state.parts


Using = Annotated[Parts, Depends(_parts)]
"""Annotation of an endpoint's parameter that takes the parts."""
