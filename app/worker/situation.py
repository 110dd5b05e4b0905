"""Situation: what a planner is told of a stored plan, and the state it begins in."""

from dataclasses import dataclass, fields
from typing import Any

from sqlalchemy.orm import Session

from app.domain.condition import Relation
from app.domain.instruction import Instruction
from app.domain.planner import PlannerOptions, Task, Turn
from app.domain.scene import Scene
from app.domain.world import World
from app.programs.conditions import parse_condition
from app.rollout import offered
from app.storage import dialogue, executions
from app.storage.documents import read_scene
from app.storage.plans import PlanRow
from app.takeover import state_after
from app.worlds import worlds


@dataclass(frozen=True, slots=True, kw_only=True)
class Situation:
    """A task, and the world as it stands where the plan begins."""

    task: Task
    state: bytes | None
    """What the execution before it left; None for the scene as described."""
    seed: int

    def rehearsal(self) -> World:
        """A perfect executor that stands where the plan begins."""
        scene = self.task.scene
        return worlds[scene.world].open_perfect(scene, self.seed, self.state)


def situation_of(session: Session, row: PlanRow) -> Situation:
    """Put together what has been stored."""
    scene = read_scene(row.scene)
    before = dialogue.beginning(session, row)
    state = state_after(session, before) if before else None
    actions = offered(worlds[scene.world], scene)
    task = Task(
        scene=scene,
        actions=actions,
        others=tuple(each for each in worlds[scene.world].actions if each not in actions),
        instruction=Instruction(row.instruction),
        options=_options(row),
        facts=_facts(session, before, scene, row.seed, state),
        history=tuple(_turn(turn) for turn in dialogue.turns(session, row)),
        failed=_failed(row),
    )
    return Situation(task=task, state=state, seed=row.seed)


def _options(row: PlanRow) -> PlannerOptions:
    switches = {field.name for field in fields(PlannerOptions)}
    given: dict[str, Any] = {name: value for name, value in row.planner.items() if name in switches}
    return PlannerOptions(**{**given, "seed": row.seed})


def _facts(
    session: Session, before: str | None, scene: Scene, seed: int, state: bytes | None
) -> frozenset[Relation]:
    final = executions.get(session, before).final_state if before else None
    if final is None:
        return worlds[scene.world].open_perfect(scene, seed, state).facts()
    conditions = (parse_condition(text) for text in final)
    return frozenset(fact for fact in conditions if isinstance(fact, Relation))


def _turn(row: PlanRow) -> Turn:
    declined = row.declined or {}
    return Turn(
        instruction=row.instruction,
        program=row.program or "",
        outcome=declined.get("question") or row.error or "",
        choices=tuple(declined.get("choices") or ()),
    )


def _failed(row: PlanRow) -> Turn | None:
    if not row.tries:
        return None
    last = row.tries[-1]
    return Turn(instruction=row.instruction, program=last["program"], outcome=last["outcome"])
