"""The whole way to an adapter; every stage leaves a file, so that a second run takes up the first."""

import json
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from app.domain.llm import LanguageModel
from app.llm.backend import LlmConfig
from app.llm.backends.local import LocalModel
from app.llm.models import open_model
from app.training import evaluation, suites
from app.training.adapter import Card, sha256, write_adapter
from app.training.network import LoraShape, Network
from app.training.training import Progress, Schedule, train

Say = Callable[[str], None]


@dataclass(frozen=True, slots=True, kw_only=True)
class Recipe:
    """What to make, of what, how and where."""

    name: str
    base: Path
    out: Path
    """A folder, made if need be."""
    scenes: int = 1200
    minutes: float = 120.0
    threads: int = 2
    seed: int = 1
    first_layer: int = 6
    per_kind: int = 5
    suite: tuple[Path, ...] = ()

    @property
    def adapter(self) -> Path:
        """The file it is all for."""
        return self.out / f"{self.name}.gguf"


def run(recipe: Recipe, config: LlmConfig, compare: str | None, say: Say) -> None:
    """Train, convert, measure, write the card."""
    os.environ.setdefault("HF_HUB_OFFLINE", "1")
    recipe.out.mkdir(parents=True, exist_ok=True)
    trained = recipe.out / "training.json"
    if not (recipe.adapter.exists() and trained.exists()):
        progress = make_adapter(recipe, say)
        facts = {name: getattr(progress, name) for name in Progress.__slots__}
        trained.write_text(json.dumps(facts), "utf-8")
    adapted = open_adapted(recipe.base, recipe.adapter, config)
    measured = {recipe.name: measure(recipe, adapted, evaluation.situated, "adapted", say)}
    adapted.close()
    if compare:
        plain = open_model(compare, config)
        label = f"{compare}, the paper's prompt"
        measured[label] = measure(recipe, plain, evaluation.paper, f"plain-{compare}", say)
    write_card(recipe, json.loads(trained.read_text("utf-8")), measured)
    say(f"{recipe.adapter} and its card are ready")


def make_adapter(recipe: Recipe, say: Say) -> Progress:
    """Train from the last checkpoint, or from nothing, and convert."""
    shape = LoraShape(first_layer=recipe.first_layer)
    network = Network(recipe.base, shape, recipe.threads)
    schedule = Schedule(scenes=recipe.scenes, minutes=recipe.minutes, seed=recipe.seed)
    progress = train(network, schedule, recipe.out / "checkpoint.npz", say)
    write_adapter(network.arrays(), shape.alpha, recipe.base, recipe.adapter, recipe.name)
    return progress


def open_adapted(base: Path, adapter: Path, config: LlmConfig) -> LocalModel:
    """The base model with the adapter in force."""
    identity = f"{sha256(base)} {sha256(adapter)}"
    return LocalModel(base, adapter.stem, config, identity, adapter)


def measure(
    recipe: Recipe, model: LanguageModel, write: evaluation.WritePrompt, label: str, say: Say
) -> dict[str, object]:
    """Every suite's figures; each answer is kept in ``answers-<label>.jsonl``, right or wrong."""
    named = {"held out": suites.held_out(recipe.per_kind)}
    named |= {path.stem: suites.read_suite(path) for path in recipe.suite}
    found: dict[str, object] = {}
    with (recipe.out / f"answers-{label}.jsonl").open("w", encoding="utf-8") as log:
        for name, items in named.items():
            answers: list[evaluation.Answer] = []
            for item in items:
                answers.append(evaluation.ask(model, item, write))
                log.write(_line(name, answers[-1]))
                log.flush()
            found[name] = evaluation.figures(answers)
            say(f"{label} on {name}: {found[name]}")
    return found


def write_card(recipe: Recipe, facts: dict[str, object], measured: Mapping[str, object]) -> None:
    """``<name>.json`` beside the adapter."""
    card = Card(
        name=recipe.name,
        base=recipe.base.name,
        base_sha256=sha256(recipe.base),
        adapter_sha256=sha256(recipe.adapter),
        training={"seed": recipe.seed, "first_layer": recipe.first_layer, "rank": 16, **facts},
        figures=dict(measured),
    )
    card.write(recipe.adapter.with_suffix(".json"))


def _line(suite: str, answer: evaluation.Answer) -> str:
    item = answer.item
    shown = {"suite": suite, "name": item.name, "kind": item.kind, "sentence": item.sentence}
    shown |= {"objects": item.objects, "right": answer.right, "completion": answer.completion}
    return json.dumps({**shown, "seconds": round(answer.seconds, 2)}, ensure_ascii=False) + "\n"
