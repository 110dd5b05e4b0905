"""Sentence → sketch of activities → program: the household's own planner."""

from collections.abc import Iterator, Sequence

from app.domain.action import ActionSignature
from app.domain.errors import ProgramRefused, TaskDeclined
from app.domain.llm import LanguageModel
from app.domain.planner import Draft, Report, Task
from app.domain.program import ActionCall, Comment, Pass, Program, Statement
from app.llm.meaning import likeness
from app.planners import planners
from app.programs.activities import Activity, Home, load_activities
from app.programs.home_selection import HomeSelection
from app.programs.printer import print_program
from app.programs.sketch_composer import Composer
from app.programs.sketch_grammar import sketch_grammar
from app.programs.sketch_parser import parse_sketch
from app.programs.sketch_prompt import STOP, write_sketch_prompt
from app.programs.sketch_wording import plain_english
from app.programs.transcript import Transcript, sketch_request


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
        known = {each.signature.name: each for each in load_activities(task.scene.world)}
        signatures = tuple(each.signature for each in known.values())
        sentence = plain_english(task.instruction.text, task.scene.names)
        prompt = write_sketch_prompt(sentence, signatures, task.history)
        transcript = Transcript(task.options.name, model, prompt, report)
        grammar = sketch_grammar(signatures, sentence)
        completion = transcript.ask(sketch_request(task.options, model, prompt, STOP, grammar))
        transcript.wrote(completion.text)
        selection = HomeSelection(task.scene.objects, task.facts, task.instruction.text, likeness)
        try:
            composed = Composer(selection, signatures).compose(parse_sketch(completion.text))
            home = Home(task.scene.objects, feedback=task.options.feedback)
            body = tuple(_carried_out(composed.body, known, selection, home))
        except ProgramRefused as refused:
            reason = f"what the model {model.name} wrote is no sketch: {refused}"
            raise transcript.failure(reason) from refused
        except TaskDeclined as declined:
            declined.prompt, declined.completion = prompt, completion
            raise
        program = Program(name=task.instruction.function_name, body=body)
        return Draft(
            prompt=prompt,
            completion=completion,
            program=print_program(program),
            confidence=composed.sureness,
        )

    def preamble(self, world: str, actions: Sequence[ActionSignature]) -> str:
        """The import line, which all its prompts begin with."""
        del actions  # The activities stand in their place.
        signatures = [each.signature for each in load_activities(world)]
        return write_sketch_prompt("", signatures).partition("\n")[0] + "\n"


def _carried_out(
    body: Sequence[Statement], known: dict[str, Activity], selection: HomeSelection, home: Home
) -> Iterator[Statement]:
    for statement in body:
        if isinstance(statement, ActionCall):
            names = [selection.class_name(str(each)) for each in statement.arguments]
            yield from home.carry_out(known[statement.action], names)
        elif not isinstance(statement, Comment):
            yield statement
    yield home.done() if body else Pass()
