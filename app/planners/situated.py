"""Sentence → sketch → program: the model reads the sentence, knowledge finds what it means here."""

from collections.abc import Sequence
from dataclasses import replace

from app.domain.action import ActionSignature
from app.domain.errors import ModelError, ProgramRefused, TaskDeclined
from app.domain.llm import Completion, LanguageModel
from app.domain.planner import Draft, Report, Task
from app.domain.program import Program, Statement
from app.llm.meaning import likeness
from app.planners import planners
from app.programs.printer import print_program
from app.programs.sketches.dialogue import asks_to_undo, calls_of, undo
from app.programs.sketches.grammar import sketch_grammar
from app.programs.sketches.order import unsaid
from app.programs.sketches.parser import parse_sketch
from app.programs.sketches.prompt import STOP, write_sketch_prompt
from app.programs.sketches.rereading import without_asides
from app.programs.sketches.resolver import resolve
from app.programs.sketches.sketch import SketchCall
from app.programs.sketches.things import read_things
from app.programs.sketches.verbs import spoken_verbs
from app.programs.sketches.wording import plain_english
from app.programs.transcript import Transcript, sketch_request

MOST_ORDERED = 3
"""Verbs that a sketch can be made to use, each once, in an order of the model's choice."""


@planners.register("situated")
class Situated:
    """Asks the model for a sketch of the sentence, and resolves it in the scene.

    The model is not shown the scene. A sentence that only takes back the turn before needs none.
    """

    model = "situated"
    repairs = False

    def write_program(self, task: Task, model: LanguageModel, report: Report) -> Draft:
        """Ask the model for a sketch and resolve it.

        Raises:
            ModelError: the model could not be asked, or gave nothing usable.
            TaskDeclined: something is absent, ambiguous, impossible or hazardous.
            Cancelled: ``report`` asked for it.
        """
        sentence = plain_english(task.instruction.text, task.scene.names)
        prompt = write_sketch_prompt(sentence, task.actions, task.history)
        transcript = Transcript(task.options.name, model, prompt, report)
        if task.history and (said := asks_to_undo(task.instruction.text)):
            return _draft(task, undo(task, said["what"]), 1.0, transcript.completion(), prompt)
        try:
            return _read(task, model, transcript, sentence)
        except TaskDeclined as declined:
            shorter = without_asides(sentence, read_things(task.scene.objects))
            if declined.kind != "absent" or shorter is None:
                raise
            prompt = write_sketch_prompt(shorter, task.actions, task.history)
            transcript = Transcript(task.options.name, model, prompt, report)
            try:
                return _read(task, model, transcript, shorter)
            except (TaskDeclined, ModelError):
                raise declined from None


def _read(task: Task, model: LanguageModel, transcript: Transcript, sentence: str) -> Draft:
    """The draft as the sentence is read in the scene."""
    completion = _sketched(task, model, transcript, sentence)
    transcript.wrote(completion.text)
    try:
        body, sureness = resolve(parse_sketch(completion.text), task, likeness, sentence)
    except ProgramRefused as refused:
        reason = f"what the model {model.name} wrote is no sketch: {refused}"
        raise transcript.failure(reason) from refused
    except TaskDeclined as declined:
        declined.prompt, declined.completion = transcript.prompt, completion
        raise
    return _draft(task, body, sureness, completion, transcript.prompt)


def _sketched(
    task: Task, model: LanguageModel, transcript: Transcript, sentence: str
) -> Completion:
    """The model's sketch; a verb that the sentence says and the sketch lacks is asked for again."""
    verbs = spoken_verbs(task.actions, sentence)
    grammar = sketch_grammar(verbs, sentence, _earlier(task))
    request = sketch_request(task.options, model, transcript.prompt, STOP, grammar)
    completion = transcript.ask(request)
    if request.grammar is None or not (lacking := _unsaid(completion.text, verbs, sentence)):
        return completion
    called = [verb for verb in verbs if f"{verb.name}(" in completion.text]
    wanted = [verb for verb in verbs if verb in called or verb.name in lacking]
    if not 2 <= len(wanted) <= MOST_ORDERED:
        return completion
    grammar = sketch_grammar(wanted, sentence, _earlier(task), each=True)
    return transcript.ask(replace(request, grammar=grammar))


def _unsaid(text: str, verbs: Sequence[ActionSignature], sentence: str) -> set[str]:
    try:
        body = parse_sketch(text).body
    except ProgramRefused:
        return set()
    calls = [each for each in body if isinstance(each, SketchCall)]
    return unsaid(calls, verbs, sentence) if len(calls) == len(body) else set()


def _earlier(task: Task) -> tuple[str, ...]:
    earlier = [
        str(argument)
        for turn in task.history
        for call in calls_of(turn.program)
        for argument in call.arguments
    ]
    return tuple(dict.fromkeys(earlier))


def _draft(
    task: Task, body: tuple[Statement, ...], sureness: float, completion: Completion, prompt: str
) -> Draft:
    program = Program(name=task.instruction.function_name, body=body)
    return Draft(
        prompt=prompt,
        completion=completion,
        program=print_program(program),
        confidence=sureness,
    )
