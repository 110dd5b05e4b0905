"""Reader: asks the model for sketches of a sentence, or of its pieces, and resolves them in the scene."""

from collections.abc import Sequence
from dataclasses import replace

from app.domain.action import ActionSignature
from app.domain.errors import ProgramRefused, TaskDeclined
from app.domain.llm import LanguageModel
from app.domain.planner import Draft, Report, Task
from app.domain.program import Program, Statement
from app.programs.printer import print_program
from app.programs.sketches.dialogue import calls_of
from app.programs.sketches.grammar import sketch_grammar
from app.programs.sketches.meaning import Judge
from app.programs.sketches.order import unsaid
from app.programs.sketches.parser import parse_sketch
from app.programs.sketches.prompt import STOP, write_sketch_prompt
from app.programs.sketches.resolver import resolve
from app.programs.sketches.sketch import SketchCall
from app.programs.sketches.verbs import HANDING, HANDOVER, spoken_verbs
from app.programs.transcript import Transcript, sketch_request

MOST_ORDERED = 3
"""Verbs that a sketch can be made to use, each once, in an order of the model's choice."""


class Reader:
    """Reads for one task with one model."""

    def __init__(self, task: Task, model: LanguageModel, report: Report, judge: Judge) -> None:
        self._task = task
        self._model = model
        self._report = report
        self._judge = judge

    def transcript(self, *parts: str) -> Transcript:
        """Of the prompts for these parts of the sentence."""
        prompt = "\n".join(map(self._prompt, parts))
        return Transcript(self._task.options.name, self._model, prompt, self._report)

    def read(self, *parts: str) -> Draft:
        """The draft as the sentence, or its parts one after another, are understood in the scene.

        Raises:
            ModelError: the model could not be asked, or gave nothing usable.
            TaskDeclined: something is absent, ambiguous, impossible or hazardous.
            Cancelled: ``report`` asked for it.
        """
        transcript = self.transcript(*parts)
        sketch = "".join(f"{self._sketched(transcript, part).rstrip()}\n" for part in parts)
        transcript.wrote(f"{sketch}\n")
        try:
            body, sureness = resolve(
                parse_sketch(f"{sketch}\n"), self._task, self._judge, ". ".join(parts)
            )
        except ProgramRefused as refused:
            reason = f"what the model {self._model.name} wrote is no sketch: {refused}"
            raise transcript.failure(reason) from refused
        except TaskDeclined as declined:
            declined.prompt, declined.completion = transcript.prompt, transcript.completion()
            raise
        return self.draft(transcript, body, sureness)

    def draft(self, transcript: Transcript, body: tuple[Statement, ...], sureness: float) -> Draft:
        """The statements as a function, with all that was asked for them."""
        program = Program(name=self._task.instruction.function_name, body=body)
        return Draft(
            prompt=transcript.prompt,
            completion=transcript.completion(),
            program=print_program(program),
            confidence=sureness,
        )

    def _prompt(self, part: str) -> str:
        return write_sketch_prompt(part, self._task.actions, self._task.history)

    def _sketched(self, transcript: Transcript, part: str) -> str:
        """The model's sketch; a verb that is said and that the sketch lacks is asked for again."""
        verbs = spoken_verbs(self._task.actions, part)
        handing = bool(HANDING.match(part)) and any(verb.name == HANDOVER for verb in verbs)
        grammar = sketch_grammar(verbs, part, self._earlier(), declines=not handing)
        request = sketch_request(self._task.options, self._model, self._prompt(part), STOP, grammar)
        text = transcript.ask(request).text
        if request.grammar is None or not (lacking := _unsaid(text, verbs, part)):
            return text
        called = [verb for verb in verbs if f"{verb.name}(" in text]
        wanted = [verb for verb in verbs if verb in called or verb.name in lacking]
        if not 2 <= len(wanted) <= MOST_ORDERED:
            return text
        grammar = sketch_grammar(wanted, part, self._earlier(), each=True)
        return transcript.ask(replace(request, grammar=grammar)).text

    def _earlier(self) -> tuple[str, ...]:
        """Names that earlier turns used."""
        earlier = [
            str(argument)
            for turn in self._task.history
            for call in calls_of(turn.program)
            for argument in call.arguments
        ]
        return tuple(dict.fromkeys(earlier))


def _unsaid(text: str, verbs: Sequence[ActionSignature], sentence: str) -> set[str]:
    try:
        body = parse_sketch(text).body
    except ProgramRefused:
        return set()
    calls = [each for each in body if isinstance(each, SketchCall)]
    return unsaid(calls, verbs, sentence) if len(calls) == len(body) else set()
