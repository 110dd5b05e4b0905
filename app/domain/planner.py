"""Planner: from scene and instruction to a program."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Literal, Protocol, runtime_checkable

from app.domain.action import ActionSignature
from app.domain.condition import Relation
from app.domain.instruction import Instruction
from app.domain.llm import Completion, LanguageModel
from app.domain.scene import Scene
from app.domain.trace import PlanningEvent
from app.domain.world import World


@dataclass(frozen=True, slots=True, kw_only=True)
class PlannerOptions:
    """The switches of the paper's prompt and of its decoding; all are recorded with the plan."""

    name: str = "progprompt"
    model: str = "default"
    cue: bool = True
    """The function is named after the instruction, which cues the model; else a docstring tells it."""
    comments: bool = True
    feedback: bool = False
    """Assertions with recoveries in the example programs; the paper's robot runs without."""
    examples: int = 3
    constrained: bool = True
    """Decode under a grammar made from the scene, where the backend can."""
    affordances: bool = True
    """The grammar binds objects to what can be done with them, too; not so in the paper."""
    temperature: float = 0.0
    seed: int = 0
    max_tokens: int = 600
    objects: Literal["local", "global", "properties"] | None = None
    """Where the prompt lists the objects; None for the world's own form."""
    choice: Literal["fixed", "random", "similar"] = "fixed"
    """How the example programs are chosen."""
    state_check: Literal["world", "model", "both"] = "world"
    """Who decides assertions: the world's relations, the paper's state-check prompt, or both."""
    repair: bool | None = None
    """Insert what an action's missing precondition calls for, by the perfect executor; None for as
    the planner has it."""
    max_replans: int = 0


@dataclass(frozen=True, slots=True, kw_only=True)
class Turn:
    """An earlier plan of the same dialogue, or an earlier try at the same instruction."""

    instruction: str
    program: str
    outcome: str = ""
    """What came of it, in words: the failed steps and the unmet assertions; empty where all went well."""
    choices: tuple[str, ...] = ()
    """Where the turn ended in a question: the instructions that would have been clear."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Task:
    """What a planner is given; the goal is not among it."""

    scene: Scene
    """Completed by its world."""
    actions: tuple[ActionSignature, ...]
    instruction: Instruction
    options: PlannerOptions
    others: tuple[ActionSignature, ...] = ()
    """What the world could do besides, were it on offer."""
    facts: frozenset[Relation] = frozenset()
    """What is true where the plan begins, of the relations worth telling."""
    history: tuple[Turn, ...] = ()
    """The dialogue so far, oldest first: what "it", "the other one" and "undo" refer to."""
    failed: Turn | None = None
    """The try that this plan replaces: its steps up to the failure are done already."""
    rehearsal: Callable[[], World] | None = field(default=None, compare=False, repr=False)
    """Opens a perfect executor that stands where the plan begins."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Draft:
    """What came of it, unparsed; everything of it is stored."""

    prompt: str
    completion: Completion
    program: str
    """The text of the whole function, ready to be parsed."""
    confidence: float | None = None
    """How sure the planner is, 0 to 1, where it can tell."""


Report = Callable[[PlanningEvent], bool]
"""Takes each event as it happens; True asks the planner to stop (it raises ``Cancelled``)."""


class Planner(Protocol):
    """One way of getting from a sentence to a program."""

    model: str
    """Name of the model it does best with; what ``default`` stands for."""
    repairs: bool
    """Whether its programs are repaired where nobody says whether they should be."""

    def write_program(self, task: Task, model: LanguageModel, report: Report) -> Draft:
        """Ask the model for the program of this task.

        Raises:
            ModelError: the model could not be asked, or gave nothing usable.
            TaskDeclined: there is no right plan; the reason is for a person to read.
            Cancelled: ``report`` asked for it.
        """
        ...


@runtime_checkable
class Preambled(Protocol):
    """A planner whose prompts begin alike, so that a model can have read that beforehand."""

    def preamble(self, world: str, actions: Sequence[ActionSignature]) -> str:
        """What its prompts begin with as long as nobody asks for other switches."""
        ...


@runtime_checkable
class Prepared(Protocol):
    """A planner that knows much, so that a worker can have it read that beforehand."""

    def prepare(self) -> None:
        """Read what the first plan would have to wait for."""
        ...
