"""A plan tried where nothing slips: what a step's missing precondition calls for is put before it.

What is so already need not be done: such a step is left out. An assertion whose recovery fails is
written out as the calls of it that can be made.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar, assert_never

from app.domain.condition import decide
from app.domain.errors import ActionFailure
from app.domain.plan import Call, GroundedAssertion, GroundedBranch, GroundedCall, Plan, Step
from app.domain.program import (
    ActionCall,
    Assertion,
    Branch,
    Comment,
    Loop,
    Pass,
    Program,
    Statement,
)
from app.domain.scene import Scene
from app.domain.world import World
from app.programs.unrolling import unroll

MAX_ADDED = 20
"""Calls put into one plan."""
MAX_DEPTH = 4
"""Remedies of remedies."""
MAX_MISSING = 4
"""Preconditions of one call that are brought about one after the other."""

WALKING = ("find", "walk")
"""Calls that only bring somebody somewhere."""
Ground = Callable[[Program], Plan]
_T = TypeVar("_T")


@dataclass(frozen=True, slots=True, kw_only=True)
class Repair:
    """A program with what it lacked."""

    program: Program
    """The program itself where nothing was amiss; else with its loops and helpers written out."""
    added: tuple[ActionCall, ...] = ()
    """The calls that were put in, in order."""
    dropped: tuple[ActionCall, ...] = ()
    """The calls that were left out, in order."""


def repair(
    program: Program, scene: Scene, perfect: World, ground: Ground, *, shuts: bool = False
) -> Repair:
    """Run the program on a perfect executor, and put in what its steps lack.

    Where a step fails for a precondition whose remedy the world knows, the remedy's calls are put
    before it, under a comment with the reason. A step that no remedy helps stays as it is, unless
    it is needless.

    Args:
        program: as it was parsed.
        scene: which it is to be carried out in.
        perfect: the scene in the perfect executor, where the program begins; it is used up.
        ground: grounds a program in the scene.
        shuts: whether what a remedy opened is closed again once the next step can do so.

    Raises:
        ProgramRefused: with its loops and helpers written out the program is too long.
    """
    repairing = _Repairing(perfect, ground, shuts=shuts)
    body = tuple(repairing.walk(unroll(program, scene)))
    if not repairing.changed:
        return Repair(program=program)
    return Repair(
        program=replace(program, helpers=(), body=body),
        added=tuple(repairing.added),
        dropped=tuple(repairing.dropped),
    )


class _Repairing:
    def __init__(self, world: World, ground: Ground, *, shuts: bool) -> None:
        self._world = world
        self._shuts = shuts
        self._opened: list[ActionCall] = []
        """Remedies that opened something, which is open still."""
        self._ground = ground
        self.added: list[ActionCall] = []
        self.dropped: list[ActionCall] = []
        self.changed = False

    def walk(self, statements: Sequence[Statement]) -> list[Statement]:
        """The statements with what they lack; of a branch only the side that is taken is seen to."""
        found: list[Statement] = []
        for place, statement in enumerate(statements, 1):
            match statement:
                case ActionCall():
                    found += self._see_to(statement)
                case Assertion():
                    found += self._recover(statement)
                case Branch():
                    found.append(self._side(statement))
                case Comment() | Pass():
                    found.append(statement)
                case Loop():
                    raise AssertionError("loops are unrolled before they are repaired")
                case _:
                    assert_never(statement)
            found += self._shut(statements[place:])
        silent = all(isinstance(each, Comment) for each in found)
        return [*found, Pass()] if silent and statements else found

    def _shut(self, coming: Sequence[Statement]) -> list[Statement]:
        """Closes what remedies opened, unless the next step takes it open."""
        found: list[Statement] = []
        for opening in tuple(self._opened):
            before, call = self._world.save(), replace(opening, action="close")
            step = self._step(call)
            possible = isinstance(step, GroundedCall) and not self._perform(step)
            if possible and self._takes(opening, coming):
                self._world.restore(before)
                continue
            self._opened.remove(opening)
            if possible:
                self.added.append(call)
                found += [Comment(text="added, for it was closed before", line=call.line), call]
        return found

    def _takes(self, opening: ActionCall, coming: Sequence[Statement]) -> bool:
        """Whether the next step that does more than walk asks for this remedy, as things stand."""
        before = self._world.save()
        try:
            for statement in coming:
                if isinstance(statement, Comment):
                    continue
                step = self._step(statement) if isinstance(statement, ActionCall) else None
                if not isinstance(step, GroundedCall):
                    return False
                if failure := self._perform(step):
                    return opening in failure.remedy
                if step.action not in WALKING:
                    break
            return False
        finally:
            self._world.restore(before)

    def _side(self, branch: Branch) -> Branch:
        step = self._step(branch)
        if not isinstance(step, GroundedBranch):
            return branch
        if decide(step.condition, self._world.holds):
            return replace(branch, body=tuple(self.walk(branch.body)))
        return replace(branch, otherwise=tuple(self.walk(branch.otherwise)))

    def _recover(self, assertion: Assertion) -> list[Statement]:
        """Do what the assertion would have done; where that fails, the calls that can be made."""
        step = self._step(assertion)
        if not isinstance(step, GroundedAssertion):
            return [assertion]
        before = self._world.save()
        if all(self._goes_well(call) for call in self._lacking(step, step.recovery)):
            return [assertion]
        self._world.restore(before)
        self.changed = True
        found: list[Statement] = []
        for call in self._lacking(step, assertion.recovery):
            found += self._if_possible(call)
        return found or [Comment(text="left out, for it cannot be done", line=assertion.line)]

    def _lacking(self, step: GroundedAssertion, recovery: Sequence[_T]) -> Iterator[_T]:
        """The recovery's calls one by one, as long as the condition is false."""
        for call in recovery:
            if decide(step.condition, self._world.holds):
                return
            yield call

    def _goes_well(self, call: Call) -> bool:
        return isinstance(call, GroundedCall) and self._perform(call) is None

    def _see_to(self, call: ActionCall) -> list[Statement]:
        found = self._tried(call)
        return [call] if found is None else found

    def _if_possible(self, call: ActionCall) -> list[Statement]:
        found = self._tried(call)
        if found is None:
            self.dropped.append(call)
        return found or []

    def _tried(self, call: ActionCall) -> list[Statement] | None:
        """The call with what it lacks, done; None, and nothing done, where nothing helps."""
        before, opened = self._world.save(), len(self._opened)
        added, dropped = len(self.added), len(self.dropped)
        found = self._with_remedies(call, MAX_DEPTH)
        if found is None:
            self._world.restore(before)
            del self.added[added:], self.dropped[dropped:], self._opened[opened:]
        elif found != [call]:
            self.changed = True
        return found

    def _with_remedies(self, call: ActionCall, depth: int) -> list[Statement] | None:
        """The call with what has to come before it, done; None where nothing helps.

        Where it is needless, a comment says so in its stead.
        """
        step = self._step(call)
        if not isinstance(step, GroundedCall):
            return None
        found: list[Statement] = []
        for _ in range(MAX_MISSING):
            failure = self._perform(step)
            if failure is None:
                return [*found, call]
            if failure.needless:
                self.dropped.append(call)
                return [*found, Comment(text=f"left out, for {failure.reason}", line=call.line)]
            remedy = self._remedy(failure, depth)
            if remedy is None:
                return None
            found += [Comment(text=f"added, for {failure.reason}", line=call.line), *remedy]
        return None

    def _remedy(self, failure: ActionFailure, depth: int) -> list[Statement] | None:
        if not failure.remedy or not depth or len(self.added) + len(failure.remedy) > MAX_ADDED:
            return None
        done: list[Statement] = []
        for call in failure.remedy:
            found = self._with_remedies(call, depth - 1)
            if found is None:
                return None
            self.added.append(call)
            if self._shuts and call.action == "open":
                self._opened.append(call)
            done += found
        return done

    def _perform(self, call: GroundedCall) -> ActionFailure | None:
        try:
            for _ in self._world.perform(call.action, call.arguments):
                pass
        except ActionFailure as failure:
            return failure
        return None

    def _step(self, statement: Statement) -> Step | None:
        """The statement grounded; None where nothing is left of it."""
        steps = self._ground(Program(name="step", body=(statement,))).steps
        return steps[0] if steps else None
