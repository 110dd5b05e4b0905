"""``progprompt models``: which language models there are, and their weights."""

import json
from collections.abc import Iterator
from contextlib import contextmanager

import click
from rich.console import Console
from rich.markup import escape
from rich.progress import (
    BarColumn,
    DownloadColumn,
    Progress,
    TextColumn,
    TimeRemainingColumn,
    TransferSpeedColumn,
)

from app.llm.embeddings import EMBEDDINGS, embedding_store
from app.llm.models import LlmConfig, ModelSpec, catalogue, find_model
from app.llm.sources import weight_store
from app.llm.weights import Progress as OnProgress
from app.llm.weights import WeightStore
from app.main.models import llm_config
from app.settings import Settings

LINES = 20
"""Lines that tell of a whole download where there is no terminal to draw a bar on."""


AS_JSON = click.option("--json", "as_json", is_flag=True, help="For programs, not for people.")


@click.group(invoke_without_command=True)
@AS_JSON
@click.pass_context
def command(context: click.Context, as_json: bool) -> None:
    """List the language models (the default); fetch and verify their weights."""
    if context.invoked_subcommand is None:
        context.invoke(list_models, as_json=as_json)


@command.command("list")
@AS_JSON
def list_models(as_json: bool) -> None:
    """List the models: size, licence, and whether their weights are here."""
    config = llm_config(Settings.from_environment())
    store = weight_store(config)
    if as_json:
        rows = [_row(spec, store) for spec in catalogue(config)]
        click.echo(json.dumps({"items": rows}, indent=2))
        return
    for spec in catalogue(config):
        name = ", ".join((spec.name, *spec.aliases))
        size = f"{spec.weights.bytes / 1e6:,.0f} MB" if spec.weights else ""
        status = store.status(spec.weights) if spec.weights else "not needed"
        where = str(store.path(spec.weights)) if spec.weights else spec.title
        click.echo("  ".join(part for part in (name, size, status, spec.licence) if part))
        click.echo(f"    {where}")


@command.command()
@click.argument("name", default="default")
@click.option("--verify", "fully", is_flag=True, help="Read it all again if it is here already.")
def fetch(name: str, fully: bool = False) -> None:
    """Fetch the weights of the model NAME (without it, the default model's) and verify them.

    An adapted model comes with the sentence embeddings by which its planner tells what is meant.
    """
    spec, config = _find(name)
    if spec.weights is None:
        click.echo(f"{spec.name} needs no weights", err=True)
        return
    wanted = [(spec.weights, weight_store(config, _notice))]
    if spec.adapter is not None:
        wanted += [(each, embedding_store(each, config, _notice)) for each in EMBEDDINGS]
    for weights, store in wanted:
        with _progress() as progress:
            path = store.ensure(weights, progress, fully=fully)
        click.echo(f"{weights.name}: {path}")


@command.command()
@click.argument("name", default="default")
def verify(name: str) -> None:
    """Compare the checksum of every byte of the weights of the model NAME."""
    spec, config = _find(name)
    if spec.weights is None:
        click.echo(f"{spec.name} needs no weights", err=True)
        return
    store = weight_store(config, _notice)
    store.verify(spec.weights)
    path = store.path(spec.weights)
    click.echo(f"{path}: {spec.weights.bytes:,} bytes, sha256 {spec.weights.sha256}, as it should")


def _find(name: str) -> tuple[ModelSpec, LlmConfig]:
    settings = Settings.from_environment()
    config = llm_config(settings)
    return find_model(settings.model if name == "default" else name, config), config


def _notice(said: str) -> None:
    click.echo(said, err=True)


def _row(spec: ModelSpec, store: WeightStore) -> dict[str, object]:
    row: dict[str, object] = {
        "name": spec.name,
        "aliases": spec.aliases,
        "title": spec.title,
        "backend": spec.backend,
        "licence": spec.licence,
    }
    if spec.weights:
        row |= {
            "bytes": spec.weights.bytes,
            "sha256": spec.weights.sha256,
            "status": store.status(spec.weights),
            "bytes_present": store.bytes_present(spec.weights),
            "path": str(store.path(spec.weights)),
        }
    return row


@contextmanager
def _progress() -> Iterator[OnProgress]:
    console = Console(stderr=True)
    if not console.is_terminal:
        yield _plain_lines()
        return
    columns = (TextColumn("{task.description}"), BarColumn(), DownloadColumn())
    bar = Progress(*columns, TransferSpeedColumn(), TimeRemainingColumn(), console=console)
    with bar:
        task = bar.add_task("weights", total=None, visible=False)

        def draw(done: int, total: int, source: str) -> None:
            bar.update(task, completed=done, total=total, description=escape(source), visible=True)

        yield draw


def _plain_lines() -> OnProgress:
    told = -1

    def tell(done: int, total: int, source: str) -> None:
        nonlocal told
        if (step := done * LINES // total) > told:
            told = step
            click.echo(f"{done / 1e6:,.0f} of {total / 1e6:,.0f} MB from {source}", err=True)

    return tell
