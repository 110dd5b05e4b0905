"""``progprompt worker``: one worker process; ``serve`` starts these itself."""

import logging
import os
import signal
import sys
from types import FrameType

import click

from app.lifeline import follow
from app.main.worker import create_worker
from app.settings import Settings
from app.storage.jobs import QUEUES, Queue


@click.command()
@click.option("--queue", type=click.Choice(QUEUES), required=True, help="What it works on.")
@click.option(
    "--name",
    "--id",
    "name",
    help="What its id begins with, like simulation-1.  [default: its queue]",
)
@click.option("--supervised", is_flag=True, hidden=True, help="End when standard input does.")
def command(queue: Queue, name: str | None, supervised: bool) -> None:
    """Work on one queue of a service, until interrupted."""
    name = name or queue
    logging.basicConfig(level=logging.INFO, format=f"{name}: %(message)s", stream=sys.stderr)
    for noisy in ("httpx", "alembic", "dbos"):
        logging.getLogger(noisy).setLevel(logging.WARNING)
    worker = create_worker(Settings.from_environment(), queue, name)

    def stop(_number: int, _frame: FrameType | None) -> None:
        worker.stop()

    signal.signal(signal.SIGTERM, stop)
    signal.signal(signal.SIGINT, stop)
    if supervised:
        follow(sys.stdin.fileno(), worker.stop)
    worker.run()
    os._exit(0)  # The item under way runs in a thread that would keep the process alive.
