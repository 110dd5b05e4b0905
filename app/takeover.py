"""Takeover: which steps an execution runs, and the state in which it finds its world."""

from sqlalchemy.orm import Session

from app.domain.plan import Jump, Plan
from app.rollout import understand
from app.storage import checkpoints, executions
from app.storage.documents import read_scene
from app.storage.executions import ExecutionRow
from app.worlds import worlds


def steps_of(row: ExecutionRow) -> Plan:
    """The steps of its program, but for those before the line at which it begins."""
    scene = read_scene(row.scene)
    _, plan = understand(row.program, scene, worlds[scene.world])
    if row.begins_at_line is None:
        return plan
    return Plan(steps=plan.steps[_index(plan, row.begins_at_line) :])


def state_of(session: Session, row: ExecutionRow) -> bytes | None:
    """The state at its next step; None where that is the scene as described."""
    if row.next_step:
        return checkpoints.before(session, row.id, row.next_step)
    if row.begins_after is None:
        return None
    other = executions.get(session, row.begins_after)
    if row.begins_at_line is None:
        return state_after(session, other.id)
    return _state_before(session, other, _index(steps_of(other), row.begins_at_line))


def state_after(session: Session, execution_id: str) -> bytes | None:
    """The state at the end of an execution; None where that is the scene as described."""
    return _state_before(session, executions.get(session, execution_id), checkpoints.END)


def _state_before(session: Session, row: ExecutionRow, step: int) -> bytes | None:
    """The state before a step of an execution; one that kept none left what it had taken over."""
    found = checkpoints.before(session, row.id, step)
    return state_of(session, _at_its_start(row)) if found is None else found


def _index(plan: Plan, line: int) -> int:
    steps = enumerate(plan.steps)
    reached = (place for place, step in steps if not isinstance(step, Jump) and step.line >= line)
    return next(reached, len(plan.steps))


def _at_its_start(row: ExecutionRow) -> ExecutionRow:
    return ExecutionRow(
        id=row.id,
        begins_after=row.begins_after,
        begins_at_line=row.begins_at_line,
        next_step=0,
    )
