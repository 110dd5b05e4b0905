"""Sketch + scene → the calls of an ordinary program over the scene's own names."""

import itertools
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from app.domain.action import ActionSignature, Parameter
from app.domain.errors import Fault, ProgramRefused, TaskDeclined
from app.domain.program import ActionCall, Argument, Comment, Statement
from app.programs.knowledge.names import words
from app.programs.knowledge.word_lists import word_list
from app.programs.sketch import (
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
from app.programs.sketch_order import in_order
from app.programs.sketch_phrase import describe_phrase
from app.programs.sketch_qualities import ordered
from app.programs.sketch_refusals import into_itself, refuse_beside, refuse_harm
from app.programs.sketch_selection import Selection
from app.programs.sketch_sets import COLLECTIVE, counted, halved, is_plural, means_all, movable
from app.programs.sketch_sharing import sharing
from app.programs.sketch_things import Thing, listed
from app.programs.sketch_verbs import DIRECTIONS, PERSONS, SPOKEN, place_of, righted
from app.programs.towers import tower


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
        self._going_on = going_on
        """Whether it replaces a plan that failed: what is there already counts."""
        self._selection = selection
        self._signatures = {action.name: action for action in actions}
        self._taken: set[str] = set()
        self._moved: list[str] = []
        self._named: set[str] = set()
        self._sureness = 1.0

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
        calls = self._piled_up(calls)
        self._name(calls)
        body: list[Statement] = []
        still: list[Statement] = []
        for call in dict.fromkeys(calls):
            body += self._statements(call, still)
        if not any(isinstance(each, ActionCall) for each in body):
            body = still
        for each in body:
            if isinstance(each, ActionCall):
                refuse_harm(each, self._signatures[each.action], self._selection)
        return Composition(tuple(body), round(self._sureness, 3))

    def _piled_up(self, calls: list[SketchCall]) -> list[SketchCall]:
        """The calls with a tower in the order that the sentence plainly tells."""
        pairs = tower(self._selection.sentence, self._selection.things)
        stacking = [call for call in calls if self._puts(call)]
        if pairs is None or not stacking:
            return calls
        action = stacking[-1].action
        place = place_of(self._signatures[action], ())
        built = [
            SketchCall(action, tuple(map(_named, pair[::-1] if place == 0 else pair)))
            for pair in pairs
        ]
        return [*(call for call in calls if call not in stacking), *built]

    def _puts(self, call: SketchCall) -> bool:
        signature = self._signatures.get(call.action)
        return signature is not None and len(signature.parameters) == 2

    def _name(self, calls: Sequence[SketchCall]) -> None:
        """Note what the sketch names, so that the rest is known."""
        if not any(isinstance(each, Rest) for call in calls for each in call.arguments):
            return
        for call in calls:
            for argument in call.arguments:
                phrases: list[Phrase] = []
                if isinstance(argument, Phrase):
                    phrases = [argument, *(Phrase(text=each) for each in argument.but)]
                elif isinstance(argument, Same | Each):
                    phrases = [Phrase(text=argument.text, quantity="all")]
                for phrase in phrases:
                    if self._selection.possible(phrase):
                        found = self._selection.all(phrase).things
                        self._named |= {thing.name for thing in found}

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
        call = righted(call, signature, self._selection.sentence)
        call = in_order(call, signature, self._selection.sentence)
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

    @property
    def _last(self) -> str | None:
        """What was moved last: the top of a pile."""
        return self._moved[-1] if self._moved else None

    def _take(self, names: Iterable[str]) -> None:
        self._taken |= (taken := set(names))
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
            value = self._value(argument, signature.parameters[i], others, holds=i == place)
            if value is None:
                return None
            found[i] = value
        values = tuple(found[i] for i in range(len(call.arguments)))
        self._take(each for each in values if isinstance(each, str))
        self._moved += [str(values[1 - place])] if place is not None and len(values) == 2 else []
        return [ActionCall(action=call.action, arguments=values)]

    def _value(
        self, argument: SketchArgument, parameter: Parameter, without: set[str], *, holds: bool
    ) -> Argument | None:
        """The object, word or number that stands for a single argument; None for several objects."""
        if not isinstance(argument, Phrase):
            return argument if isinstance(argument, float) else None
        if (word := self._word(argument, parameter)) is not None:
            return word
        if holds and self._last and set(words(argument.text)) <= TOP:
            return self._last
        if argument.quantity == "all" and argument.count == 1:
            return self._any_one(argument, without, parameter.affordance)
        if not self._selection.possible(argument, without) and self._selection.possible(argument):
            raise into_itself(argument.text)
        if (is_plural(argument) or self._collective(argument) or self._elliptic(argument)) and (
            not holds
        ):
            many = self._selection.all(argument, without)
            if len(many.things) > 1:
                return None
        found = self._selection.one(argument, without, holds=holds, affordance=parameter.affordance)
        self._sureness = min(self._sureness, found.sureness)
        return found.things[0].name

    def _word(self, phrase: Phrase, parameter: Parameter) -> str | None:
        """The words themselves where the verb takes a direction, a person or the like."""
        plainly = phrase.text.lower()
        if parameter.role == "word" and plainly in parameter.words:
            return plainly
        if parameter.name in SPOKEN and not self._selection.possible(phrase):
            return phrase.text
        spoken = plainly in DIRECTIONS | PERSONS and not self._exactly(plainly)
        return phrase.text if spoken else None

    def _elliptic(self, phrase: Phrase) -> bool:
        """Whether it is "glass: green bin", where nobody said "one"."""
        found = words(phrase.text)
        return found[-1:] == ("one",) and "one" not in words(self._selection.sentence)

    def _collective(self, phrase: Phrase) -> bool:
        """Whether the words speak of all there is of a kind: "the cutlery", "the fruit"."""
        if means_all(phrase, self._selection.sentence):
            return True
        found = words(phrase.text)
        mass = bool(found) and found[-1] in COLLECTIVE and not self._exactly(phrase.text.lower())
        return mass and not self._selection.indefinite(phrase.text)

    def _any_one(self, phrase: Phrase, without: set[str], affordance: str | None) -> str:
        """One of those that fit, one that nothing was done with yet if there is any."""
        found = self._selection.all(phrase, without, affordance=affordance)
        self._sureness = min(self._sureness, found.sureness)
        names = [thing.name for thing in found.things]
        return next((name for name in names if name not in self._taken), names[0])

    def _exactly(self, text: str) -> bool:
        return any(thing.name.lower() == text for thing in self._selection.things)

    def _spelt_out(
        self, call: SketchCall, signature: ActionSignature, which: int, still: list[Statement]
    ) -> list[Statement]:
        """One call for each member of the set at place ``which``."""
        fixed = self._fixed(call, signature, which)
        spread = next((each for each in call.arguments if _spread(each)), None)
        argument = call.arguments[which]
        targets = self._targets(spread, argument)
        if isinstance(argument, Phrase) and spread is None:
            argument = counted(argument, self._selection.sentence)
        if isinstance(spread, Each) and isinstance(argument, Phrase) and argument.count:
            spread, argument = _for_each(spread, argument, len(targets))
        avoid = {str(each) for each in fixed.values()} | {thing.name for thing in targets}
        members = self._members(argument, avoid, fixed, signature.parameters[which].affordance)
        pairs = self._pairs(members, spread, targets)
        lines: list[Statement] = []
        place = next(iter(fixed), None) if self._piled(argument, fixed, spread) else None
        for number, (member, target) in enumerate(pairs):
            values = dict(fixed)
            values[which] = member.name
            if place is not None and number:
                values[place] = pairs[number - 1][0].name
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
        self._take(member.name for member, _ in pairs)
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
            value = self._value(argument, signature.parameters[i], set(), holds=True)
            if value is None:
                raise ProgramRefused(Fault(field="program", message=f"two sets in {call}"))
            found[i] = value
        return found

    def _targets(
        self, spread: SketchArgument | None, argument: SketchArgument
    ) -> tuple[Thing, ...]:
        if not isinstance(spread, Same | Each):
            return ()
        if isinstance(argument, Phrase) and spread.text == argument.text:
            return self._others(argument)
        return self._selection.all(Phrase(text=spread.text, quantity="all")).things

    def _others(self, argument: Phrase) -> tuple[Thing, ...]:
        """What the sentence speaks of besides the members, where the sketch repeats their words."""
        members = {thing.name for thing in self._selection.all(argument).things}
        for word in words(self._selection.sentence):
            phrase = Phrase(text=word, quantity="all")
            if self._selection.possible(phrase, members):
                return self._selection.all(phrase, members).things
        raise self._selection.absent(f"other place than {argument.text}")

    def _members(
        self,
        argument: SketchArgument,
        avoid: set[str],
        fixed: dict[int, Argument],
        affordance: str | None,
    ) -> list[Thing]:
        if isinstance(argument, Rest):
            free = [
                t for t in self._selection.things if t.name not in avoid | self._named | self._taken
            ]
            found = movable(free, self._selection)
            if not found:
                raise self._selection.absent("other thing")
            return found
        if not isinstance(argument, Phrase):
            raise ProgramRefused(Fault(field="program", message="a set is wanted"))
        selected = self._selection.all(argument, avoid, affordance=affordance)
        self._sureness = min(self._sureness, selected.sureness)
        found = list(selected.things)
        described = describe_phrase(argument)
        told = described.colours or described.materials or described.sizes
        if described.vague and (not told or self._elliptic(argument)):
            found = movable(found, self._selection)
        found = ordered(found, argument.order)
        argument = halved(argument, self._selection.sentence, len(found))
        if argument.count is not None:
            return self._counted(argument, found, fixed)
        if not found:
            raise self._selection.absent(argument.text)
        return found

    def _counted(
        self, phrase: Phrase, found: list[Thing], fixed: dict[int, Argument]
    ) -> list[Thing]:
        """So many of them, those first that nothing was done with yet."""
        count = phrase.count or 0
        there = {str(each) for each in fixed.values()}
        fresh = [
            thing
            for thing in found
            if thing.name not in self._taken
            and not any(self._selection.rests(thing.name, place) for place in there)
        ]
        if len(found) < count:
            have = listed([thing.name for thing in found])
            only = f"only {len(found)}: {have}" if found else "none"
            raise TaskDeclined(
                f"{count} {phrase.text} are asked for and there is {only}",
                kind="absent",
                question=f"Should the {len(found)} be taken?" if found else None,
            )
        rest = [thing for thing in found if thing not in fresh]
        done = [t for t in rest if any(self._selection.rests(t.name, place) for place in there)]
        return ((done if self._going_on else []) + fresh + rest)[:count]

    def _pairs(
        self, members: list[Thing], spread: SketchArgument | None, targets: Sequence[Thing]
    ) -> list[tuple[Thing, Thing | None]]:
        match spread:
            case Previous():
                if len(members) < 2:
                    raise TaskDeclined(
                        f"a stack takes two things, and there is only {members[0].name}",
                        kind="absent",
                    )
                return [(b, a) for a, b in itertools.pairwise(members)]
            case Same():
                return self._shared(members, spread, targets)
            case Each():
                return self._dealt(members, spread, targets)
            case _:
                return [(member, None) for member in members]

    def _shared(
        self, members: list[Thing], spread: Same, targets: Sequence[Thing]
    ) -> list[tuple[Thing, Thing | None]]:
        pairs: list[tuple[Thing, Thing | None]] = []
        for member in members:
            shared = sharing(member, targets, spread.property)
            if len(shared) == 1:
                pairs.append((member, shared[0]))
        if not pairs:
            raise TaskDeclined(
                f"none of {listed([t.name for t in targets])} has the same {spread.property} as "
                f"{listed([t.name for t in members], 'or')}",
                kind="absent",
            )
        return pairs

    def _dealt(
        self, members: list[Thing], spread: Each, targets: Sequence[Thing]
    ) -> list[tuple[Thing, Thing | None]]:
        need = len(targets) * spread.count
        if len(targets) <= len(members) < need:  # "one each": a number that was not meant so
            return list(zip(members, targets, strict=False))
        if len(members) < need:
            raise TaskDeclined(
                f"{need} are needed for {listed([t.name for t in targets])}, and there are only "
                f"{listed([t.name for t in members])}",
                kind="absent",
            )
        return [(members[i], targets[i // spread.count]) for i in range(need)]

    def _comment(self, argument: SketchArgument, members: Sequence[Thing]) -> Comment:
        text = argument.text if isinstance(argument, Phrase) else "rest"
        return Comment(
            text=f"{text}: {listed([thing.name for thing in members], ',').replace(' , ', ', ')}"
        )


def _named(name: str) -> Phrase:
    return Phrase(text=name)


def _for_each(spread: Each, phrase: Phrase, targets: int) -> tuple[Each, Phrase]:
    """``all('candy', count=1)`` for ``each('cup')`` counts for each of the cups."""
    if targets and phrase.count is not None and phrase.count < targets * spread.count:
        return Each(spread.text, phrase.count), replace(phrase, count=None)
    return spread, phrase


def _any_one_of(argument: SketchArgument) -> bool:
    return isinstance(argument, Phrase) and argument.quantity == "all" and argument.count == 1


def _spread(argument: SketchArgument) -> bool:
    return isinstance(argument, Same | Each | Previous)


PILING = word_list("piling")
TOP = frozenset(("very", "top", "of", "it", "all", "pile", "stack", "tower", "that", "the"))
"""Words of a place that is on top of what was put there last."""
