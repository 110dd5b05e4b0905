"""Plan: a program grounded in one scene; what cannot be grounded is data, not an exception."""

from dataclasses import dataclass

from app.domain.condition import Condition
from app.domain.program import Argument, Comment


@dataclass(frozen=True, slots=True, kw_only=True)
class GroundedCall:
    """A call of an action the world has, on objects the scene has."""

    line: int
    action: str
    arguments: tuple[Argument, ...]
    comment: str | None = None
    """The comment it stands under, if any."""


@dataclass(frozen=True, slots=True, kw_only=True)
class RejectedCall:
    """A call that names what is not there; it counts against executability."""

    line: int
    text: str
    reason: str


Call = GroundedCall | RejectedCall


@dataclass(frozen=True, slots=True, kw_only=True)
class GroundedAssertion:
    """A condition over objects of the scene, with the calls to make where it is false."""

    line: int
    condition: Condition
    recovery: tuple[Call, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class GroundedBranch:
    """A condition that decides whether the steps after it run or are passed over."""

    line: int
    condition: Condition
    skip: int
    """So many of the following steps are passed over where the condition is false."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Jump:
    """The end of a branch's first side: its other side, so many steps, is passed over."""

    skip: int


Step = GroundedCall | RejectedCall | GroundedAssertion | GroundedBranch | Jump | Comment


@dataclass(frozen=True, slots=True, kw_only=True)
class Plan:
    """The steps in source order, loops and helpers unrolled."""

    steps: tuple[Step, ...] = ()

    @property
    def calls(self) -> tuple[GroundedCall, ...]:
        """The grounded calls outside recoveries, in source order; of branches, both sides."""
        return tuple(step for step in self.steps if isinstance(step, GroundedCall))

    @property
    def rejected(self) -> tuple[RejectedCall, ...]:
        """The rejected calls, those in recoveries included, in source order."""
        found: list[RejectedCall] = []
        for step in self.steps:
            candidates = step.recovery if isinstance(step, GroundedAssertion) else (step,)
            found += [call for call in candidates if isinstance(call, RejectedCall)]
        return tuple(found)
