"""SuiteTask: an instruction in a scene, what must hold at the end, and how it could be done."""

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from app.domain.condition import Condition
from app.domain.errors import Fault, Refused
from app.domain.scene import Scene
from app.programs.conditions import parse_condition

Split = Literal["train", "test"]
ENGLISH = "en"


@dataclass(frozen=True, slots=True, kw_only=True)
class SuiteTask:
    """One task of a suite; its name is its key everywhere."""

    name: str
    category: str
    scene: Scene
    instruction: str
    goal: tuple[str, ...] = ()
    """All must hold at the end; none where the right thing is to change nothing."""
    truth: tuple[str, ...] = ()
    """The calls of a program that reaches the goal."""
    seed: int = 0
    """Of what the scene leaves open."""
    distractors: tuple[str, ...] = ()
    variants: Mapping[str, str] = field(default_factory=dict)
    """The instruction in other languages, by their codes: ``de``, ``fr`` …"""
    may_change: tuple[str, ...] = ()
    """Objects that may change though neither the goal nor the ground truth moves them."""
    order: tuple[str, ...] = ()
    """Conditions that must first become true in this order."""
    always: tuple[str, ...] = ()
    """Conditions that must hold from the start to the end."""
    hold: int = 0
    """For so many of the last steps the goal must have held without a break."""
    decline: str | None = None
    """Why the task cannot be done, where it cannot: ``absent``, ``impossible`` …"""
    length: int | None = None
    """Actions of the ground truth, where it counts others than ``truth`` shows."""
    core_goal: tuple[str, ...] | None = None
    """The goal without what merely standing near things brings about; None: ``goal`` itself."""
    place: str | None = None
    """What tables call its environment, where the scene does not say."""

    @property
    def split(self) -> Split:
        """Half of the tasks are for developing, the others for measuring; the name decides."""
        return "test" if hashlib.sha256(self.name.encode()).digest()[0] % 2 else "train"

    @property
    def environment(self) -> str:
        """What tables call it: its place, its scene's environment, or its world."""
        return self.place or self.scene.environment or self.scene.world

    @property
    def conditions(self) -> tuple[Condition, ...]:
        """The goal, parsed."""
        return tuple(map(parse_condition, self.goal))

    @property
    def steps(self) -> int:
        """Length of the ground truth, the paper's |A|."""
        return len(self.truth) if self.length is None else self.length

    @property
    def program(self) -> str:
        """The ground truth as a function in the plan language."""
        return "\n".join(["def truth():", *(f"    {call}" for call in self.truth or ("pass",)), ""])

    def spoken(self, language: str) -> str:
        """The instruction in a language.

        Raises:
            Refused: the task has none in it.
        """
        if language == ENGLISH:
            return self.instruction
        if language not in self.variants:
            have = ", ".join([ENGLISH, *self.variants])
            message = f"task {self.name!r} has no {language!r}; it has {have}"
            raise Refused(Fault(field="language", message=message))
        return self.variants[language]
