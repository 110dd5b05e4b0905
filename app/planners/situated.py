"""Sentence → sketch → program: the model reads the sentence, knowledge finds what it means here."""

from app.domain.errors import ProgramRefused, TaskDeclined
from app.domain.llm import Completion, LanguageModel
from app.domain.planner import Draft, Report, Task
from app.domain.program import Program, Statement
from app.llm.meaning import likeness
from app.planners import planners
from app.programs.printer import print_program
from app.programs.sketch_dialogue import asks_to_undo, calls_of, undo
from app.programs.sketch_grammar import sketch_grammar
from app.programs.sketch_parser import parse_sketch
from app.programs.sketch_prompt import STOP, write_sketch_prompt
from app.programs.sketch_resolver import resolve
from app.programs.sketch_verbs import spoken_verbs
from app.programs.sketch_wording import plain_english
from app.programs.transcript import Transcript, sketch_request


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
        grammar = _grammar(task, sentence)
        completion = transcript.ask(sketch_request(task.options, model, prompt, STOP, grammar))
        transcript.wrote(completion.text)
        try:
            body, sureness = resolve(parse_sketch(completion.text), task, likeness)
        except ProgramRefused as refused:
            reason = f"what the model {model.name} wrote is no sketch: {refused}"
            raise transcript.failure(reason) from refused
        except TaskDeclined as declined:
            declined.prompt, declined.completion = prompt, completion
            raise
        return _draft(task, body, sureness, completion, prompt)


def _grammar(task: Task, sentence: str) -> str:
    earlier = [
        str(argument)
        for turn in task.history
        for call in calls_of(turn.program)
        for argument in call.arguments
    ]
    verbs = spoken_verbs(task.actions, sentence)
    return sketch_grammar(verbs, sentence, tuple(dict.fromkeys(earlier)))


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
