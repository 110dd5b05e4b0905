"""Who decides whether an assertion holds."""

from typing import Protocol

from app.domain.condition import Condition, decide
from app.domain.plan import GroundedAssertion
from app.domain.trace import AssertionChecked
from app.domain.world import World


class StateCheck(Protocol):
    """Decides conditions about a world as it stands."""

    name: str
    """As the events tell it."""

    def holds(self, condition: Condition, world: World) -> bool:
        """Whether the condition is true now."""
        ...


class WorldCheck:
    """The world itself knows."""

    name = "world"

    def holds(self, condition: Condition, world: World) -> bool:
        """Whether the condition is true now."""
        return decide(condition, world.holds)


def check(assertion: GroundedAssertion, world: World, decider: StateCheck) -> AssertionChecked:
    """The assertion, decided."""
    return AssertionChecked(
        line=assertion.line,
        condition=assertion.condition,
        holds=decider.holds(assertion.condition, world),
        decider=decider.name,
        time=world.time,
    )
