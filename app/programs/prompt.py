"""Task → the paper's prompt: import line, objects, example programs, and the cue for the next function.

On the tabletop every function states its own objects; in the household one list stands above the
examples, and that of a new environment below them. What came before in a dialogue, and a try that
failed, stand as functions above the cue. The text depends on nothing but the task.
"""

import unicodedata
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Literal

from app.domain.action import ActionSignature
from app.domain.errors import ProgramRefused
from app.domain.instruction import Instruction
from app.domain.planner import PlannerOptions, Task, Turn
from app.domain.program import Comment, Described, Program, literal
from app.programs.description import describe_scene
from app.programs.examples import Ranking, ablate, choose_examples, named_objects, task_of
from app.programs.objects import objects_line
from app.programs.parser import parse_program
from app.programs.printer import INDENT, import_line, print_program

GLOBAL = frozenset({"household"})
"""Worlds whose prompts list the objects once, above the functions, as in the paper."""
NAMELESS = "task"
"""What all functions are called where their names are to cue nothing."""
MAX_REMARK = 600
"""Characters of a comment that tells what came of a plan."""

Form = Literal["local", "global", "properties"]


def write_prompt(task: Task, ranking: Ranking | None = None) -> str:
    """The whole prompt; the model is to go on with the body of its last function.

    Raises:
        ValueError: the most similar examples are asked for, and no ranking finds them.
    """
    sentence = task.instruction.text
    examples = choose_examples(task.scene.world, task.actions, task.options, sentence, ranking)
    above = _preamble(task.scene.world, task.actions, task.options, examples, task.scene.names)
    return above + _second_list(task, examples) + _past(task) + write_cue(task)


def write_preamble(world: str, actions: Sequence[ActionSignature], options: PlannerOptions) -> str:
    """What all prompts of a world begin with: the import line and the fixed example programs."""
    return _preamble(world, actions, options, choose_examples(world, actions, options), ())


def write_cue(task: Task) -> str:
    """The head of the function that is wanted, down to its list of objects."""
    cue = task.options.cue
    name = task.instruction.function_name if cue else NAMELESS
    lines = [f"def {f'finish_{name}' if task.failed else name}():"]
    if not (cue and _tells_all(task.instruction)):
        lines.append(f"{INDENT}{literal(task.instruction.text)}")
    if objects_form(task) != "global":
        lines.append(f"{INDENT}{_objects(task)}")
    return "\n".join(lines) + "\n"


def objects_form(task: Task) -> Form:
    """How the task's prompt tells of the objects: as it asks for, or as its world does."""
    return _form(task.scene.world, task.options)


def _form(world: str, options: PlannerOptions) -> Form:
    return options.objects or ("global" if world in GLOBAL else "local")


def _preamble(
    world: str,
    actions: Sequence[ActionSignature],
    options: PlannerOptions,
    examples: Sequence[Program],
    names: Sequence[str],
) -> str:
    form = _form(world, options)
    parts = [f"{import_line(actions)}\n"]
    if form == "global" and examples:
        parts.append(f"{objects_line(_listed_first(examples, names))}\n")
    for each in examples:
        shown = ablate(each, comments=options.comments, feedback=options.feedback)
        parts.append(_example(_with_objects(shown, form), cue=options.cue))
    return "\n".join((*parts, ""))


def _example(program: Program, *, cue: bool) -> str:
    """The text of an example, told by its name or by a docstring."""
    if cue:
        return print_program(program)
    head = f"def {NAMELESS}():\n"
    told = f"{head}{INDENT}{literal(task_of(program))}\n"
    return print_program(replace(program, name=NAMELESS)).replace(head, told, 1)


def _with_objects(program: Program, form: Form) -> Program:
    """The program with its objects as the prompt lists them."""
    match form:
        case "global":
            return replace(program, objects=None, described=())
        case "local":
            return replace(program, objects=named_objects(program), described=())
        case "properties":
            names = named_objects(program)
            described = program.described or tuple(Described(name=name) for name in names)
            return replace(program, objects=names, described=described)


def _listed_first(examples: Sequence[Program], names: Sequence[str]) -> tuple[str, ...]:
    """The objects of the examples' environment; the scene's, where the examples take place in it."""
    shown = tuple(dict.fromkeys(name for each in examples for name in named_objects(each)))
    return tuple(names) if set(shown) <= set(names) else shown


def _second_list(task: Task, examples: Sequence[Program]) -> str:
    """The objects of an environment that is not the examples'."""
    if objects_form(task) != "global":
        return ""
    first = _listed_first(examples, task.scene.names) if examples else ()
    return "" if first == task.scene.names and examples else f"{_objects(task)}\n\n"


def _objects(task: Task) -> str:
    if objects_form(task) == "properties":
        return objects_line(task.scene.names, describe_scene(task.scene, task.facts))
    return objects_line(task.scene.names)


def _past(task: Task) -> str:
    """The dialogue so far, and the try that failed, as functions."""
    shown = [_turn(turn, "what came of it") for turn in task.history]
    if task.failed is not None:
        shown.append(_turn(task.failed, "what happened"))
    return "".join(f"{text}\n" for text in shown)


def _turn(turn: Turn, heading: str) -> str:
    """An earlier program, with what came of it at its end."""
    lines = [f"# earlier: {_one_line(turn.instruction)}\n"]
    outcome = tuple(_remarks(turn.outcome, heading))
    try:
        program = parse_program(turn.program)
    except ProgramRefused:  # Nothing to show of it but that it was asked for.
        return "".join((*lines, *(f"# {remark.text}\n" for remark in outcome)))
    body = (*program.body, *outcome)
    return lines[0] + print_program(replace(program, objects=None, described=(), body=body))


def _remarks(outcome: str, heading: str) -> Iterator[Comment]:
    if outcome.strip():
        yield Comment(text=f"{heading}: {_one_line(outcome)}")


def _one_line(text: str) -> str:
    plain = "".join(each if each.isprintable() else " " for each in text)
    words = " ".join(plain.split())
    return words if len(words) <= MAX_REMARK else f"{words[:MAX_REMARK]}…"


def _tells_all(instruction: Instruction) -> bool:
    """Whether the function's name still holds every letter and digit of the sentence."""
    letters = "".join(filter(str.isalnum, instruction.text.lower()))
    plain = unicodedata.normalize("NFC", letters)
    return plain == instruction.function_name.replace("_", "")
