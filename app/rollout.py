"""The paper in short functions: plan, understand, rehearse, carry out, score.

Nothing is stored here; whoever calls is told of every event as it happens.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

from app.domain.action import ActionSignature
from app.domain.errors import UnknownName
from app.domain.goal import Goal
from app.domain.llm import LanguageModel
from app.domain.plan import Plan
from app.domain.planner import Draft, Planner, Report, Task
from app.domain.program import Program
from app.domain.scene import Scene
from app.domain.trace import Checkpoint, ExecutionEvent, Happening, Tick, Trace
from app.domain.world import World, WorldDescription
from app.execution.assertion import StateCheck
from app.execution.interpreter import execute
from app.execution.repair import repair
from app.programs.grounding import ground
from app.programs.parser import parse_program
from app.programs.printer import print_program
from app.scores import scores
from app.worlds import worlds

Scores = dict[str, float | None]
Record = Callable[[Happening], None]
OpenPerfect = Callable[[], World]
"""Opens a perfect executor that stands where the plan begins."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Planned:
    """What a planner wrote, understood and, where that was asked for, repaired."""

    draft: Draft
    text: str
    """The whole function that is to run."""
    program: Program
    plan: Plan


def plan_task(
    task: Task, planner: Planner, model: LanguageModel, rehearsal: OpenPerfect, report: Report
) -> Planned:
    """Have the planner write the program, and understand it.

    Raises:
        ModelError: the model could not be asked, or gave nothing usable.
        TaskDeclined: there is no right plan.
        ProgramRefused: what was written is outside the plan language.
        Cancelled: ``report`` asked for it.
    """
    world = worlds[task.scene.world]
    draft = planner.write_program(replace(task, rehearsal=rehearsal), model, report)
    text = draft.program
    program, plan = understand(text, task.scene, world)
    if planner.repairs if task.options.repair is None else task.options.repair:
        mended = repair(
            program,
            task.scene,
            rehearsal(),
            lambda some: ground(some, task.scene, task.actions, world.relations),
            shuts=task.scene.agent is not None,  # Who acts in a home leaves no fridge open.
        )
        if mended.program is not program:
            text = print_program(mended.program)
            program, plan = understand(text, task.scene, world)
    return Planned(draft=draft, text=text, program=program, plan=plan)


def understand(text: str, scene: Scene, world: WorldDescription) -> tuple[Program, Plan]:
    """Parse a program and ground it in its scene.

    Raises:
        ProgramRefused: it is outside the plan language; the fault names the line.
        UnknownName: the scene offers an action the world has not.
    """
    program = parse_program(text)
    return program, ground(program, scene, offered(world, scene), world.relations)


def carry_out(
    plan: Plan,
    goal: Goal,
    world: World,
    record: Record,
    *,
    start: int = 0,
    decider: StateCheck | None = None,
) -> None:
    """Run the plan from its step ``start`` on, and read the goal conditions from the world."""
    for happening in execute(plan, world, start=start, goal=goal, decider=decider):
        record(happening)


def rehearse(
    plan: Plan,
    goal: Goal,
    world: WorldDescription,
    scene: Scene,
    seed: int,
    *,
    state: bytes | None = None,
) -> Scores:
    """The scores the plan would get if no action ever slipped, from the scene or a saved state."""
    events: list[ExecutionEvent] = []
    carry_out(plan, goal, world.open_perfect(scene, seed, state), collect(events))
    return score(Trace(events=tuple(events)))


def score(trace: Trace) -> Scores:
    """Every score by its name."""
    return {name: scorer(trace) for name, scorer in scores.items()}


def offered(world: WorldDescription, scene: Scene) -> tuple[ActionSignature, ...]:
    """The action primitives on offer: those the scene names, or the world's default ones.

    Raises:
        UnknownName: the scene names one that the world has not.
    """
    if scene.actions is None:
        return tuple(action for action in world.actions if action.name in world.default_actions)
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
