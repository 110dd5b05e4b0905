"""Every error this project raises, one class per fact.

ProgPromptError
├── Refused                 what was asked for cannot be taken; says which field and what would do
│   ├── SceneRefused        the scene is malformed, overfull, overlapping or out of reach
│   ├── InstructionRefused  the instruction is empty, too long or not text
│   ├── ProgramRefused      the program is outside the plan language
│   ├── GoalRefused         a goal condition is malformed or names what is not there
│   ├── AssetRefused        the mesh is unreadable, too large, or not the size of a thing on a table
│   └── UnknownName         no world, planner, model, action, kind … of that name
├── NotThere                nothing is stored under this id
├── Conflict                the resource is in a state that does not allow this
├── Busy                    the service has its hands full; says after how long to ask again
├── ModelError              a language model could not be asked
│   ├── ModelUnavailable    no weights, no key, no connection
│   └── CompletionFailed    asked, but what came back is unusable
├── TaskDeclined            there is no right plan: absent, impossible, ambiguous or hazardous
├── ActionFailure           a step of a plan did not succeed; carries stage and reason
└── Cancelled               somebody asked for the work to stop
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

from app.domain.llm import Completion
from app.domain.pose import Pose
from app.domain.program import ActionCall


class ProgPromptError(Exception):
    """The base of all of them."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Fault:
    """One thing that is wrong with what was asked for."""

    field: str
    """Where it is wrong, as a dotted path from the root of the request: ``scene.objects.3.name``."""
    message: str
    """What is wrong and what would have worked."""


class Refused(ProgPromptError):
    """What was asked for cannot be taken; every fault found is listed, not only the first."""

    def __init__(self, *faults: Fault) -> None:
        self.faults = faults
        super().__init__("; ".join(f"{fault.field}: {fault.message}" for fault in faults))


class SceneRefused(Refused):
    """The scene is malformed, overfull, overlapping or out of reach."""


class InstructionRefused(Refused):
    """The instruction is empty, too long or not text."""


class ProgramRefused(Refused):
    """The program is outside the plan language."""


class GoalRefused(Refused):
    """A goal condition is malformed, or names what is not in the scene."""


class AssetRefused(Refused):
    """A client's mesh is unreadable, too large, or not the size of a thing on a table."""


class UnknownName(Refused):
    """There is nothing of this name; the message lists what there is."""

    def __init__(self, noun: str, name: str, known: Iterable[str], *, field: str = "") -> None:
        self.name = name
        available = ", ".join(sorted(known)) or "none"
        message = f"there is no {noun} {name!r}; available: {available}"
        super().__init__(Fault(field=field or noun, message=message))


class NotThere(ProgPromptError):
    """Nothing is stored under this id."""

    def __init__(self, noun: str, identifier: str) -> None:
        super().__init__(f"there is no {noun} {identifier!r}")


class Conflict(ProgPromptError):
    """The resource is in a state that does not allow this."""


class Busy(ProgPromptError):
    """The service has its hands full with others' requests; the same one may be taken later."""

    def __init__(self, message: str, *, retry_after: int) -> None:
        self.retry_after = retry_after
        """How long to wait before asking again [s]."""
        super().__init__(message)


class ModelError(ProgPromptError):
    """A language model could not be asked, or gave nothing usable."""


class ModelUnavailable(ModelError):
    """No weights, no key, no connection; the message says what to do."""


class CompletionFailed(ModelError):
    """The model was asked, but what came back is unusable; it is kept as far as it came."""

    def __init__(
        self, message: str, *, prompt: str | None = None, completion: Completion | None = None
    ) -> None:
        self.prompt = prompt
        self.completion = completion
        super().__init__(message)


class TaskDeclined(ProgPromptError):
    """A planner will not plan this; nothing is moved.

    ``kind`` is why: an object is ``absent``, a relation ``impossible``, the wording ``ambiguous``, the
    request ``hazardous``, or the planner ``unsure``. ``question`` asks back, ``choices`` are the
    instructions that would have been clear. What the model was asked and wrote is kept, if it was.
    """

    def __init__(
        self,
        reason: str,
        *,
        kind: Literal["absent", "impossible", "ambiguous", "hazardous", "unsure"],
        question: str | None = None,
        choices: tuple[str, ...] = (),
        prompt: str | None = None,
        completion: Completion | None = None,
    ) -> None:
        self.reason = reason
        self.kind = kind
        self.question = question
        self.choices = choices
        self.prompt = prompt
        self.completion = completion
        super().__init__(reason)


class ActionFailure(ProgPromptError):
    """A step of a plan did not succeed in its world."""

    def __init__(
        self,
        stage: str,
        reason: str,
        *,
        remedy: tuple[ActionCall, ...] = (),
        pose: Pose | None = None,
        needless: bool = False,
    ) -> None:
        self.stage = stage
        self.reason = reason
        self.remedy = remedy
        """Calls that would bring about the precondition that is missing, where there are any."""
        self.pose = pose
        """The gripper's, between the finger tips, where it could not come to."""
        self.needless = needless
        """What the step would bring about holds already."""
        super().__init__(f"{stage}: {reason}")


class Cancelled(ProgPromptError):
    """Somebody asked for the work to stop."""
