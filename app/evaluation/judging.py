"""Judging: whether an execution reached the goal, in the right order, and disturbed nothing else."""

from collections.abc import Iterable
from dataclasses import replace

from app.domain.condition import Condition, Relation, decide, relations
from app.domain.errors import ProgPromptError
from app.domain.goal import Goal
from app.domain.plan import Plan
from app.domain.program import literal
from app.domain.trace import (
    ActionFailed,
    ActionPerformed,
    ActionStarted,
    CallSkipped,
    Checkpoint,
    ExecutionEvent,
    Happening,
    Trace,
)
from app.domain.world import World
from app.evaluation.results import Judged
from app.evaluation.tasks import SuiteTask
from app.execution.assertion import StateCheck
from app.programs.conditions import parse_condition, print_condition
from app.rollout import carry_out, collect, score, understand
from app.worlds import worlds
from app.worlds.simulators.symbolic import SymbolicWorld

ATTENDANT = frozenset({"character"})
"""Where the one who acts is and what it holds is no side effect."""


class Witness:
    """Carries plans out in one world, one after the other, and watches."""

    def __init__(
        self, task: SuiteTask, world: World, movable: frozenset[str], decider: StateCheck | None
    ) -> None:
        self._task = task
        self._world = world
        self._movable = movable
        self._decider = decider
        self._before = world.facts()
        self._goal = task.conditions
        self._order = tuple(map(parse_condition, task.order))
        self._always = tuple(map(parse_condition, task.always))
        self._first: dict[Condition, int] = {}
        self._broken: set[Condition] = set()
        self._held = 0
        self._steps = 0
        self.events: list[ExecutionEvent] = []

    def carry_out(self, plan: Plan) -> list[ExecutionEvent]:
        """Run a plan from where the last one ended; what happened in this one."""
        events: list[ExecutionEvent] = []
        note = collect(events)

        def record(happening: Happening) -> None:
            note(happening)
            if isinstance(happening, Checkpoint):
                self._look()

        self._look()
        carry_out(plan, Goal(self._goal), self._world, record, decider=self._decider)
        self.events += events
        return events

    def judged(self, events: list[ExecutionEvent]) -> Judged:
        """The verdict on everything that was carried out; ``events`` are those of the last plan."""
        late = self._late()
        unmet = [*(c for c in self._goal if not self._holds(c)), *late]
        changed = tuple(sorted(map(print_condition, self._spoilt())))
        success = not unmet and (bool(self._goal) or not changed)
        scores = score(Trace(events=tuple(self._scored(events))))
        scores["sr"] = float(success)
        if not self._goal:
            scores["gcr"] = scores["sr"]
        scores["core_gcr"] = self._core()
        return Judged(
            scores=scores,
            success=success,
            strict=success and not changed,
            unmet=tuple(map(print_condition, unmet)),
            changed=changed,
            performed=_performed(self.events),
            problems=_problems(self.events),
        )

    def _scored(self, events: list[ExecutionEvent]) -> Iterable[ExecutionEvent]:
        """All actions, and the facts and goal conditions of the very start and the very end."""
        if len(events) == len(self.events):
            return events
        kinds = (ActionPerformed, ActionFailed, CallSkipped)
        earlier = self.events[: len(self.events) - len(events)]
        return [*earlier[:1], *(e for e in earlier if isinstance(e, kinds)), *events[1:]]

    def _look(self) -> None:
        self._steps += 1
        for condition in self._order:
            if condition not in self._first and self._holds(condition):
                self._first[condition] = self._steps
        self._broken |= {each for each in self._always if not self._holds(each)}
        met = all(map(self._holds, self._goal))
        self._held = self._held + 1 if met else 0

    def _holds(self, condition: Condition) -> bool:
        return decide(condition, self._world.holds)

    def _late(self) -> list[Condition]:
        """What came in the wrong order, did not last or was broken on the way."""
        found: list[Condition] = []
        times = [self._first.get(condition) for condition in self._order]
        for place, condition in enumerate(self._order[1:], start=1):
            before, now = times[place - 1], times[place]
            if before is None or now is None or now <= before:
                found.append(condition)
        found += self._broken
        if self._task.hold > self._held:
            found += [each for each in self._goal if each not in found]
        return found

    def _spoilt(self) -> frozenset[Relation]:
        """Facts that are new or gone about what was to be left alone."""
        changed = self._before ^ self._world.facts()
        return frozenset(fact for fact in changed if not _free(fact, self._movable))

    def _core(self) -> float:
        core = self._task.core_goal
        if core is None:
            core = self._task.goal
        met = [self._holds(parse_condition(text)) for text in core]
        return sum(met) / len(met) if met else float(not self._spoilt())


def movable(task: SuiteTask, world: World) -> frozenset[str]:
    """What may change: what the goal speaks of first, and what the ground truth changes.

    In a symbolic home also whatever the ground truth handles.

    ``world`` stands at the start of the task and is left as it was.
    """
    named = {
        relation.arguments[0]
        for condition in task.conditions
        for relation in relations(condition)
        if relation.arguments
    }
    before, state = world.facts(), world.save()
    description = worlds[world.scene.world]
    try:
        _, plan = understand(task.program, world.scene, description)
        carry_out(plan, Goal(), world, lambda _: None)
        touched = {fact.arguments[0] for fact in before ^ world.facts() if fact.arguments}
        if is_certain(world):  # a cupboard it opens and closes may stay open
            touched |= {str(each) for call in plan.calls for each in call.arguments}
    except ProgPromptError:
        touched = set()
    world.restore(state)
    return frozenset(named | touched | set(task.may_change))


def is_certain(perfect: World) -> bool:
    """Whether a perfect executor is its world itself, and no stand-in that knows facts only."""
    return not isinstance(perfect, SymbolicWorld)


def without_goal(judged: Judged) -> Judged:
    """The same, unsuccessful: no plan was there to be judged."""
    return replace(judged, success=False, strict=False, scores={**judged.scores, "sr": 0.0})


def _free(fact: Relation, movable: frozenset[str]) -> bool:
    return not fact.arguments or fact.arguments[0] in movable | ATTENDANT


def _performed(events: list[ExecutionEvent]) -> tuple[str, ...]:
    begun = ""
    found: list[str] = []
    for event in events:
        if isinstance(event, ActionStarted):
            begun = f"{event.action}({', '.join(map(literal, event.arguments))})"
        elif isinstance(event, ActionPerformed):
            found.append(begun)
    return tuple(found)


def _problems(events: list[ExecutionEvent]) -> tuple[str, ...]:
    return tuple(
        f"line {e.line}, grounding: {e.text}: {e.reason}"
        if isinstance(e, CallSkipped)
        else f"line {e.line}, {e.stage}: {e.reason}"
        for e in events
        if isinstance(e, ActionFailed | CallSkipped)
    )
