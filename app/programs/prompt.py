"""Task → the paper's prompt: import line, example programs, and the cue for the next function.

Every function states its own objects, as the paper's tabletop prompt does; the text depends on
nothing but the task.
"""

import unicodedata
from collections.abc import Sequence

from app.domain.action import ActionSignature
from app.domain.instruction import Instruction
from app.domain.planner import PlannerOptions, Task
from app.domain.program import literal
from app.programs.examples import ablate, choose_examples
from app.programs.printer import INDENT, import_line, objects_line, print_program


def write_prompt(task: Task) -> str:
    """The whole prompt; the model is to go on with the body of its last function."""
    return write_preamble(task.scene.world, task.actions, task.options) + write_cue(task)


def write_preamble(world: str, actions: Sequence[ActionSignature], options: PlannerOptions) -> str:
    """What all prompts of a world begin with: the import line and the example programs."""
    shown = (
        print_program(ablate(each, comments=options.comments, feedback=options.feedback))
        for each in choose_examples(world, actions, options.examples)
    )
    return "\n".join((f"{import_line(actions)}\n", *shown, ""))


def write_cue(task: Task) -> str:
    """The head of the function that is wanted, down to its list of objects."""
    lines = [f"def {task.instruction.function_name}():"]
    if not _tells_all(task.instruction):
        lines.append(f"{INDENT}{literal(task.instruction.text)}")
    lines.append(f"{INDENT}{objects_line(task.scene.names)}")
    return "\n".join(lines) + "\n"


def _tells_all(instruction: Instruction) -> bool:
    """Whether the function's name still holds every letter and digit of the sentence."""
    letters = "".join(filter(str.isalnum, instruction.text.lower()))
    plain = unicodedata.normalize("NFC", letters)
    return plain == instruction.function_name.replace("_", "")
