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
    "--id",
    "worker_id",
    required=True,
    help="Its name, like simulation-1: a worker that comes back under it goes on with its work.",
)
@click.option("--supervised", is_flag=True, hidden=True, help="End when standard input does.")
def command(queue: Queue, worker_id: str, supervised: bool) -> None:
    """Work on one queue of a service, until interrupted."""
    logging.basicConfig(level=logging.INFO, format=f"{worker_id}: %(message)s", stream=sys.stderr)
    for noisy in ("httpx", "alembic", "dbos"):
        logging.getLogger(noisy).setLevel(logging.WARNING)
    worker = create_worker(Settings.from_environment(), queue, worker_id)

    def stop(_number: int, _frame: FrameType | None) -> None:
        worker.stop()

    signal.signal(signal.SIGTERM, stop)
    signal.signal(signal.SIGINT, stop)
    if supervised:
        follow(sys.stdin.fileno(), worker.stop)
    worker.run()
    os._exit(0)  # The item under way runs in a thread that would keep the process alive.
