"""The paper's four robot tasks with growing numbers of distractors (its Table IV)."""

import json
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from app.domain.goal import Goal
from app.domain.instruction import Instruction
from app.domain.llm import LanguageModel
from app.domain.perception import Perception
from app.domain.planner import PlannerOptions, Task
from app.domain.scene import Scene, SceneObject
from app.domain.trace import ExecutionEvent, Trace
from app.evaluation.intervals import wilson
from app.evaluation.pick import CAMERAS
from app.planners import planners
from app.programs.conditions import parse_condition
from app.rollout import Scores, carry_out, collect, offered, rehearse, score, understand
from app.worlds.tabletop import Tabletop

SUITE = Path(__file__).resolve().parents[2] / "static" / "suites" / "robot-tasks.json"


@dataclass(frozen=True, slots=True, kw_only=True)
class RobotTask:
    """One row of the table: a task with so many distractors, planned once."""

    instruction: str
    objects: tuple[str, ...]
    """Distractors last."""
    distractors: int
    goal: tuple[str, ...]


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


def robot_tasks() -> Iterator[RobotTask]:
    """Every task with 0 to all of its distractors."""
    for entry in json.loads(SUITE.read_text(encoding="utf-8")):
        for count in range(len(entry["distractors"]) + 1):
            yield RobotTask(
                instruction=entry["instruction"],
                objects=(*entry["objects"], *entry["distractors"][:count]),
                distractors=count,
                goal=tuple(entry["goal"]),
            )


def run_robot_task(
    task: RobotTask,
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
    scene = Scene(world=world.name, objects=tuple(SceneObject(name=n) for n in task.objects))
    goal = Goal(tuple(parse_condition(text) for text in task.goal))
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
        distractors=task.distractors,
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
