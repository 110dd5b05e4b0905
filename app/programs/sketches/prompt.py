"""Sentence + import line → the prompt a sketch is asked for with.

The adapters that write sketches were trained on exactly this text. Nothing of the scene is in it:

    from actions import grab_and_putin(obj1, obj2)
    # put all the fruits except the banana on the plate
    def task():
"""

from collections.abc import Sequence

from app.domain.action import ActionSignature
from app.domain.errors import ProgramRefused
from app.domain.planner import Turn
from app.domain.program import ActionCall
from app.programs.parser import parse_program
from app.programs.printer import INDENT, import_line

STOP = "\n\n"
HEAD = "def task():\n"
MAX_TURNS = 3
MAX_CALLS = 6
"""Shown of an earlier turn."""


def write_sketch_prompt(
    instruction: str, actions: Sequence[ActionSignature], history: Sequence[Turn] = ()
) -> str:
    """The whole prompt; the model goes on with the function's body, four spaces in.

    Earlier turns of a dialogue stand before the sentence, each with its calls as comments.
    """
    lines = [import_line(actions)]
    for turn in history[-MAX_TURNS:]:
        lines.append(f"# {_one_line(turn.instruction)}")
        lines += [f"#{INDENT}{_one_line(call)}" for call in _calls(turn.program)[:MAX_CALLS]]
    lines.append(f"# {_one_line(instruction)}")
    return "\n".join(lines) + f"\n{HEAD}"


def _calls(program: str) -> list[str]:
    try:
        parsed = parse_program(program)
    except ProgramRefused:
        return []
    return [str(each) for each in parsed.body if isinstance(each, ActionCall)]


def _one_line(text: str) -> str:
    return " ".join(text.split())
