"""``progprompt plan``: one instruction, from the sentence to the scores, against a running service."""

import json
from pathlib import Path
from typing import Any

import click
from rich.console import Console

from app.cli.client import ServiceClient
from app.cli.narrator import Narrator

DEFAULT_URL = "http://127.0.0.1:8000"


@click.command()
@click.argument("instruction")
@click.option(
    "--scene",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    required=True,
    help="JSON file of the scene, as in POST /plans.",
)
@click.option("--goal", "goals", multiple=True, help="A goal condition; give it several times.")
@click.option("--seed", default=0, show_default=True, help="Seed of free positions and sampling.")
@click.option("--model", default="default", show_default=True)
@click.option("--no-execute", is_flag=True, help="Plan only; move nothing.")
@click.option("--url", default=DEFAULT_URL, show_default=True, envvar="PROGPROMPT_URL")
@click.option("--json", "as_json", is_flag=True, help="Print the final resources as JSON.")
def command(  # noqa: PLR0913 - one parameter per option
    instruction: str,
    scene: Path,
    goals: tuple[str, ...],
    seed: int,
    model: str,
    no_execute: bool,
    url: str,
    as_json: bool,
) -> None:
    """Plan INSTRUCTION in a scene and carry it out, telling every step."""
    request = {
        **_read_scene(scene),
        "instruction": instruction,
        "seed": seed,
        "execute": not no_execute,
        "planner": {"model": model},
    }
    if goals:
        request["goal"] = list(goals)
    with ServiceClient(url) as client:
        succeeded = carry_out(client, request, Console(stderr=as_json), as_json=as_json)
    raise SystemExit(0 if succeeded else 1)


def _read_scene(path: Path) -> dict[str, Any]:
    """The scene of a file: either the bare scene, or an object with ``scene`` (and ``goal``)."""
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except ValueError as error:
        raise click.ClickException(f"{path} is not JSON: {error}") from error
    if not isinstance(content, dict):
        raise click.ClickException(f"{path} should hold a JSON object with 'world' and 'objects'")
    if "scene" not in content:
        return {"scene": content}
    return {key: content[key] for key in ("scene", "goal") if key in content}


def carry_out(
    client: ServiceClient, request: dict[str, Any], console: Console, *, as_json: bool = False
) -> bool:
    """Post the request, narrate it to its end, and tell whether it succeeded."""
    narrator = Narrator(console)
    plan = client.create_plan(request)
    narrator.plan_accepted(plan)
    for event in client.events(f"/plans/{plan['id']}/events"):
        narrator.tell(event)
    plan = client.get(f"/plans/{plan['id']}")
    narrator.plan_ready(plan)
    execution = None
    if plan["executions"]:
        location = f"/executions/{plan['executions'][-1]}"
        for event in client.events(f"{location}/events"):
            narrator.tell(event)
        execution = client.get(location)
        plan = client.get(f"/plans/{plan['id']}")
        narrator.execution_over(plan, execution)
    narrator.where_to_watch(client.url, plan)
    if as_json:
        click.echo(json.dumps({"plan": plan, "execution": execution}))
    return plan["status"] in ("succeeded", "planned", "awaiting_approval")
