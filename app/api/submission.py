"""Submission: from a client's request to a stored plan, with every fault found at once."""

import hashlib
from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache
from typing import Any, TypeVar

from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session

from app import takeover
from app.api.parts import Parts
from app.api.schemas.plans import PlanGiven
from app.domain.asset import ASSET
from app.domain.errors import Fault, NotThere, ProgramRefused, Refused, UnknownName
from app.domain.instruction import Instruction
from app.domain.perception import NO_VISION
from app.domain.plan import Plan
from app.domain.program import Program
from app.domain.scene import Scene
from app.domain.trace import ProgramGrounded
from app.domain.world import Reversible, WorldDescription
from app.llm.models import find_model
from app.planners import planners
from app.programs.conditions import parse_goal
from app.rollout import offered, rehearse, understand
from app.storage import dialogue, events, plans, scenes
from app.storage.base import new_id, now
from app.storage.documents import plan_columns, read_scene, scene_document
from app.storage.plans import PlanRow
from app.worlds import worlds

T = TypeVar("T")


def submit(parts: Parts, request: PlanGiven, key: str | None) -> PlanRow:
    """Store the plan that is asked for and hand it on; a repeated request gives the same plan.

    Raises:
        Refused: it cannot be taken; every fault names its field.
    """
    digest = hashlib.sha256(request.model_dump_json().encode()).hexdigest()
    if key is not None and (known := _repeated(parts, key, digest)):
        return known
    row, program = _checked(parts, request)
    row.idempotency_key, row.request_digest = key, digest
    try:
        _store(parts, row, program)
    except IntegrityError:  # The same request came twice at the same time.
        if key is None or (known := _repeated(parts, key, digest)) is None:
            raise
        return known
    return row


def complete_scene(scene: Scene, seed: int) -> Scene:
    """The scene with everything its client left open filled in.

    Raises:
        Refused: it cannot be built, or names a world or an action that is not there.
    """
    # What an asset is may be forgotten meanwhile; all other scenes are complete for good.
    lasting = not any((item.kind or "").startswith(ASSET) for item in scene.objects)
    return (_kept if lasting else _completed)(scene, seed)


def _completed(scene: Scene, seed: int) -> Scene:
    if scene.world not in worlds:
        raise UnknownName("world", scene.world, worlds, field="scene.world")
    world = worlds[scene.world]
    offered(world, scene)
    return world.complete(scene, seed)


_kept = lru_cache(maxsize=128)(_completed)
"""Clients send the same scene with one sentence after another."""


def _repeated(parts: Parts, key: str, digest: str) -> PlanRow | None:
    with parts.database.reading() as session:
        known = plans.with_key(session, key)
    if known is not None and known.request_digest != digest:
        message = f"was used before, for another request (plan {known.id}); take a fresh one"
        raise Refused(Fault(field="Idempotency-Key", message=message))
    return known


def _checked(parts: Parts, request: PlanGiven) -> tuple[PlanRow, Program | None]:
    given = _given_scene(parts, request)
    check = _Faults()
    scene = check(lambda: complete_scene(given, request.seed))
    if request.program is None:
        check(lambda: Instruction(request.instruction or ""))
        check(lambda: _known_planner(request.planner.name))
        check(lambda: _known_model(parts, request.planner.model))
    check(lambda: _visible(parts, request))
    check.raise_if_any()
    assert scene is not None
    world = worlds[scene.world]
    state = None
    if request.parent is not None:
        with parts.database.reading() as session:
            state = _state_after(session, request.parent)
    goal = check(lambda: parse_goal(request.goal, scene, world.relations))
    understood = None
    if request.program is not None:
        text = request.program
        understood = check(lambda: flawless(text, scene, world))
    check.raise_if_any()
    row = PlanRow(
        id=new_id("pl"),
        created_at=now(),
        status="queued",
        instruction=_sentence(request, understood),
        scene_id=request.scene_id,
        parent=request.parent,
        options={"perception": request.perception.model_dump()},
        given_scene=scene_document(given),
        scene=scene_document(scene),
        seed=request.seed,
        execute=request.execute,
        approval=request.approval,
        goal=request.goal,
        planner={} if understood else _options(parts, request, world),
    )
    if understood is not None and goal is not None:
        program, plan = understood
        row.program = request.program
        for name, value in plan_columns(program, plan).items():
            setattr(row, name, value)
        if request.goal:
            row.plan_scores = rehearse(plan, goal, world, scene, request.seed, state=state)
    return row, understood[0] if understood else None


