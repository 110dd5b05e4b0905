"""The paper's four robot tasks with growing numbers of distractors (its Table IV)."""

from collections.abc import Callable
from dataclasses import dataclass

from app.domain.goal import Goal
from app.domain.instruction import Instruction
from app.domain.llm import LanguageModel
from app.domain.perception import Perception
from app.domain.planner import PlannerOptions, Task
from app.domain.trace import ExecutionEvent, Trace
from app.evaluation.intervals import wilson
from app.evaluation.pick import CAMERAS
from app.evaluation.suites import find_suite
from app.evaluation.tasks import SuiteTask
from app.planners import planners
from app.rollout import Scores, carry_out, collect, offered, rehearse, score, understand
from app.worlds.tabletop import Tabletop


@dataclass(frozen=True, slots=True, kw_only=True)
class RobotRow:
    """What came of it: means over the layouts, in [0, 1]."""

    instruction: str
    distractors: int
    layouts: int
    sr: float
    sr_interval: tuple[float, float]
    """Wilson's, at 95 %."""
    plan_sr: float
    gcr: float
    exec: float
    precision: float
    program: str
    plan_seconds: float
    """Wall time of the completion [s]."""


def robot_tasks() -> tuple[SuiteTask, ...]:
    """Every task with 0 to all of its distractors."""
    return find_suite("robot-tasks").tasks


def run_robot_task(
    task: SuiteTask,
    model: LanguageModel,
    layouts: int,
    perception: Perception = CAMERAS,
    on_layout: Callable[[Scores], None] = lambda _: None,
) -> RobotRow:
    """Plan the task once and carry it out on layouts 0, 1, 2 … of its objects.

    Raises:
        ModelError: the model could not be asked, or gave nothing usable.
    """
    world = Tabletop()
    scene, goal = task.scene, Goal(task.conditions)
    asked = Task(
        scene=world.complete(scene, 0),
        actions=offered(world, scene),
        instruction=Instruction(task.instruction),
        options=PlannerOptions(),
    )
    draft = planners["progprompt"].write_program(asked, model, lambda _: False)
    _, plan = understand(draft.program, asked.scene, world)
    rollouts: list[Scores] = []
    for seed in range(layouts):
        events: list[ExecutionEvent] = []
        carry_out(plan, goal, world.open(scene, seed, perception), collect(events))
        rollouts.append(score(Trace(events=tuple(events))))
        on_layout(rollouts[-1])
    return RobotRow(
        instruction=task.instruction,
        distractors=len(task.distractors),
        layouts=layouts,
        sr=_mean(rollouts, "sr"),
        sr_interval=wilson(sum(each["sr"] == 1 for each in rollouts), layouts),
        plan_sr=rehearse(plan, goal, world, scene, 0)["sr"] or 0.0,
        gcr=_mean(rollouts, "gcr"),
        exec=_mean(rollouts, "exec"),
        precision=_mean(rollouts, "precision"),
        program=draft.program,
        plan_seconds=draft.completion.seconds,
    )


def _mean(rollouts: list[Scores], name: str) -> float:
    return sum(each[name] or 0.0 for each in rollouts) / max(1, len(rollouts))
