"""Planner: from scene and instruction to a program."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from app.domain.action import ActionSignature
from app.domain.instruction import Instruction
from app.domain.llm import Completion, LanguageModel
from app.domain.scene import Scene
from app.domain.trace import PlanningEvent


@dataclass(frozen=True, slots=True, kw_only=True)
class PlannerOptions:
    """The switches of the paper's prompt and of its decoding; all are recorded with the plan."""

    name: str = "progprompt"
    model: str = "default"
    comments: bool = True
    feedback: bool = False
    """Assertions with recoveries in the example programs; the paper's robot runs without."""
    examples: int = 3
    constrained: bool = True
    """Decode under a grammar made from the scene, where the backend can."""
    temperature: float = 0.0
    seed: int = 0
    max_tokens: int = 600


@dataclass(frozen=True, slots=True, kw_only=True)
class Task:
    """What a planner is given; the goal is not among it."""

    scene: Scene
    """Completed by its world."""
    actions: tuple[ActionSignature, ...]
    instruction: Instruction
    options: PlannerOptions


@dataclass(frozen=True, slots=True, kw_only=True)
class Draft:
    """What came of it, unparsed; everything of it is stored."""

    prompt: str
    completion: Completion
    program: str
    """The text of the whole function, ready to be parsed."""


Report = Callable[[PlanningEvent], bool]
"""Takes each event as it happens; True asks the planner to stop (it raises ``Cancelled``)."""


class Planner(Protocol):
    """One way of getting from a sentence to a program."""

    def write_program(self, task: Task, model: LanguageModel, report: Report) -> Draft:
        """Ask the model for the program of this task.

        Raises:
            ModelError: the model could not be asked, or gave nothing usable.
            Cancelled: ``report`` asked for it.
        """
        ...
