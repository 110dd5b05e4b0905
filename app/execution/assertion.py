"""Who decides whether an assertion holds, and which side of a branch is taken."""

from dataclasses import dataclass
from typing import Literal, Protocol, TypeVar

from app.domain.condition import Condition, Relation, decide, relations
from app.domain.llm import CompletionRequest, LanguageModel
from app.domain.plan import GroundedAssertion, GroundedBranch
from app.domain.trace import AssertionChecked, BranchDecided
from app.domain.world import World
from app.programs.state_query import write_state_query

MAX_TOKENS = 2
STOP = ("\n",)
Decided = TypeVar("Decided", AssertionChecked, BranchDecided)
"""What a decision is told as."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Verdict:
    """What was decided, and what each of those who were asked says."""

    holds: bool
    by_world: bool | None = None
    by_model: bool | None = None

    @property
    def agree(self) -> bool | None:
        """Whether they say the same, where both were asked."""
        if self.by_world is None or self.by_model is None:
            return None
        return self.by_world == self.by_model


class StateCheck(Protocol):
    """Decides conditions about a world as it stands."""

    name: str
    """As the events tell it."""

    def judge(self, condition: Condition, world: World) -> Verdict:
        """Whether the condition is true now.

        Raises:
            ModelError: a language model was to decide and could not be asked.
        """
        ...


class WorldCheck:
    """The world itself knows."""

    name = "world"

    def judge(self, condition: Condition, world: World) -> Verdict:
        """Whether the condition is true now."""
        holds = decide(condition, world.holds)
        return Verdict(holds=holds, by_world=holds)


class ModelCheck:
    """The paper's: a language model is told what is seen of the objects, and answers."""

    name = "model"

    def __init__(self, model: LanguageModel) -> None:
        self._model = model

    def judge(self, condition: Condition, world: World) -> Verdict:
        """What the model answers to the paper's state-check prompt.

        Raises:
            ModelError: it could not be asked.
        """
        prompt = write_state_query(condition, world.facts() | _near(condition, world))
        request = CompletionRequest(prompt=prompt, max_tokens=MAX_TOKENS, stop=STOP)
        holds = "True" in self._model.complete(request).text
        return Verdict(holds=holds, by_model=holds)


def _near(condition: Condition, world: World) -> frozenset[Relation]:
    """What of the asserted things the agent is close to: too much to be told of everything."""
    asked = (relation for relation in relations(condition) if relation.name == "near")
    return frozenset(relation for relation in asked if world.holds(relation))


class BothChecks:
    """The world and the model side by side: the world's word counts, the model's is kept."""

    name = "both"

    def __init__(self, model: LanguageModel) -> None:
        self._world, self._model = WorldCheck(), ModelCheck(model)

    def judge(self, condition: Condition, world: World) -> Verdict:
        """What each of them says.

        Raises:
            ModelError: the model could not be asked.
        """
        known = self._world.judge(condition, world)
        thought = self._model.judge(condition, world)
        return Verdict(holds=known.holds, by_world=known.holds, by_model=thought.holds)


def state_check(
    kind: Literal["world", "model", "both"], model: LanguageModel | None = None
) -> StateCheck:
    """The decider a plan asks for; ``model`` and ``both`` need a language model."""
    if kind == "world":
        return WorldCheck()
    if model is None:
        raise ValueError(f"a state check by {kind} needs a language model")
    return ModelCheck(model) if kind == "model" else BothChecks(model)


def check(assertion: GroundedAssertion, world: World, decider: StateCheck) -> AssertionChecked:
    """The assertion, decided."""
    return _decided(AssertionChecked, assertion, world, decider)


def choose(branch: GroundedBranch, world: World, decider: StateCheck) -> BranchDecided:
    """The branch, decided."""
    return _decided(BranchDecided, branch, world, decider)


def _decided(
    event: type[Decided],
    asked: GroundedAssertion | GroundedBranch,
    world: World,
    decider: StateCheck,
) -> Decided:
    verdict = decider.judge(asked.condition, world)
    return event(
        line=asked.line,
        condition=asked.condition,
        holds=verdict.holds,
        decider=decider.name,
        by_world=verdict.by_world,
        by_model=verdict.by_model,
        agree=verdict.agree,
        time=world.time,
    )
