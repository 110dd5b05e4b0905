"""An example: what a model is shown, and what it is to write."""

from dataclasses import dataclass

from app.domain.action import ActionSignature
from app.domain.planner import Turn
from app.programs.sketches.parser import parse_sketch, print_sketch
from app.programs.sketches.prompt import write_sketch_prompt
from app.programs.sketches.sketch import Decline, SketchCall


@dataclass(frozen=True, slots=True)
class Example:
    """What a model is shown, and what it is to write."""

    kind: str
    sentence: str
    actions: tuple[ActionSignature, ...]
    history: tuple[Turn, ...]
    target: str
    """Indented lines, then the empty line that ends them."""

    @property
    def prompt(self) -> str:
        """Exactly what the planner asks with."""
        return write_sketch_prompt(self.sentence, self.actions, self.history)


def checked(example: Example) -> Example:
    """Raises where the sketch does not read back as it was written, or calls what is not offered."""
    sketch = parse_sketch(example.target)
    if parse_sketch(print_sketch(sketch)) != sketch:
        raise ValueError(f"{example.target!r} reads back as {print_sketch(sketch)!r}")
    arity = {action.name: len(action.parameters) for action in example.actions}
    for statement in sketch.body:
        match statement:
            case SketchCall(action, arguments):
                if arity.get(action) != len(arguments):
                    raise ValueError(f"{statement} does not fit {example.prompt!r}")
            case Decline():
                pass
    return example
