"""What if: an execution of a plan with its seed, its program or its beginning changed."""

from sqlalchemy.orm import Session

from app.api.schemas.plans import ExecutionGiven
from app.api.submission import complete_scene, flawless
from app.domain.errors import Conflict, Fault, NotThere, Refused
from app.storage import executions
from app.storage.base import new_id, now
from app.storage.documents import read_scene, scene_document
from app.storage.executions import ExecutionRow
from app.storage.handover import execution_of
from app.storage.plans import PlanRow
from app.worlds import worlds


def changed_execution(session: Session, plan: PlanRow, given: ExecutionGiven) -> ExecutionRow:
    """The execution that is asked for; not stored yet.

    Raises:
        Refused: the program cannot be used, the execution to begin after is not the plan's, or the
            line is not in the program.
        Conflict: another seed would place the objects anew, but the plan goes on from a state.
    """
    row = execution_of(session, plan)
    if given.after is not None:
        other = _of_plan(session, plan, given.after)
        row.begins_after, row.begins_at_line = other.id, given.line
        row.scene, row.program = other.scene, other.program
        row.seed = other.seed if given.seed is None else given.seed
    elif given.seed is not None and given.seed != plan.seed:
        if row.begins_after is not None:
            raise Conflict("the plan goes on from where another left off; its seed is given")
        row.seed = given.seed
        row.scene = scene_document(complete_scene(read_scene(plan.given_scene), given.seed))
    if given.program is not None:
        scene = read_scene(row.scene)
        flawless(given.program, scene, worlds[scene.world])
        row.program = given.program
    _within(row.program, given.line)
    row.what_if = given.after is not None or (row.seed, row.program) != (plan.seed, plan.program)
    return row


def repeated(row: ExecutionRow) -> ExecutionRow:
    """The same once more, to be compared with; not stored yet."""
    names = (
        "plan_id",
        "seed",
        "scene",
        "program",
        "options",
        "begins_after",
        "begins_at_line",
        "what_if",
    )
    again = {name: getattr(row, name) for name in names}
    return ExecutionRow(
        id=new_id("ex"), created_at=now(), status="queued", rerun_of=row.id, **again
    )


def _within(program: str, line: int | None) -> None:
    lines = len(program.splitlines())
    if line is not None and line > lines:
        message = f"is beyond the program, which ends with line {lines}; give 1 to {lines}"
        raise Refused(Fault(field="line", message=message))


def _of_plan(session: Session, plan: PlanRow, execution_id: str) -> ExecutionRow:
    try:
        row = executions.get(session, execution_id)
    except NotThere as error:
        raise Refused(Fault(field="after", message=str(error))) from error
    if row.plan_id != plan.id:
        message = f"{execution_id} is an execution of another plan, {row.plan_id}"
        raise Refused(Fault(field="after", message=message))
    if row.status in executions.UNFINISHED:
        message = f"{execution_id} is {row.status}; another can take over once it has ended"
        raise Refused(Fault(field="after", message=message))
    return row
