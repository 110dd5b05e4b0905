"""``progprompt robot``: let a real arm do what an execution did."""

import click

from app.cli.client import ServiceClient
from app.robots.playback import trajectory_of
from app.robots.websocket import WebSocketRobot
from app.worlds.simulators.mujoco.arms import DEFAULT_ARM, arms
from app.worlds.tabletop import Tabletop


@click.group()
def command() -> None:
    """Send what was carried out in simulation to a robot arm."""


@command.command()
@click.argument("execution_id")
@click.option("--url", required=True, help="The robot's WebSocket, like ws://127.0.0.1:9000.")
@click.option("--live", is_flag=True, help="Really send; without it everything is only checked.")
@click.option(
    "--service", default="http://127.0.0.1:8000", show_default=True, help="The service's URL."
)
@click.option("--grip-force", default=30.0, show_default=True, help="Of the fingers [N].")
@click.option("--patience", default=2.0, show_default=True, help="With a silent robot [s].")
def send(
    execution_id: str, url: str, live: bool, service: str, grip_force: float, patience: float
) -> None:
    """Stream the arm's motion of EXECUTION_ID, checked against speed, force and workspace limits."""
    with ServiceClient(service) as client:
        scene = client.get(f"/executions/{execution_id}")["scene"]
        packed, width = client.frames(execution_id)
    if scene["world"] != Tabletop.name:
        raise click.ClickException("only what was carried out on the tabletop can be sent")
    arm = arms[scene["robot"] or DEFAULT_ARM]
    robot = WebSocketRobot(url, arm, live=live, patience=patience)
    carried = robot.execute(trajectory_of(packed, width, arm, grip_force=grip_force))
    done = "sent" if carried.live else "checked, not sent (--live sends)"
    click.echo(f"{arm.title}: {carried.points} points over {carried.duration:.1f} s: {done}")
