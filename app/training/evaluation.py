"""How often plans are right: strict Plan SR of a model with a prompt, by kind of task.

Strictly: the goal is met where nothing slips, no other object was moved, and what cannot be done
moves nothing.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

from app.domain.instruction import Instruction
from app.domain.llm import CompletionRequest, LanguageModel
from app.domain.planner import PlannerOptions, Task
from app.domain.scene import Scene, SceneObject
from app.evaluation.intervals import wilson
from app.llm.grammar import program_grammar
from app.programs.printer import import_line
from app.programs.prompt import write_prompt
from app.programs.situated import STOP, situated_prompt, spoken_of
from app.training.executor import outcome
from app.training.suites import Item

MAX_TOKENS = 400

WritePrompt = Callable[[Item], str]


@dataclass(frozen=True, slots=True)
class Answer:
    """What a model made of one instruction."""

    item: Item
    completion: str
    right: bool
    seconds: float


def situated(item: Item) -> str:
    """The prompt the adapters were trained on."""
    described = spoken_of(item.objects, item.sentence)
    return situated_prompt(import_line(item.actions), described, item.sentence)


def paper(item: Item) -> str:
    """The paper's prompt with three example programs."""
    return write_prompt(_task(item))


def ask(model: LanguageModel, item: Item, write: WritePrompt) -> Answer:
    """One instruction, decoded under the scene's grammar."""
    task = _task(item)
    request = CompletionRequest(
        prompt=write(item),
        max_tokens=MAX_TOKENS,
        stop=(STOP,),
        grammar=program_grammar(task.scene, task.actions, comments=True, feedback=False),
    )
    completion = model.complete(request)
    done = outcome(completion.text, tuple(item.objects), item.puts)
    right = completion.finish == "stop" and item.check(done)
    return Answer(item, completion.text, right, completion.seconds)


def figures(answers: Sequence[Answer]) -> dict[str, object]:
    """Rates with 95 % Wilson intervals, overall and by kind."""
    kinds = sorted({answer.item.kind for answer in answers})
    by_kind = {kind: _rate(a for a in answers if a.item.kind == kind) for kind in kinds}
    seconds = sorted(answer.seconds for answer in answers)
    median = round(seconds[len(seconds) // 2], 2) if seconds else None
    return {"all": _rate(answers), "median_seconds": median, "kinds": by_kind}


def _rate(answers: Iterable[Answer]) -> dict[str, object]:
    right = [answer.right for answer in answers]
    low, high = wilson(sum(right), len(right))
    return {"right": sum(right), "of": len(right), "interval": [round(low, 3), round(high, 3)]}


def _task(item: Item) -> Task:
    objects = tuple(SceneObject(name=name) for name in item.objects)
    return Task(
        scene=Scene(world="tabletop", objects=objects),
        actions=item.actions,
        instruction=Instruction(item.sentence),
        options=PlannerOptions(),
    )
