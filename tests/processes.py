"""What processes there are, and waiting for what they do."""

import signal
import subprocess
import time
from pathlib import Path

import pytest

LIMIT = 60.0  # [s], generous: the machine may be busy with other things


def _unless_ignored(number):
    """Whoever runs the tests may have it ignored: ``nohup`` one, a shell in the background another."""
    ignored = signal.getsignal(number) == signal.SIG_IGN
    return pytest.param(
        number, marks=pytest.mark.skipif(ignored, reason=f"{number.name} is ignored")
    )


INTERRUPTED, HUNG_UP = map(_unless_ignored, (signal.SIGINT, signal.SIGHUP))
ENDINGS = (INTERRUPTED, signal.SIGTERM, HUNG_UP, signal.SIGKILL)
"""How a process may be ended."""


def descendants(pid):
    """Process ids of everything that a process started, and of what that started."""
    listed = subprocess.run(["ps", "-eo", "pid=,ppid="], capture_output=True, text=True).stdout
    pairs = [tuple(map(int, line.split())) for line in listed.splitlines()]
    children = [child for child, parent in pairs if parent == pid]
    return children + [one for child in children for one in descendants(child)]


def runs(pid):
    """Whether there is such a process; one that only waits to be noticed dead is none."""
    try:
        status = Path(f"/proc/{pid}/stat").read_text()
    except (FileNotFoundError, ProcessLookupError):
        return False
    return status.rpartition(")")[2].split()[0] != "Z"


def within_limit(happened):
    """What ``happened`` gives once that is true."""
    deadline = time.monotonic() + LIMIT
    while not (found := happened()):
        assert time.monotonic() < deadline
        time.sleep(0.05)
    return found
