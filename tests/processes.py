"""What processes there are, and waiting for what they do."""

import signal
import subprocess
import time
from pathlib import Path

import pytest

LIMIT = 60.0  # [s], generous: the machine may be busy with other things

HUNG_UP = pytest.param(
    signal.SIGHUP,
    marks=pytest.mark.skipif(
        signal.getsignal(signal.SIGHUP) == signal.SIG_IGN, reason="the tests run under nohup"
    ),
)
ENDINGS = (signal.SIGINT, signal.SIGTERM, HUNG_UP, signal.SIGKILL)
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