def _visible(parts: Parts, request: PlanGiven) -> None:
    if request.perception.detector == "vision" and not parts.vision:
        raise Refused(Fault(field="perception.detector", message=NO_VISION))


def _store(parts: Parts, row: PlanRow, program: Program | None) -> None:
    with parts.database.transaction() as session:
        session.add(row)
        session.flush()
        if program is None:
            parts.handover.queued(session, row)
        else:
            grounded = ProgramGrounded(steps=len(row.steps), rejected=0)
            events.append(session, row.id, 0, [grounded])
            parts.handover.planned(session, row)


def _given_scene(parts: Parts, request: PlanGiven) -> Scene:
    if request.scene is not None:
        return request.scene.to_domain()
    if request.parent is not None:
        return _scene_of_parent(parts, request.parent)
    with parts.database.reading() as session:
        try:
            return read_scene(scenes.get(session, request.scene_id or "").scene)
        except NotThere as error:
            raise Refused(Fault(field="scene_id", message=str(error))) from error


def _scene_of_parent(parts: Parts, parent: str) -> Scene:
    with parts.database.reading() as session:
        try:
            row = plans.get(session, parent)
        except NotThere as error:
            raise Refused(Fault(field="parent", message=str(error))) from error
    if row.status in plans.UNFINISHED:
        message = f"the plan is {row.status}; a plan can follow once it has ended"
        raise Refused(Fault(field="parent", message=message))
    return following(read_scene(row.scene))


def following(scene: Scene) -> Scene:
    """The scene for a plan that follows another: what was done can be taken back in it."""
    world = worlds[scene.world]
    if scene.actions is not None or not isinstance(world, Reversible):
        return scene
    return replace(scene, actions=(*world.default_actions, *world.reversing_actions))


def _state_after(session: Session, parent: str) -> bytes | None:
    before = dialogue.last_execution(session, plans.get(session, parent))
    return takeover.state_after(session, before) if before else None


def flawless(text: str, scene: Scene, world: WorldDescription) -> tuple[Program, Plan]:
    """A program written by hand has to be right in all its calls."""
    program, plan = understand(text, scene, world)
    if plan.rejected:
        raise ProgramRefused(
            *(
                Fault(field=f"program.line {call.line}", message=f"{call.text}: {call.reason}")
                for call in plan.rejected
            )
        )
    return program, plan


def _known_planner(name: str | None) -> None:
    if name is not None and name not in planners:
        raise UnknownName("planner", name, planners, field="planner.name")


def _known_model(parts: Parts, name: str) -> None:
    try:
        find_model(name, parts.llm)
    except UnknownName as error:
        fault = Fault(field="planner.model", message=error.faults[0].message)
        raise Refused(fault) from error


def _sentence(request: PlanGiven, understood: tuple[Program, Plan] | None) -> str:
    if request.instruction:
        return Instruction(request.instruction).text
    return understood[0].name.replace("_", " ") if understood else ""


def _options(parts: Parts, request: PlanGiven, world: WorldDescription) -> dict[str, Any]:
    """The planner's options with every default filled in, as they are recorded."""
    options = request.planner.model_dump()
    if options["feedback"] is None:
        options["feedback"] = world.feedback
    named = {options["model"], parts.default_model} != {"default"}
    options["name"] = options["name"] or ("progprompt" if named else world.planner)
    return options


class _Faults:
    """Collects the faults of several checks, so that a client learns of all of them at once."""

    def __init__(self) -> None:
        self._refusals: list[Refused] = []

    def __call__(self, check: Callable[[], T]) -> T | None:
        try:
            return check()
        except Refused as refused:
            self._refusals.append(refused)
            return None

    def raise_if_any(self) -> None:
        """Raise what was found, as the kind of the first.

        Raises:
            Refused: anything was found.
        """
        if len(self._refusals) == 1:
            raise self._refusals[0]
        if self._refusals:
            raise Refused(*(fault for refused in self._refusals for fault in refused.faults))
