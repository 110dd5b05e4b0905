"""``progprompt train``: an adapter of one's own, from nothing, on an ordinary computer."""

import os
from pathlib import Path
from typing import cast

import click
from click.core import ParameterSource
from rich.console import Console

from app.llm.backend import PROCESS_ENVIRONMENT
from app.llm.models import find_model
from app.llm.sources import weight_store
from app.main.models import llm_config
from app.settings import Settings
from app.training.recipe import Recipe

QUICK = {"examples": 3000, "minutes": 28.0, "per_kind": 3}
"""What --quick sets, but for what is given as well."""


@click.command()
@click.option("--base", default="small", show_default=True, help="The model to adapt.")
@click.option("--out", type=click.Path(path_type=Path), default=Path("adapter"), show_default=True)
@click.option("--quick", is_flag=True, help="A small run, within 40 minutes on two cores.")
@click.option("--examples", default=6000, show_default=True, help="Made-up sentences, each once.")
@click.option("--minutes", default=120.0, show_default=True, help="End training after this long.")
@click.option("--threads", default=2, show_default=True)
@click.option("--device", default="cpu", show_default=True, help="cpu, or cuda where there is one.")
@click.option("--seed", default=1, show_default=True)
@click.option(
    "--first-layer", default=4, show_default=True, help="Adapt this layer and those above."
)
@click.option("--rate", default=6e-4, show_default=True, help="Of learning, at its height.")
@click.option(
    "--start",
    type=click.Path(path_type=Path, exists=True, dir_okay=False),
    default=None,
    help="Go on from this adapter (.gguf) of the same base and layers, at a lower --rate.",
)
@click.option("--per-kind", default=10, show_default=True, help="Held-out sentences of each kind.")
@click.option(
    "--data",
    type=click.Path(path_type=Path, exists=True, file_okay=False),
    default=None,
    help="A folder of JSON files that lengthen those of static/training: verbs, objects, phrasings.",
)
@click.option(
    "--suite",
    type=click.Path(path_type=Path, exists=True),
    multiple=True,
    help="More instructions to measure on, as JSON lines.",
)
@click.option(
    "--compare",
    multiple=True,
    help="Measure this plain model with the paper's prompt too; may be given several times.",
)
@click.pass_context
def command(
    context: click.Context, *, quick: bool, base: str, out: Path, **options: object
) -> None:
    """Generate sentences, train on them, convert, measure, write a card; run again to resume."""
    os.environ.update(PROCESS_ENVIRONMENT)  # before torch loads the thread library
    try:
        # The extra "train" is large; every other command must start without it.
        from app.training import pipeline  # noqa: PLC0415
    except ModuleNotFoundError as error:
        raise click.ClickException(
            "training needs: pip install 'progprompt[train,local]'"
        ) from error
    config = llm_config(Settings.from_environment())
    weights = find_model(base, config).weights
    if weights is None:
        raise click.BadParameter(f"{base} has no file of weights", param_hint="--base")
    file = weight_store(config).ensure(weights)
    compare = cast("tuple[str, ...]", options.pop("compare"))
    if quick:
        options |= {name: value for name, value in QUICK.items() if not _is_given(context, name)}
    recipe = Recipe(name=out.name, base=file, out=out, **options)  # pyright: ignore[reportArgumentType]
    pipeline.run(recipe, config, compare, Console().print)


def _is_given(context: click.Context, name: str) -> bool:
    return context.get_parameter_source(name) is not ParameterSource.DEFAULT
