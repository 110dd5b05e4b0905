"""``progprompt serve``: the service and its workers, in one command."""

import fcntl
import logging
import os
import socket
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import click
import uvicorn

from app.cli.endings import interrupted
from app.cli.supervisor import Supervisor
from app.main.database import migrate, waits_for
from app.main.service import create_service
from app.settings import Settings

READY_POLL = 0.1  # [s]
SHUTDOWN_LIMIT = 1  # [s] that open event streams are given


@click.command()
@click.option("--host", help="Address to listen on.  [default: 127.0.0.1]")
@click.option(
    "--port", type=click.IntRange(0, 65535), help="0 takes any free one.  [default: 8000]"
)
@click.option(
    "--data-dir",
    type=click.Path(file_okay=False, path_type=Path),
    help="Where everything is kept.  [default: ~/.local/share/progprompt]",
)
@click.option("--model", help="What the model 'default' stands for, loaded at start.")
@click.option(
    "--household-data",
    type=click.Path(exists=True, file_okay=False, path_type=Path),
    help="Folder of the graphs env0.json … to use instead of our own homes.",
)
@click.option("--planning-workers", type=click.IntRange(0, 64), help="[default: 1]")
@click.option("--simulation-workers", type=click.IntRange(0, 64), help="[default: 1]")
def command(**given: object) -> None:
    """Serve the API, the page and the viewer; plan and simulate in worker processes."""
    settings = Settings.from_environment()
    chosen = {name: value for name, value in given.items() if value is not None}
    settings = replace(settings, **chosen)  # pyright: ignore[reportArgumentType]
    logging.basicConfig(level=logging.WARNING, format="service: %(message)s", stream=sys.stderr)
    settings.data.mkdir(parents=True, exist_ok=True)
    with _only_one(settings.data), _listening(settings) as (listener, url):
        click.echo(f"data in {settings.data}")
        migrate(settings)
        _serve(settings, listener, url)


def _serve(settings: Settings, listener: socket.socket, url: str) -> None:
    supervisor = Supervisor(settings.to_environment())
    supervisor.start("planning", settings.planning_workers)
    supervisor.start("simulation", settings.simulation_workers)
    stopping = threading.Event()
    telling = threading.Thread(target=_tell_when_ready, args=(settings, url, stopping), daemon=True)
    try:
        with interrupted():
            config = uvicorn.Config(
                create_service(settings),
                log_level="warning",
                timeout_graceful_shutdown=SHUTDOWN_LIMIT,
                ws_max_size=2**26,
                ws_per_message_deflate=False,  # viser compresses what is worth it
            )
            telling.start()
            uvicorn.Server(config).run(sockets=[listener])
    except KeyboardInterrupt:
        pass
    finally:
        stopping.set()
        click.echo("stopping the workers")
        supervisor.stop()
        click.echo("stopped; everything is kept")


def _tell_when_ready(settings: Settings, url: str, stopping: threading.Event) -> None:
    """Say what is being waited for, and then where the service is."""
    told = ""
    while not stopping.wait(READY_POLL):
        waiting = "; ".join(waits_for(settings))
        if not waiting:
            click.echo(f"ready: {url}")
            return
        if waiting != told:
            told = waiting
            click.echo(f"waiting for {waiting}")


@contextmanager
def _only_one(data: Path) -> Iterator[None]:
    """Hold the data directory: a second service on it would be a slip, not a wish."""
    with (data / "serve.lock").open("a+") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            lock.seek(0)
            raise click.ClickException(
                f"{data} is in use by another service (process {lock.read().strip() or '?'}); "
                "stop it, or choose another directory with --data-dir"
            ) from error
        lock.truncate(0)
        lock.write(f"{os.getpid()}\n")
        lock.flush()
        yield


@contextmanager
def _listening(settings: Settings) -> Iterator[tuple[socket.socket, str]]:
    """The listening socket, opened before anything is started, and the service's URL."""
    family = socket.AF_INET6 if ":" in settings.host else socket.AF_INET
    # asyncio turns off Nagle's delay (40 ms for every answer) only where TCP is named.
    with socket.socket(family, socket.SOCK_STREAM, socket.IPPROTO_TCP) as listener:
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            listener.bind((settings.host, settings.port))
        except OSError as error:
            raise click.ClickException(
                f"cannot listen on {settings.host}:{settings.port}: {error.strerror}; "
                "choose another --port"
            ) from error
        host = f"[{settings.host}]" if family == socket.AF_INET6 else settings.host
        yield listener, f"http://{host}:{listener.getsockname()[1]}"
