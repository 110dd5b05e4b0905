"""The whole way to an adapter; every stage leaves a file, so that a second run takes up the first."""

import itertools
import json
import os
from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

from app.domain.llm import LanguageModel
from app.domain.planner import PlannerOptions
from app.llm.adapters import DRAFTS
from app.llm.backend import LlmConfig
from app.llm.backends.local import LocalModel
from app.llm.drafts import followers, write_drafts
from app.llm.models import open_model
from app.planners import planners
from app.training import evaluation, suites
from app.training.adapter import Card, read_adapter, sha256, write_adapter
from app.training.generator import generate
from app.training.network import LoraShape, Network
from app.training.recipe import Recipe
from app.training.training import Progress, Schedule, tokenize, train

if TYPE_CHECKING:
    from app.training.evaluation import Answer

Say = Callable[[str], None]


def run(recipe: Recipe, config: LlmConfig, compare: tuple[str, ...], say: Say) -> None:
    """Train, convert, measure, write the card.

    Raises:
        Conflict: the folder holds an adapter that was made by another recipe.
    """
    os.environ.setdefault("HF_HUB_OFFLINE", "1")
    recipe.out.mkdir(parents=True, exist_ok=True)
    trained = recipe.out / "training.json"
    if all(path.exists() for path in (recipe.adapter, recipe.drafts, trained)):
        recipe.check(json.loads(trained.read_text("utf-8")))
    else:
        progress = make_adapter(recipe, say)
        trained.write_text(json.dumps({**recipe.choices(), **asdict(progress)}), "utf-8")
    adapted = open_adapted(recipe.base, recipe.adapter, config)
    measured = {recipe.name: measure(recipe, adapted, "situated", recipe.name, say)}
    adapted.close()
    for name in compare:
        plain = open_model(name, config)
        label = f"{name}, the paper's prompt"
        measured[label] = measure(recipe, plain, "progprompt", f"plain-{name}", say)
    write_card(recipe, json.loads(trained.read_text("utf-8")), measured)
    say(f"{recipe.adapter} and its card are ready")


def make_adapter(recipe: Recipe, say: Say) -> Progress:
    """Train from the last checkpoint, or from nothing, and convert."""
    shape = LoraShape(first_layer=recipe.first_layer)
    network = Network(recipe.base, shape, recipe.threads, recipe.device)
    if recipe.start is not None:
        network.load(read_adapter(recipe.start))
    schedule = Schedule(
        examples=recipe.examples,
        minutes=recipe.minutes,
        rate=recipe.rate,
        seed=recipe.seed,
        data=recipe.data,
    )
    progress = train(network, schedule, recipe.out / "checkpoint.npz", say)
    write_adapter(network.arrays(), shape.alpha, recipe.base, recipe.adapter, recipe.name)
    examples = itertools.islice(generate(recipe.seed, "train", recipe.data), recipe.examples)
    write_drafts(recipe.drafts, followers(tokenize(network, each) for each in examples))
    return progress


def open_adapted(base: Path, adapter: Path, config: LlmConfig) -> LocalModel:
    """The base model with the adapter in force."""
    identity = f"{sha256(base)} {sha256(adapter)}"
    return LocalModel(base, adapter.stem, config, identity, adapter, adapter.with_suffix(DRAFTS))


def measure(
    recipe: Recipe, model: LanguageModel, planner: str, label: str, say: Say
) -> dict[str, object]:
    """Every suite's figures; each answer is kept in ``answers-<label>.jsonl``, right or wrong."""
    options = PlannerOptions(name=planner, model=model.name)
    asked: dict[str, Iterable[Answer]] = {
        path.stem: (
            evaluation.ask(planners[planner], model, item, options)
            for item in suites.read_suite(path)
        )
        for path in (suites.UNSEEN_VERBS, *recipe.suite)
    }
    if planner == "situated":
        examples = evaluation.held_out(recipe.per_kind, recipe.data)
        asked["held-out sentences"] = (evaluation.ask_sketch(model, each) for each in examples)
    found: dict[str, object] = {}
    with (recipe.out / f"answers-{label}.jsonl").open("w", encoding="utf-8") as log:
        for name, answers in asked.items():
            given: list[Answer] = []
            for answer in answers:
                given.append(answer)
                log.write(json.dumps({"suite": name, **asdict(answer)}, ensure_ascii=False) + "\n")
                log.flush()
            found[name] = evaluation.figures(given)
            say(f"{label} on {name}: {found[name]}")
    return found


def write_card(recipe: Recipe, facts: dict[str, object], measured: Mapping[str, object]) -> None:
    """``<name>.json`` beside the adapter."""
    card = Card(
        name=recipe.name,
        base=recipe.base.name,
        base_sha256=sha256(recipe.base),
        adapter_sha256=sha256(recipe.adapter),
        drafts_sha256=sha256(recipe.drafts),
        training={"rank": LoraShape().rank, **facts},
        figures=dict(measured),
    )
    card.write(recipe.adapter.with_suffix(".json"))
