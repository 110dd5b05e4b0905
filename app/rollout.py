"""What becomes of a program a planner wrote: understand it, rehearse it, carry it out, score it.

Nothing is stored here; whoever calls is told of every event as it happens.
"""

from collections.abc import Callable

from app.domain.action import ActionSignature
from app.domain.errors import UnknownName
from app.domain.goal import Goal
from app.domain.plan import Plan
from app.domain.program import Program
from app.domain.scene import Scene
from app.domain.trace import Checkpoint, ExecutionEvent, Happening, Tick, Trace
from app.domain.world import World, WorldDescription
from app.execution.interpreter import execute
from app.programs.grounding import ground
from app.programs.parser import parse_program
from app.scores import scores

Scores = dict[str, float | None]
Record = Callable[[Happening], None]


def understand(text: str, scene: Scene, world: WorldDescription) -> tuple[Program, Plan]:
    """Parse a program and ground it in its scene.

    Raises:
        ProgramRefused: it is outside the plan language; the fault names the line.
        UnknownName: the scene offers an action the world has not.
    """
    program = parse_program(text)
    return program, ground(program, scene, offered(world, scene), world.relations)


def carry_out(plan: Plan, goal: Goal, world: World, record: Record, *, start: int = 0) -> None:
    """Run the plan from its step ``start`` on, and read the goal conditions from the world."""
    for happening in execute(plan, world, start=start, goal=goal):
        record(happening)


def rehearse(plan: Plan, goal: Goal, world: WorldDescription, scene: Scene, seed: int) -> Scores:
    """The scores the plan would get if no action ever slipped."""
    events: list[ExecutionEvent] = []
    carry_out(plan, goal, world.open_perfect(scene, seed), collect(events))
    return score(Trace(events=tuple(events)))


def score(trace: Trace) -> Scores:
    """Every score by its name."""
    return {name: scorer(trace) for name, scorer in scores.items()}


def offered(world: WorldDescription, scene: Scene) -> tuple[ActionSignature, ...]:
    """The action primitives on offer: all of the world's, or those the scene names.

    Raises:
        UnknownName: the scene names one that the world has not.
    """
    if scene.actions is None:
        return world.actions
    known = {action.name: action for action in world.actions}
    for index, name in enumerate(scene.actions):
        if name not in known:
            raise UnknownName("action", name, known, field=f"scene.actions.{index}")
    return tuple(action for action in world.actions if action.name in scene.actions)


def collect(events: list[ExecutionEvent]) -> Record:
    """Records what happens as events at the end of the list."""

    def record(happening: Happening) -> None:
        if not isinstance(happening, Checkpoint | Tick):
            events.append(happening)

    return record


def _ignore(_event: object) -> bool:
    return False
