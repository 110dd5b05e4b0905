"""A task in the middle of a dialogue → the task as it would be given by itself."""

import re
from dataclasses import dataclass, replace

from app.domain.instruction import Instruction
from app.domain.planner import Draft, Task, Turn
from app.domain.program import ActionCall, Comment
from app.programs.parser import parse_program
from app.programs.printer import print_program
from app.programs.sketches.answering import clear_history, done, heard
from app.programs.sketches.correcting import corrected, correction
from app.programs.sketches.dialogue import THEN, calls_of, taken_back, undo
from app.programs.sketches.things import read_things

_AGAIN = re.compile(
    r"(?<=\w)(?:[,;.]\s*|\s+)(?:and then|and|then)\s+(?:please\s+)?(?:take|get|remove|bring|put|pull|move)\s+"
    r"(?:it|them|that)\s+(?:right\s+)?(?:back(?:\s+(?:out|off))?|out|off)"
    r"(?:\s+(?:again|of (?:it|there)|where (?:it|they) (?:was|were)))*[\s.!]*$",
    re.I,
)
"""... and then take it out again."""


@dataclass(frozen=True, slots=True)
class Understood:
    """What the sentence says, after the turns before it that were done."""

    task: Task
    wrong: Turn | None = None
    """The turn that the sentence puts right: what it moved is brought back first."""

    again: bool = False
    """What it moves is taken back at the end."""

    def rightly(self, draft: Draft) -> Draft:
        """The draft, beginning with what brings back wrong moves, ending with what takes back its own.

        Raises:
            TaskDeclined: no verb on offer can bring them back.
        """
        program = parse_program(draft.program)
        if self.again:
            here = Turn(instruction=self.task.instruction.text, program=draft.program)
            back = undo(replace(self.task, history=(*self.task.history, here)))
            program = replace(program, body=(*program.body, *back))
            draft = replace(draft, program=print_program(program))
        if self.wrong is None:
            return draft
        moved = {
            str(each.arguments[0])
            for each in program.body
            if isinstance(each, ActionCall) and each.arguments
        }
        history = (*self.task.history, self.wrong)
        back = taken_back(replace(self.task, history=history), moved)
        if not back:
            return draft
        body = (*back, Comment(text=THEN), *program.body)
        return replace(draft, program=print_program(replace(program, body=body)))


def understood(task: Task) -> Understood:
    """The task with its sentence made clear by the turns before it.

    Raises:
        TaskDeclined: it answers a question, and leaves it open.
    """
    things = read_things(task.scene.objects)
    history = clear_history(task.history, things)
    sentence = heard(task.instruction.text, history, things)
    last = history[-1] if history else None
    wrong = None
    if last and calls_of(last.program) and sentence != task.instruction.text:
        wrong = last if correction(task.instruction.text, last.instruction, things) else None
    kept = done(history[:-1] if wrong else history)
    sentence = corrected(sentence, things)
    again = _AGAIN.search(sentence)
    instruction = Instruction(sentence[: again.start()] if again else sentence)
    task = replace(task, instruction=instruction, history=kept)
    return Understood(task, wrong, again is not None)
