"""Sketch + scene → the calls of an ordinary program over the scene's own names."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from app.domain.action import ActionSignature
from app.domain.errors import Fault, ProgramRefused, TaskDeclined
from app.domain.program import ActionCall, Argument, Comment, Statement
from app.programs.knowledge.names import words
from app.programs.knowledge.word_lists import word_list
from app.programs.sketches.aiming import aimed
from app.programs.sketches.arguments import Arguments
from app.programs.sketches.course import Course
from app.programs.sketches.members import Members
from app.programs.sketches.named import goals, named
from app.programs.sketches.order import in_order, told_apart
from app.programs.sketches.pairs import for_each, pairs
from app.programs.sketches.pouring import POUR, poured_into
from app.programs.sketches.refusals import (
    refuse_beside,
    refuse_harm,
    refuse_immaterial,
    refuse_ungrounded,
)
from app.programs.sketches.retelling import retold
from app.programs.sketches.selection import Selection
from app.programs.sketches.sets import counted, stays
from app.programs.sketches.sharing import said_to_share
from app.programs.sketches.sketch import (
    Decline,
    Each,
    Phrase,
    Previous,
    Rest,
    Same,
    Sketch,
    SketchArgument,
    SketchCall,
)
from app.programs.sketches.things import Thing, listed
from app.programs.sketches.towers import tower
from app.programs.sketches.verbs import place_of, righted


@dataclass(frozen=True, slots=True)
class Composition:
    """The program's statements, and how sure they are, 0 to 1."""

    body: tuple[Statement, ...]
    sureness: float


