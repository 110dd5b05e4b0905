"""Supervisor: keeps worker processes alive, each under its own name."""

import os
import subprocess
import sys
import threading
import time
from collections.abc import Mapping

import click

from app.lifeline import STOP_LIMIT
from app.storage.jobs import Queue

FIRST_PAUSE, LONGEST_PAUSE = 0.1, 10.0  # [s] before a worker is started again
LONG_LIFE = 20.0  # [s] after which a worker's death is no longer counted with the ones before


class Supervisor:
    """Starts workers, restarts those that die, and stops them all at the end."""

    def __init__(self, environment: Mapping[str, str]) -> None:
        # Without GOMP_SPINCOUNT=0 the model's idle threads take the processor from the others.
        self._environment = {"GOMP_SPINCOUNT": "0", **os.environ, **environment}
        self._stopping = threading.Event()
        self._threads: list[threading.Thread] = []
        self._processes: dict[str, subprocess.Popen[bytes]] = {}

    def start(self, queue: Queue, number: int) -> None:
        """Keep so many workers of this queue alive."""
        for index in range(1, number + 1):
            name = f"{queue}-{index}"
            thread = threading.Thread(target=self._keep, args=(queue, name), name=name, daemon=True)
            self._threads.append(thread)
            thread.start()

    def stop(self) -> None:
        """End all workers, in good order if they can."""
        self._stopping.set()
        for process in list(self._processes.values()):
            _let_go(process)
        deadline = time.monotonic() + STOP_LIMIT
        for thread in self._threads:
            thread.join(max(0.0, deadline - time.monotonic()))
        for process in list(self._processes.values()):
            if process.poll() is None:
                process.kill()

    def _keep(self, queue: Queue, name: str) -> None:
        pause = FIRST_PAUSE
        while not self._stopping.is_set():
            started = time.monotonic()
            code = self._run(queue, name)
            if self._stopping.is_set():
                return
            pause = FIRST_PAUSE if time.monotonic() - started > LONG_LIFE else pause * 2
            pause = min(pause, LONGEST_PAUSE)
            how = f"signal {-code}" if code < 0 else f"code {code}"
            click.echo(f"{name} ended with {how}; starting it again in {pause:.1f} s")
            self._stopping.wait(pause)

    def _run(self, queue: Queue, name: str) -> int:
        """One life of a worker; its standard input is its lifeline."""
        command = [sys.executable, "-m", "app.cli", "worker", f"--queue={queue}"]
        with subprocess.Popen(
            [*command, f"--name={name}", "--supervised"],
            stdin=subprocess.PIPE,
            env=self._environment,
        ) as process:
            self._processes[name] = process
            click.echo(f"started {name} (process {process.pid})")
            if self._stopping.is_set():
                _let_go(process)
            return process.wait()


def _let_go(process: subprocess.Popen[bytes]) -> None:
    if process.stdin is not None:
        process.stdin.close()
