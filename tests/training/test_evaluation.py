import itertools

import pytest

from app.domain.llm import Completion, CompletionRequest, OnText
from app.programs.situated import question
from app.training import evaluation
from app.training.generator import generate
from app.training.suites import held_out


class Knowing:
    """A model that knows the answer to every question of the held-out suite."""

    name = "knowing"
    follows_grammar = True

    def __init__(self) -> None:
        self.answers = {
            part.question: part.target
            for example in itertools.islice(generate(7, "held"), 120)
            for part in example.parts
        }

    def complete(self, request: CompletionRequest, on_text: OnText | None = None) -> Completion:
        del on_text  # Unused.
        asked = request.prompt.rpartition('    """')[0].rpartition('    """')[2]
        found = next((t for q, t in self.answers.items() if request.prompt.endswith(q)), asked)
        return Completion(
            text=found.removesuffix("\n\n"),
            model=self.name,
            finish="stop",
            prompt_tokens=1,
            completion_tokens=1,
            seconds=0.5,
        )


def test_right_answers_are_found_right_under_the_trained_prompt() -> None:
    items = held_out(2)
    knowing = Knowing()
    answers = [evaluation.ask(knowing, item, evaluation.situated) for item in items]
    assert all(answer.right for answer in answers)


def test_figures_count_by_kind_with_intervals() -> None:
    items = held_out(1)[:4]
    answers = [
        evaluation.Answer(item, "", right, seconds=1.0)
        for item, right in zip(items, (True, True, True, False), strict=True)
    ]
    found = evaluation.figures(answers)
    overall = found["all"]
    assert isinstance(overall, dict)
    assert (overall["right"], overall["of"]) == (3, 4)
    assert overall["interval"] == pytest.approx([0.301, 0.954], abs=0.001)


def test_the_prompt_ends_where_the_body_begins() -> None:
    item = held_out(1)[0]
    assert evaluation.situated(item).endswith(question(item.sentence))
    assert evaluation.paper(item).endswith("]\n")
