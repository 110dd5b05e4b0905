"""Sentence → sketch → program: the model reads the sentence, knowledge finds what it means here."""

from collections.abc import Sequence
from dataclasses import replace

from app.domain.action import ActionSignature
from app.domain.errors import ModelError, TaskDeclined
from app.domain.llm import LanguageModel
from app.domain.planner import Draft, Report, Task
from app.domain.scene import SceneObject
from app.llm.meaning import likeness
from app.planners import planners
from app.programs.knowledge.hazards import hazard
from app.programs.sketches.allotting import allotted
from app.programs.sketches.conversation import understood
from app.programs.sketches.dialogue import asks_to_undo, calls_of, undo
from app.programs.sketches.former import named_again
from app.programs.sketches.graded import graded
from app.programs.sketches.greetings import answer_greeting
from app.programs.sketches.leaving_out import completed
from app.programs.sketches.offering import with_offer
from app.programs.sketches.pieces import named_places, pieces
from app.programs.sketches.pointing import pointed
from app.programs.sketches.pouring import poured_out
from app.programs.sketches.prompt import write_sketch_prompt
from app.programs.sketches.reader import Reader
from app.programs.sketches.refusals import refuse_place_beside, refuse_two_places
from app.programs.sketches.rereading import only_order, without_asides
from app.programs.sketches.retelling import places_used
from app.programs.sketches.selection import Selection
from app.programs.sketches.sketch import Phrase
from app.programs.sketches.sorting import sorted_out
from app.programs.sketches.swapping import swap
from app.programs.sketches.things import read_things
from app.programs.sketches.verbs import asked_verbs
from app.programs.sketches.watering import watered
from app.programs.sketches.wording import plain_english


@planners.register("situated")
class Situated:
    """Asks the model for a sketch of the sentence, and resolves it in the scene.

    The model is not shown the scene. A sentence that only takes back the turn before needs none.
    """

    model = "situated"
    repairs = False

    def prepare(self) -> None:
        """Read the tables of words, things and hazards, which takes a second."""
        things = read_things((SceneObject(name="cup"), SceneObject(name="bowl")))
        sentence = plain_english("put the cup in the bowl", [thing.name for thing in things])
        Selection(things, frozenset(), sentence).possible(Phrase(text="cup"))
        hazard("cup", "bowl")

    def preamble(self, world: str, actions: Sequence[ActionSignature]) -> str:
        """The import line of a sentence that has something put somewhere, as most do."""
        del world  # Its actions tell.
        asked = asked_verbs(actions, "put it in the box")
        return write_sketch_prompt("", asked).partition("# ")[0] + "# "

    def write_program(self, task: Task, model: LanguageModel, report: Report) -> Draft:
        """Ask the model for a sketch and resolve it.

        A sentence is read again without its asides where a word names nothing that is there, and
        piece by piece where it names a place that nothing was brought to.

        Raises:
            ModelError: the model could not be asked, or gave nothing usable.
            TaskDeclined: something is absent, ambiguous, impossible or hazardous.
            Cancelled: ``report`` asked for it.
        """
        answer_greeting(task.instruction.text, read_things(task.scene.objects))
        said = understood(task)
        try:
            return said.rightly(self._written(said.task, model, report))
        except TaskDeclined as declined:
            raise with_offer(declined, task.instruction.text, task.others) from declined

    def _written(self, task: Task, model: LanguageModel, report: Report) -> Draft:
        """The draft of a sentence that the turns before have made clear."""
        things = read_things(task.scene.objects)
        told = named_again(task.instruction.text, things)
        sentence = plain_english(told, task.scene.names)
        selection = Selection(things, task.facts, sentence)
        reader = Reader(task, model, report, likeness)
        said = asks_to_undo(task.instruction.text)
        if said and (task.history or not said["what"]):
            back = undo(task, said["what"], everything=bool(said["all"]))
            return reader.draft(reader.transcript(sentence), back, 1.0)
        if swapped := swap(task, sentence, selection):
            return reader.draft(reader.transcript(sentence), swapped, 1.0)
        if any(action.name == "pour" for action in task.actions):
            sentence = watered(poured_out(sentence, things), things)
        sentence = graded(sentence, selection)
        refuse_place_beside(sentence, task.actions)
        refuse_two_places(sentence)
        sentence = completed(
            allotted(sorted_out(pointed(sentence, selection), selection), selection),
            selection,
            task.actions,
        )
        verbs = asked_verbs(task.actions, sentence)
        if not verbs:
            names = ", ".join(action.name for action in task.actions)
            raise TaskDeclined(f"nothing asks for what is on offer ({names})", kind="impossible")
        reader = Reader(replace(task, actions=verbs), model, report, likeness)
        try:
            draft = reader.read(sentence)
        except TaskDeclined as declined:
            if declined.kind != "absent":
                raise
            again = _in_other_words(reader, sentence, task)
            if again is None:
                raise
            return again
        return _in_pieces(reader, sentence, task, draft) or draft


def _in_other_words(reader: Reader, sentence: str, task: Task) -> Draft | None:
    """The draft of what is left of a sentence that names something that is not there."""
    things = read_things(task.scene.objects)
    for shorter in (without_asides(sentence, things), only_order(sentence, things)):
        if shorter and (again := _again(reader, [shorter])):
            return again
    return _in_pieces(reader, sentence, task, None)


def _in_pieces(reader: Reader, sentence: str, task: Task, draft: Draft | None) -> Draft | None:
    """Another draft that uses every place the sentence names, where this one does not."""
    things = read_things(task.scene.objects)
    parts = pieces(sentence, things, _places(draft, task))
    again = _again(reader, parts) if parts else None
    named = {each.name for each in named_places(sentence, things)}
    return again if again and named <= _places(again, task) else None


def _again(reader: Reader, parts: list[str]) -> Draft | None:
    try:
        return reader.read(*parts)
    except (TaskDeclined, ModelError):
        return None


def _places(draft: Draft | None, task: Task) -> set[str]:
    """Where the program puts things."""
    calls = calls_of(draft.program) if draft else ()
    return places_used(calls, {action.name: action for action in task.actions})
