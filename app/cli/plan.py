"""``progprompt plan``: one instruction, from the sentence to the scores, against a running service."""

import json
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click
from rich.console import Console

from app.cli.client import ServiceClient
from app.cli.endings import INTERRUPTED
from app.cli.narrator import Narrator

DEFAULT_URL = "http://127.0.0.1:8000"
BEST = "best"


@click.command()
@click.argument("instruction")
@click.option(
    "--scene",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    help="JSON file of the scene, as in POST /plans.",
)
@click.option("--after", "parent", help="Instead of a scene: the plan this one follows.")
@click.option("--robot", help="A robot of the catalogue; default the one the scene names.")
@click.option("--goal", "goals", multiple=True, help="A goal condition; give it several times.")
@click.option("--seed", default=0, show_default=True, help="Seed of free positions and sampling.")
@click.option("--planner", default=BEST, help="[default: the one that does best in the world]")
@click.option("--model", default="default", show_default=True)
@click.option(
    "--set",
    "switches",
    multiple=True,
    metavar="NAME=VALUE",
    help="Any other switch of the planner, like max_replans=2 or feedback=true.",
)
@click.option("--no-execute", is_flag=True, help="Plan only; move nothing.")
@click.option("--talk", is_flag=True, help="Go on asking what comes next; an empty line ends it.")
@click.option("--url", default=DEFAULT_URL, show_default=True, envvar="PROGPROMPT_URL")
@click.option("--json", "as_json", is_flag=True, help="Print the final resources as JSON.")
def command(  # noqa: PLR0913 - one parameter per option
    instruction: str,
    scene: Path | None,
    parent: str | None,
    robot: str | None,
    goals: tuple[str, ...],
    seed: int,
    planner: str,
    model: str,
    switches: tuple[str, ...],
    no_execute: bool,
    talk: bool,
    url: str,
    as_json: bool,
) -> None:
    """Plan INSTRUCTION in a scene and carry it out, telling every step."""
    if (scene is None) == (parent is None):
        raise click.UsageError("give either --scene or --after")
    if robot and parent:
        raise click.UsageError("a plan that follows another has its robot; leave --robot out")
    request: dict[str, Any] = {
        **(_read_scene(scene) if scene else {"parent": parent}),
        "instruction": instruction,
        "seed": seed,
        "execute": not no_execute,
        "planner": {"model": model, **_switches(switches)},
    }
    if robot:
        request["scene"]["robot"] = robot
    if planner != BEST:
        request["planner"]["name"] = planner
    if goals:
        request["goal"] = list(goals)
    with ServiceClient(url) as client:
        plan = carry_out(client, request, Console(stderr=as_json), as_json=as_json)
        while talk and (wish := _next_wish(plan)):
            request = following(request, plan["id"], wish)
            plan = carry_out(client, request, Console(stderr=as_json), as_json=as_json)
    raise SystemExit(0 if well_ended(plan) else 1)


def following(request: Mapping[str, Any], parent: str, wish: str) -> dict[str, Any]:
    """The request of the next sentence, with all that the first one's options asked for."""
    kept = {key: request[key] for key in ("seed", "execute", "planner")}
    return {"parent": parent, "instruction": wish, **kept}


def _switches(given: tuple[str, ...]) -> dict[str, Any]:
    """``max_replans=2`` as JSON has it; what is no JSON is taken as a word."""
    values: dict[str, Any] = {}
    for switch in given:
        name, equals, text = switch.partition("=")
        if not equals:
            raise click.UsageError(f"--set {switch}: should be NAME=VALUE")
        try:
            values[name] = json.loads(text)
        except ValueError:
            values[name] = text
    return values


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


def _next_wish(plan: Mapping[str, Any]) -> str:
    if not sys.stdin.isatty():
        return sys.stdin.readline().strip()
    question = (plan.get("declined") or {}).get("question") or "And then?"
    return str(click.prompt(question, default="", show_default=False)).strip()


def well_ended(plan: Mapping[str, Any]) -> bool:
    """Whether nothing went wrong with the plan."""
    return plan["status"] in ("succeeded", "planned", "awaiting_approval")


def carry_out(
    client: ServiceClient, request: dict[str, Any], console: Console, *, as_json: bool = False
) -> dict[str, Any]:
    """Post the request, narrate it to its end, through every new try, and give the plan."""
    narrator = Narrator(console)
    plan = client.create_plan(request)
    narrator.plan_accepted(plan)
    try:
        plan, execution = _followed(client, plan, narrator)
    except KeyboardInterrupt:
        client.cancel(f"/plans/{plan['id']}")
        console.print("\n[yellow]cancelled[/yellow]; the robot stops where it is")
        narrator.where_to_watch(client.url, plan)
        raise SystemExit(INTERRUPTED) from None
    if execution is not None:
        narrator.execution_over(plan, execution)
    narrator.where_to_watch(client.url, plan)
    if as_json:
        click.echo(json.dumps({"plan": plan, "execution": execution}))
    return plan


def _followed(
    client: ServiceClient, plan: dict[str, Any], narrator: Narrator
) -> tuple[dict[str, Any], dict[str, Any] | None]:
    """The plan at its end and its last execution, all told as it happens."""
    address = f"/plans/{plan['id']}"
    execution, last = None, -1
    while plan["status"] in ("queued", "planning", "executing"):
        for event in client.events(f"{address}/events", after=last):
            last = event.get("sequence", last)
            narrator.tell(event)
        plan = client.get(address)
        narrator.plan_ready(plan)
        if not plan["executions"]:
            break
        location = f"/executions/{plan['executions'][-1]}"
        for event in client.events(f"{location}/events"):
            narrator.tell(event)
        execution = client.get(location)
        plan = client.get(address)
    return plan, execution
