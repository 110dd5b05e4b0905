"""``progprompt demo``: a real instruction end to end, from a fresh installation."""

import json
import os
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import click
from rich.console import Console

from app.cli.client import ServiceClient
from app.cli.endings import interrupted
from app.cli.models import fetch
from app.cli.plan import carry_out, well_ended

SCENE = Path(__file__).parents[2] / "static" / "scenes" / "sort-fruits-and-bottles.json"
READY_LIMIT = 180.0  # [s], generous: a cold disk reads the weights in it
STOP_LIMIT = 15.0  # [s]


@click.command()
@click.option("--port", default=8000, show_default=True, help="0 takes any free one.")
@click.option("--data-dir", type=click.Path(path_type=Path), help="Where runs are kept.")
@click.option("--model", default="default", show_default=True)
@click.option(
    "--keep/--no-keep",
    default=None,
    help="Leave the service running afterwards; the default on a terminal.",
)
@click.pass_context
def command(
    context: click.Context, port: int, data_dir: Path | None, model: str, keep: bool | None
) -> None:
    """Fetch the model, start the service, and run the paper's sorting task to its scores."""
    console = Console()
    context.invoke(fetch, name=model)
    keep = sys.stdout.isatty() if keep is None else keep
    port = port if port and not _taken(port) else _free_port()
    url = f"http://127.0.0.1:{port}"
    options = [f"--port={port}", f"--model={model}"]
    if data_dir is not None:
        options.append(f"--data-dir={data_dir}")
    with interrupted(), _service(options) as process, ServiceClient(url) as client:
        _wait_until_ready(process, client, console)
        request = json.loads(SCENE.read_text(encoding="utf-8"))
        asked = {key: request[key] for key in ("scene", "instruction", "goal")}
        succeeded = well_ended(carry_out(client, {**asked, "planner": {"model": model}}, console))
        if keep:
            console.print("[dim]the service goes on; Ctrl-C stops it[/dim]")
            _until_interrupted(process)
        else:
            again = " ".join(["progprompt serve", *options])
            console.print("[dim]the run is kept; to watch it, start the service:[/dim]")
            click.echo(again)  # unbroken, to be copied
    raise SystemExit(0 if succeeded else 1)


@contextmanager
def _service(options: list[str]) -> Iterator[subprocess.Popen[bytes]]:
    """``progprompt serve`` as a child, its output kept in a file and stopped at the end."""
    with tempfile.NamedTemporaryFile("w+", prefix="progprompt-demo-", suffix=".log") as log:
        process = subprocess.Popen(
            [sys.executable, "-m", "app.cli", "serve", *options],
            stdout=log,
            stderr=subprocess.STDOUT,
            env=os.environ,
        )
        try:
            yield process
        except click.ClickException as error:
            log.seek(0)
            raise click.ClickException(
                f"{error.message}\n--- the service's last lines ---\n{log.read()[-2000:]}"
            ) from error
        finally:
            process.terminate()
            try:
                process.wait(STOP_LIMIT)
            except subprocess.TimeoutExpired:
                process.kill()


def _wait_until_ready(
    process: subprocess.Popen[bytes], client: ServiceClient, console: Console
) -> None:
    deadline = time.monotonic() + READY_LIMIT
    with console.status("starting the service") as status:
        while time.monotonic() < deadline:
            if process.poll() is not None:
                raise click.ClickException(f"the service ended with code {process.returncode}")
            ready, waits_for = client.readiness()
            if ready:
                return
            status.update(f"starting the service: {waits_for}")
            time.sleep(0.2)
    raise click.ClickException(f"the service was not ready within {READY_LIMIT:.0f} s")


def _until_interrupted(process: subprocess.Popen[bytes]) -> None:
    try:
        process.wait()
    except KeyboardInterrupt:
        return


def _taken(port: int) -> bool:
    with socket.socket() as probe:
        return probe.connect_ex(("127.0.0.1", port)) == 0


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]
