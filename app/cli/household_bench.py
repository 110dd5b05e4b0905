"""``progprompt bench household``: one action of the household, and a long plan."""

import dataclasses
import json

import click

from app.cli.bench_options import AS_JSON
from app.evaluation.household_speed import LONG, HouseholdSpeed, bench_household


@click.command()
@AS_JSON
def household(as_json: bool) -> None:
    """Actions and plans of the example programs, without any model."""
    measured = bench_household()
    click.echo(json.dumps(dataclasses.asdict(measured)) if as_json else _text(measured))


def _text(measured: HouseholdSpeed) -> str:
    action, plan = measured.action_seconds, measured.plan_seconds
    return (
        f"an action    {1000 * action[0]:.3f} ms (95 % within {1000 * action[1]:.3f}), "
        f"{measured.actions} actions\n"
        f"a plan       {1000 * plan[0]:.2f} ms (95 % within {1000 * plan[1]:.2f}), "
        f"{measured.plans} plans of {LONG} steps and more, median {measured.steps:.0f}, "
        "with their assertions"
    )
