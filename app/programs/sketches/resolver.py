"""Sketch + task → the statements of a program, or the reason why there is none."""

from app.domain.errors import TaskDeclined
from app.domain.planner import Task
from app.domain.program import ActionCall, Comment, Statement
from app.programs.sketches.composer import Composer, Composition
from app.programs.sketches.dialogue import moved_before
from app.programs.sketches.lists import listed_pairs
from app.programs.sketches.retelling import places_used, retold
from app.programs.sketches.selection import Judge, Selection
from app.programs.sketches.sketch import Sketch, SketchCall
from app.programs.sketches.things import read_things

FAILED_LAST = 1
"""Place of what failed before in the order things are chosen in: behind all others."""


def resolve(
    sketch: Sketch, task: Task, judge: Judge | None = None, sentence: str | None = None
) -> tuple[tuple[Statement, ...], float]:
    """The program's statements over the scene's names, and how sure they are, 0 to 1.

    ``sentence`` is what the sketch was read from, where that is not the instruction itself.

    Where it replaces a plan that failed, what is done already is left out, and of things that are
    as good as each other those are taken that did not fail.

    Raises:
        TaskDeclined: something is absent, ambiguous, impossible or hazardous.
        ProgramRefused: the sketch uses a verb that is not on offer, or wrongly.
    """
    things = read_things(task.scene.objects)
    if task.failed is not None:
        told = task.failed.outcome
        things = tuple(sorted(things, key=lambda thing: FAILED_LAST * (thing.name in told)))
    earlier = moved_before(task.history)
    asked = task.instruction.text
    selection = Selection(things, task.facts, sentence or asked, judge, earlier, asked)
    composed = _composed(sketch, task, selection)
    body = composed.body
    if task.failed is not None:
        body = _left(body, selection) or body
    return body, composed.sureness


def _composed(sketch: Sketch, task: Task, selection: Selection) -> Composition:
    """What the sketch means; where it leaves out a container of a plain list, what the list says."""

    def compose(each: Sketch) -> Composition:
        return Composer(selection, task.actions, going_on=task.failed is not None).compose(each)

    calls = [each for each in sketch.body if isinstance(each, SketchCall)]
    pairs = listed_pairs(selection.sentence, selection.things)
    if pairs is None or len(calls) < len(sketch.body):
        return compose(sketch)
    signatures = {action.name: action for action in task.actions}
    told = Sketch(tuple(retold(calls, pairs, signatures)))
    try:
        composed = compose(sketch)
    except TaskDeclined as declined:
        if declined.kind == "hazardous" or told == sketch:
            raise
        return compose(told)
    made = [each for each in composed.body if isinstance(each, ActionCall)]
    complete = {place for _, place in pairs} <= places_used(made, signatures)
    return composed if complete else compose(told)


def _left(body: tuple[Statement, ...], selection: Selection) -> tuple[Statement, ...]:
    """Without the calls whose effect is there already; none where nothing is left to do."""
    kept = tuple(
        each
        for each in body
        if not (
            isinstance(each, ActionCall)
            and len(each.arguments) == 2
            and selection.rests(str(each.arguments[0]), str(each.arguments[1]))
        )
    )
    return kept if any(not isinstance(each, Comment) for each in kept) else ()
