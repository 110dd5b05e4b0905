"""Simulation: the workflow that carries a program out in its world and scores it."""

import logging
from collections.abc import Callable
from typing import Any

from app.domain.errors import Cancelled, ProgPromptError
from app.domain.goal import Goal
from app.domain.llm import LanguageModel
from app.domain.perception import Perception
from app.domain.trace import Trace
from app.domain.world import World
from app.execution.assertion import StateCheck, state_check
from app.planners import planners
from app.programs.conditions import parse_condition
from app.rollout import carry_out, score
from app.storage import events, executions, plans
from app.storage.base import now
from app.storage.database import Database
from app.storage.documents import read_scene
from app.storage.executions import ExecutionRow
from app.storage.handover import Handover
from app.storage.plans import PlanRow
from app.takeover import state_of, steps_of
from app.worker.execution_recorder import ExecutionRecorder
from app.worker.outcome import Outcome, outcome
from app.worlds import worlds

MAX_ATTEMPTS = 3
log = logging.getLogger(__name__)


class Simulation:
    """What a worker of the simulation queue does."""

    def __init__(
        self,
        database: Database,
        handover: Handover,
        open_model: Callable[[str, str], LanguageModel],
    ) -> None:
        """A desk; ``open_model`` gets the name a plan asks for, and the one to prefer."""
        self._database = database
        self._handover = handover
        self._open_model = open_model

    def __call__(self, execution_id: str, /) -> None:
        """Carry it out. Whatever goes wrong ends as a failed execution with its reason."""
        taken = self._take(execution_id)
        if taken is None:
            return
        try:
            self._end(execution_id, self._carry_out(*taken))
        except Cancelled:
            self._end(execution_id, Outcome(status="cancelled"))
        except Exception as error:
            self._end(execution_id, Outcome(status="failed", error=_reason(error)))

    def stopping(self, execution_id: str, /) -> None:
        """The worker stops in good order in the middle of this execution: not its fault."""
        with self._database.transaction() as session:
            executions.change(
                session, execution_id, when=("executing",), attempts=ExecutionRow.attempts - 1
            )

    def _take(self, execution_id: str) -> tuple[ExecutionRow, PlanRow] | None:
        with self._database.transaction() as session:
            taken = executions.change(
                session,
                execution_id,
                when=executions.UNFINISHED,
                status="executing",
                attempts=ExecutionRow.attempts + 1,
            )
            row = executions.get(session, execution_id)
            row.started_at = row.started_at or now()
            return (row, plans.get(session, row.plan_id)) if taken else None

    def _carry_out(self, row: ExecutionRow, asked: PlanRow) -> Outcome:
        if row.attempts > MAX_ATTEMPTS:
            raise ProgPromptError(
                f"the execution was given up: its worker died {MAX_ATTEMPTS} times at this step"
            )
        plan, world = steps_of(row), self._standing(row)
        goal = Goal(tuple(parse_condition(text) for text in asked.goal))
        recorder = ExecutionRecorder(self._database, row, world)
        decider = self._decider(row, asked)
        carry_out(plan, goal, world, recorder.record, start=row.next_step, decider=decider)
        recorder.end()
        with self._database.reading() as session:
            trace = Trace(events=tuple(events.of_execution(session, row.id)))
        return outcome(trace.events, score(trace))

    def _standing(self, row: ExecutionRow) -> World:
        """Its world, as it finds it."""
        scene = read_scene(row.scene)
        perception = Perception(**row.options.get("perception", {}))
        world = worlds[scene.world].open(scene, row.seed, perception)
        with self._database.reading() as session:
            state = state_of(session, row)
        if state is not None:
            world.restore(state)
            if row.next_step == 0:
                world.begin()
        return world

    def _decider(self, row: ExecutionRow, asked: PlanRow) -> StateCheck:
        """Who decides assertions; the model is loaded only where it is asked."""
        who = row.options.get("state_check", "world")
        if who == "world":
            return state_check(who)
        name = asked.planner.get("model", "default")
        return state_check(who, self._open_model(name, planners["progprompt"].model))

    def _end(self, execution_id: str, ended: Outcome) -> None:
        values: dict[str, Any] = {
            name: getattr(ended, name)
            for name in ("status", "error", "failure", "scores", "final_state")
        }
        with self._database.transaction() as session:
            row = executions.get(session, execution_id)
            # The plan before its executions, as everywhere: who locks them the other way round
            # and whoever cancels the plan meanwhile would wait for each other.
            plan = plans.get(session, row.plan_id, lock=True)
            if row.rerun_of is not None and ended.status != "cancelled":
                values["identical"] = events.same(session, execution_id, row.rerun_of)
            executions.change(
                session, execution_id, when=("executing",), finished_at=now(), **values
            )
            if ended.observed and self._handover.may_replan(plan, row):
                self._handover.replan(session, plan, execution_id, ended.observed)
            else:
                self._handover.executed(session, plan, row, status=ended.status, error=ended.error)


def _reason(error: Exception) -> str:
    if isinstance(error, ProgPromptError):
        return str(error)
    log.exception("an execution failed unexpectedly")
    return f"unexpected {type(error).__name__}: {error}"
