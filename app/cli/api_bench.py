"""What ``progprompt bench api`` measures: a service of its own under load."""

import dataclasses
import json
import os
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager

import click
import httpx

from app.cli.endings import interrupted
from app.evaluation.service_load import LoadRow, bench_request, http_request

SCENE = {"objects": [{"name": name} for name in ("banana", "apple", "bowl", "plate")]}
FILM = {
    "scene": SCENE,
    "program": "def tidy():\n    grab_and_putin('banana', 'bowl')\n"
    "    grab_and_putin('apple', 'plate')\n",
}
WISH = {"scene": SCENE, "instruction": "put the banana in the bowl", "goal": ["in(banana, bowl)"]}
START_LIMIT = 60.0  # [s]


@click.command()
@click.option("--viewers", default=30, show_default=True, type=click.IntRange(0, 500))
@click.option("--seconds", default=5.0, show_default=True, type=click.FloatRange(0.5, 600),
              help="How long each kind of request is sent.")  # fmt: skip
@click.option("--json", "as_json", is_flag=True, help="One JSON array on standard output.")
def api(viewers: int, seconds: float, as_json: bool) -> None:
    """Reads and accepted writes per second of one service process, while browsers watch.

    Starts a service of its own in a folder that is thrown away. Nothing plans meanwhile: a write
    is accepted when it is stored and queued.
    """
    rows: list[LoadRow] = []
    with interrupted(), _service() as url:
        plan, film = _carried_out(url)
        reads = {"GET /plans/{id}": plan, "GET /executions/{id}": film, "GET /plans": "/plans"}
        requests = {name: http_request(url, "GET", path) for name, path in reads.items()}
        requests["POST /plans"] = http_request(url, "POST", "/plans", WISH)
        for number in dict.fromkeys((0, viewers)):
            films = [film.rpartition("/")[2]] * number
            for name, request in requests.items():
                rows.append(bench_request(url, request, name, seconds, films))
                if not as_json:
                    click.echo(_text(rows[-1]))
    if as_json:
        click.echo(json.dumps([dataclasses.asdict(row) for row in rows]))


def _text(row: LoadRow) -> str:
    refused = f" | {row.refused} refused" if row.refused else ""
    seen = f" | {row.pictures_per_second:.1f} pictures/s each" if row.viewers else ""
    return (
        f"{row.request:20s} | {row.viewers:2d} viewers | {row.per_second:6.0f}/s | "
        f"p50 {1000 * row.p50:5.1f} ms | p95 {1000 * row.p95:5.1f} ms{seen}{refused}"
    )


@contextmanager
def _service() -> Iterator[str]:
    """The URL of a service with one simulation worker and none that plans."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    with tempfile.TemporaryDirectory() as folder:
        process = subprocess.Popen(
            [
                sys.executable,
                "-m",
                "app.cli",
                "serve",
                f"--port={port}",
                f"--data-dir={folder}",
                "--planning-workers=0",
            ],
            env=os.environ,
            stdout=subprocess.DEVNULL,
        )
        try:
            yield f"http://127.0.0.1:{port}"
        finally:
            process.terminate()
            process.wait()


def _carried_out(url: str) -> tuple[str, str]:
    """The paths of a plan and of its execution, when that has ended."""
    deadline = time.monotonic() + START_LIMIT
    with httpx.Client(base_url=url, transport=httpx.HTTPTransport(retries=20)) as client:
        plan = client.post("/plans", json=FILM).raise_for_status().json()
        path = f"/executions/{plan['executions'][0]}"
        while client.get(path).json()["status"] in ("queued", "executing"):
            if time.monotonic() > deadline:
                raise click.ClickException("the service did not carry a plan out in time")
            time.sleep(0.2)
    return f"/plans/{plan['id']}", path
