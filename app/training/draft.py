"""A sentence on its way to be an example."""

from dataclasses import dataclass

from app.domain.action import ActionSignature
from app.domain.planner import Turn
from app.training.steps import Step


@dataclass(slots=True)
class Draft:
    """A sentence on its way."""

    text: str
    steps: list[Step]
    order: bool = True
    history: tuple[Turn, ...] = ()
    plain: bool = False
    """Not to be dressed nor misspelt."""
    lines: tuple[str, ...] = ()
    """The sketch where it is no matter of the robot's verbs, with ``actions``."""
    actions: tuple[ActionSignature, ...] = ()
