"""``progprompt bench model``: how fast language models are on this machine."""

import dataclasses
import json

import click
from rich.console import Console

from app.evaluation.model_speed import CANDIDATES, ModelSpeed, bench_model
from app.llm.models import open_model
from app.main.models import llm_config
from app.settings import Settings


@click.command()
@click.option("--model", "models", multiple=True, default=("default",), show_default=True)
@click.option("--json", "as_json", is_flag=True, help="One JSON array on standard output.")
def model(models: tuple[str, ...], as_json: bool) -> None:
    """Reading, writing, ending when asked to, scoring of candidates."""
    config = llm_config(Settings.from_environment())
    rows: list[ModelSpeed] = []
    for name in models:
        with Console(stderr=True).status(f"measuring {name}"):
            rows.append(bench_model(open_model(name, config)))
        if not as_json:
            click.echo(_text(rows[-1]))
    if as_json:
        click.echo(json.dumps([dataclasses.asdict(row) for row in rows]))


def _text(row: ModelSpeed) -> str:
    def ending(seconds: tuple[float, float]) -> str:
        return f"{seconds[0]:.2f} s (longest {seconds[1]:.2f})"

    scoring = (
        "tells no probabilities"
        if row.score_seconds is None
        else f"scores {CANDIDATES} candidates in {row.score_seconds:.2f} s"
    )
    return (
        f"{row.model} | reads {row.read_per_second:.0f} tokens/s, writes "
        f"{row.written_per_second:.1f} | ends {ending(row.cancel_writing)} after it is asked to "
        f"while writing, {ending(row.cancel_reading)} while reading | {scoring}"
    )