class Composer:
    """Turns one sketch into calls."""

    def __init__(
        self, selection: Selection, actions: Sequence[ActionSignature], *, going_on: bool = False
    ) -> None:
        """Take the scene and the verbs on offer.

        ``going_on``: it replaces a plan that failed, so that what is there already counts.
        """
        self._selection = selection
        self._signatures = {action.name: action for action in actions}
        self._course = Course()
        self._arguments = Arguments(selection, self._course)
        self._members = Members(selection, self._course, self._arguments, going_on=going_on)

    def compose(self, sketch: Sketch) -> Composition:
        """All statements, sets spelt out.

        Raises:
            TaskDeclined: something is absent, ambiguous or impossible.
            ProgramRefused: a verb is not on offer, or is given too many or too few arguments.
        """
        if any(isinstance(each, Decline) for each in sketch.body):
            raise TaskDeclined(
                f"the actions on offer ({', '.join(self._signatures)}) cannot do this",
                kind="impossible",
            )
        calls = [each for each in sketch.body if isinstance(each, SketchCall)]
        calls = self._piled_up([c for c in calls if not self._left_alone(c)] or calls)
        self._course.named = named(calls, self._selection)
        self._course.goals = goals(calls, self._signatures, self._selection.things)
        body: list[Statement] = []
        still: list[Statement] = []
        for call in dict.fromkeys(calls):
            body += self._statements(call, still)
        if not any(isinstance(each, ActionCall) for each in body):
            body = still
        for each in body:
            if isinstance(each, ActionCall):
                refuse_ungrounded(each, self._signatures[each.action], self._selection)
                refuse_harm(each, self._signatures[each.action], self._selection)
        return Composition(tuple(body), round(self._course.sureness, 3))

    def _piled_up(self, calls: list[SketchCall]) -> list[SketchCall]:
        """The calls with a tower in the order that the sentence plainly tells."""
        told = tower(self._selection.sentence, self._selection.things)
        return calls if told is None else retold(calls, told, self._signatures)

    def _left_alone(self, call: SketchCall) -> bool:
        """Whether the sentence says that its thing stays: "leaving the third red one out"."""
        first = call.arguments[0] if call.arguments else None
        return isinstance(first, Phrase) and stays(first.text, self._selection.sentence)

    def _statements(self, call: SketchCall, still: list[Statement]) -> list[Statement]:
        signature = self._signatures.get(call.action)
        if signature is None:
            known = ", ".join(self._signatures)
            raise ProgramRefused(
                Fault(field="program", message=f"no action {call.action}: {known}")
            )
        if len(call.arguments) != len(signature.parameters):
            message = f"{call.action} takes {len(signature.parameters)} arguments"
            raise ProgramRefused(Fault(field="program", message=message))
        refuse_beside(call, self._selection.sentence)
        refuse_immaterial(call, self._selection)
        call = aimed(told_apart(call), signature, self._selection)
        call = righted(call, signature, self._selection.sentence)
        call = self._shared(in_order(call, signature, self._selection.sentence), signature)
        several = [i for i, each in enumerate(call.arguments) if self._several(each)]
        place = place_of(signature, several)
        if place in several and len(several) == 1 and _any_one_of(call.arguments[place]):
            several = []
        if not several:
            single = self._single(call, signature, place)
            if single is not None:
                return single
            several = [1 - place if place is not None and len(call.arguments) == 2 else 0]
        return self._spelt_out(call, signature, several[0], still)

    def _shared(self, call: SketchCall, signature: ActionSignature) -> SketchCall:
        """With the places of the same kind where the words for the place speak of "its own"."""
        place = place_of(signature, ())
        if place is None or len(call.arguments) != 2:
            return call
        target = call.arguments[place]
        same = said_to_share(target) if isinstance(target, Phrase) else None
        if same is None or not self._selection.several(same.text):
            return call
        given = [*call.arguments]
        given[place] = same
        return SketchCall(call.action, tuple(given))

    def _take(self, names: Iterable[str]) -> None:
        self._course.taken |= (taken := set(names))
        self._selection.spoken |= taken

    def _several(self, argument: SketchArgument) -> bool:
        return isinstance(argument, Rest) or (
            isinstance(argument, Phrase) and argument.quantity == "all"
        )

    def _single(
        self, call: SketchCall, signature: ActionSignature, place: int | None
    ) -> list[Statement] | None:
        """One call on single objects; None where an argument spreads over several."""
        if any(_spread(each) for each in call.arguments):
            return None
        found: dict[int, Argument] = {}
        order = sorted(range(len(call.arguments)), key=lambda i: i != place)
        for i in order:
            others = {str(each) for j, each in found.items() if j != i}
            argument = call.arguments[i]
            value = self._arguments.value(
                argument, signature.parameters[i], others, holds=i == place
            )
            if value is None:
                return None
            found[i] = value
        values = tuple(found[i] for i in range(len(call.arguments)))
        if call.action == POUR and len(values) == 2:
            sentence, things = self._selection.sentence, self._selection.things
            values = (values[0], poured_into(str(values[1]), self._course, sentence, things))
        self._take(each for each in values if isinstance(each, str))
        if place is not None and len(values) == 2:
            self._course.put(str(values[1 - place]), str(values[place]))
        return [ActionCall(action=call.action, arguments=values)]

    def _spelt_out(
        self, call: SketchCall, signature: ActionSignature, which: int, still: list[Statement]
    ) -> list[Statement]:
        """One call for each member of the set at place ``which``."""
        fixed = self._fixed(call, signature, which)
        spread = next((each for each in call.arguments if _spread(each)), None)
        argument = call.arguments[which]
        targets = self._members.targets(spread, argument)
        if isinstance(argument, Phrase) and spread is None:
            argument = counted(argument, self._selection.sentence)
        if isinstance(spread, Each) and isinstance(argument, Phrase) and argument.count:
            spread, argument = for_each(spread, argument, len(targets))
        avoid = {str(each) for each in fixed.values()} | {thing.name for thing in targets}
        affordance = signature.parameters[which].affordance
        members = self._members.of(argument, avoid, fixed, affordance, call.action)
        placed = pairs(members, spread, targets)
        lines: list[Statement] = []
        place = next(iter(fixed), None) if self._piled(argument, fixed, spread) else None
        for number, (member, target) in enumerate(placed):
            values = dict(fixed)
            values[which] = member.name
            if place is not None and number:
                values[place] = placed[number - 1][0].name
            for i, each in enumerate(call.arguments):
                if _spread(each) and target is not None:
                    values[i] = target.name
            lines.append(
                ActionCall(
                    action=call.action,
                    arguments=tuple(values[i] for i in range(len(call.arguments))),
                )
            )
        resting = [line for line in lines if isinstance(line, ActionCall) and self._rests(line)]
        still += resting
        self._take(member.name for member, _ in placed)
        self._course.shared(placed, fixed)
        moving = [line for line in lines if line not in resting]
        return [self._comment(call.arguments[which], members), *moving] if moving else []

    def _piled(
        self, argument: SketchArgument, fixed: dict[int, Argument], spread: SketchArgument | None
    ) -> bool:
        """Whether only the first goes onto the place, and each other onto the one before it."""
        ordered = isinstance(argument, Phrase) and argument.order is not None
        said = set(words(self._selection.sentence))
        return ordered and spread is None and len(fixed) == 1 and bool(said & PILING)

    def _rests(self, call: ActionCall) -> bool:
        """Whether the first object is in or on the second already."""
        if len(call.arguments) != 2:
            return False
        first, second = map(str, call.arguments)
        return self._selection.rests(first, second)

    def _fixed(
        self, call: SketchCall, signature: ActionSignature, which: int
    ) -> dict[int, Argument]:
        """The arguments that are the same for every member."""
        found: dict[int, Argument] = {}
        for i, argument in enumerate(call.arguments):
            if i == which or _spread(argument):
                continue
            if isinstance(argument, Phrase) and argument.quantity == "all" and argument.count != 1:
                argument = replace(argument, quantity="one", but=(), count=None, order=None)
            value = self._arguments.value(argument, signature.parameters[i], set(), holds=True)
            if value is None:
                raise ProgramRefused(Fault(field="program", message=f"two sets in {call}"))
            found[i] = value
        return found

    def _comment(self, argument: SketchArgument, members: Sequence[Thing]) -> Comment:
        text = argument.text if isinstance(argument, Phrase) else "rest"
        return Comment(
            text=f"{text}: {listed([thing.name for thing in members], ',').replace(' , ', ', ')}"
        )


def _any_one_of(argument: SketchArgument) -> bool:
    return isinstance(argument, Phrase) and argument.quantity == "all" and argument.count == 1


def _spread(argument: SketchArgument) -> bool:
    return isinstance(argument, Same | Each | Previous)


PILING = word_list("piling")
