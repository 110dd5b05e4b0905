"""Sentence → sketch of activities → program: the household's own planner."""

from collections.abc import Collection, Iterator, Mapping, Sequence

from app.domain.action import ActionSignature
from app.domain.condition import Relation
from app.domain.errors import ProgramRefused, TaskDeclined
from app.domain.llm import Completion, LanguageModel
from app.domain.planner import Draft, Report, Task
from app.domain.program import ActionCall, Comment, Pass, Program, Statement
from app.llm.meaning import likeness
from app.planners import planners
from app.programs.activities import Activity, load_activities
from app.programs.home import Home
from app.programs.home_answers import not_to_be_done, plainly_possible
from app.programs.home_dialogue import retold, spoken_of, undoing
from app.programs.home_members import HomeMembers, without_room
from app.programs.home_selection import HomeSelection
from app.programs.printer import print_program
from app.programs.sketches.composer import Composer, Composition
from app.programs.sketches.dialogue import asks_to_undo
from app.programs.sketches.grammar import sketch_grammar
from app.programs.sketches.parser import parse_sketch
from app.programs.sketches.prompt import STOP, write_sketch_prompt
from app.programs.sketches.sketch import Decline
from app.programs.sketches.wording import plain_english
from app.programs.transcript import Transcript, sketch_request

MOST_ASKED = 3
"""Sketches asked for, each without the activities that did not suit the things before."""


@planners.register("activities")
class Activities:
    """Has the model say which activities the sentence asks for, and with what.

    The activities stand on the import line in place of the primitives; each comes down to
    primitives by its own function. What these lack in the home as it stands is repaired.
    """

    model = "situated"
    repairs = True

    def write_program(self, task: Task, model: LanguageModel, report: Report) -> Draft:
        """Ask the model for a sketch, and carry its activities out in this home.

        Raises:
            ModelError: the model could not be asked, or gave nothing usable.
            TaskDeclined: something is absent, impossible or hazardous, or is no activity.
            Cancelled: ``report`` asked for it.
        """
        if not load_activities(task.scene.world):
            raise TaskDeclined(
                f"the world {task.scene.world} has no activities; another planner may do",
                kind="impossible",
            )
        asking = _Asking(task, model, report)
        if task.history and (back := asks_to_undo(task.instruction.text)):
            return asking.draft(asking.undoing(back["what"]), asking.transcript.completion(), 1.0)
        completion = asking.ask(())
        try:
            composed, unsuited = asking.understood(completion)
            for _ in range(MOST_ASKED - 1):
                if not unsuited:
                    break
                completion = asking.ask(unsuited)
                composed, more = asking.understood(completion)
                unsuited = (unsuited | more) if more else more
            asking.transcript.wrote(completion.text)
            return asking.draft(composed.body, completion, composed.sureness)
        except ProgramRefused as refused:
            reason = f"what the model {model.name} wrote is no sketch: {refused}"
            raise asking.transcript.failure(reason) from refused
        except TaskDeclined as declined:
            declined.prompt, declined.completion = asking.transcript.prompt, completion
            raise

    def preamble(self, world: str, actions: Sequence[ActionSignature]) -> str:
        """The import line, which all its prompts begin with."""
        del actions  # The activities stand in their place.
        signatures = [each.signature for each in load_activities(world)]
        return write_sketch_prompt("", signatures).partition("\n")[0] + "\n"


