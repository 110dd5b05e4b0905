"""``progprompt bench fuzz``: mutated programs and random text through the plan language."""

import click

from app.cli.bench_options import SEED
from app.evaluation.fuzz import fuzz_programs


@click.command()
@click.option("--cases", default=100_000, show_default=True, type=click.IntRange(min=1))
@SEED
def fuzz(cases: int, seed: int) -> None:
    """Parse, print and ground what nobody would write: only its own error may come of it."""
    report = fuzz_programs(cases, seed)
    click.echo(str(report))
    raise SystemExit(1 if report.broken else 0)