class _Asking:
    """One task: its prompt, the activities, and the home they are carried out in."""

    def __init__(self, task: Task, model: LanguageModel, report: Report) -> None:
        self._task = task
        self._model = model
        self._known: Mapping[str, Activity] = {
            each.signature.name: each for each in load_activities(task.scene.world)
        }
        self._signatures = tuple(each.signature for each in self._known.values())
        self._offered = frozenset(each.name for each in task.actions)
        self._members = HomeMembers(
            task.scene.objects, task.rehearsal().holds if task.rehearsal else None
        )
        told = retold(task.instruction.text, task.history, self._members)
        self._as_said = told == task.instruction.text
        self._sentence = plain_english(told, task.scene.names)
        self._asked = without_room(task.scene.objects, self._sentence)
        prompt = write_sketch_prompt(self._asked, self._signatures, task.history)
        self.transcript = Transcript(task.options.name, model, prompt, report)
        self._home = Home(
            task.scene.objects,
            self._members,
            feedback=task.options.feedback,
            sentence=self._sentence,
            offered=self._offered,
        )
        self._here = _room(task)
        self._selection = self._looking()

    def _looking(self) -> HomeSelection:
        task = self._task
        selection = HomeSelection(
            task.scene.objects,
            task.facts,
            task.instruction.text if self._as_said else self._sentence,
            likeness,
            self._here,
            self._members,
        )
        selection.earlier = spoken_of(task.history, self._members)
        return selection

    def ask(self, unsuited: Collection[str]) -> Completion:
        """A sketch of the activities that the sentence may mean, without these."""
        meant = [
            each.signature
            for name, each in self._known.items()
            if name not in unsuited and each.may_be_meant(self._sentence)
        ]
        plainly = any(not each.parameters and self._known[each.name].said_with for each in meant)
        plainly = plainly or plainly_possible(self._task.scene.objects, self._sentence)
        earlier = spoken_of(self._task.history, self._members)
        grammar = sketch_grammar(meant, self._asked, earlier, declines=not plainly)
        return self.transcript.ask(
            sketch_request(self._task.options, self._model, self.transcript.prompt, STOP, grammar)
        )

    def understood(self, completion: Completion) -> tuple[Composition, frozenset[str]]:
        """The sketch's calls over the home's things, and the activities that do not suit them.

        Raises:
            ProgramRefused: it is no sketch.
            TaskDeclined: something is absent or impossible.
        """
        self._selection = self._looking()
        sketch = parse_sketch(completion.text)
        if any(isinstance(each, Decline) for each in sketch.body):
            raise TaskDeclined(not_to_be_done(self._task.scene.objects), kind="impossible")
        composed = Composer(self._selection, self._signatures).compose(sketch)
        unsuited = {
            call.action
            for call in composed.body
            if isinstance(call, ActionCall)
            and not self._home.suits(self._known[call.action], self._names(call))
        }
        return composed, frozenset(unsuited)

    def undoing(self, what: str | None) -> list[ActionCall]:
        """The activities that take back what the turn before did.

        Raises:
            TaskDeclined: there is nothing to take back.
        """
        return undoing(self._task.history, self._task.scene.objects, self._members, what)

    def draft(self, body: Sequence[Statement], completion: Completion, sureness: float) -> Draft:
        """The activities carried out in the home, as a function.

        Raises:
            TaskDeclined: the home lacks something that an activity takes.
        """
        statements = tuple(self._carried_out(body))
        program = Program(name=self._task.instruction.function_name, body=statements)
        return Draft(
            prompt=self.transcript.prompt,
            completion=completion,
            program=print_program(program),
            confidence=sureness,
        )

    def _carried_out(self, body: Sequence[Statement]) -> Iterator[Statement]:
        """The primitives of the calls, each sub-task under its comment."""
        calls = [each for each in body if isinstance(each, ActionCall)]
        for call in calls:
            self._demand_actions(self._known[call.action])
        needless = [self._home.needless(self._known[e.action], self._names(e)) for e in calls]
        if len({call.action for call in calls}) > 1 and not all(needless):
            needless = [None] * len(calls)  # What is so now may not be when its turn comes.
        for call, reason in zip(calls, needless, strict=True):
            if reason is None:
                yield from self._home.carry_out(self._known[call.action], self._names(call))
            else:
                yield Comment(text=f"nothing to do: {reason}")
        yield Pass() if all(needless) else self._home.done()

    def _demand_actions(self, activity: Activity) -> None:
        """Raises TaskDeclined: without an action that is not on offer it would do nothing."""
        for missing in sorted(activity.needs - self._offered):
            raise TaskDeclined(
                f"to {activity.signature.name.replace('_', ' ')} takes the action {missing!r}, "
                f"which is not on offer: name it among the scene's actions, beside the others",
                kind="impossible",
            )

    def _names(self, call: ActionCall) -> list[str]:
        return [self._selection.class_name(str(each)) for each in call.arguments]


def _room(task: Task) -> str | None:
    """Where the agent is, if the home tells."""
    if task.rehearsal is None or task.scene.agent is None:
        return None
    home, agent = task.rehearsal(), task.scene.agent
    rooms = (item.name for item in task.scene.objects if item.category == "room")
    return next((room for room in rooms if home.holds(Relation("in", (agent, room)))), None)
