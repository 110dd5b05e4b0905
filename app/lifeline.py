"""Lifeline: a pipe by which a process notices that whoever started it has let go of it, or is gone.

The system closes the starter's end however the starter ends, ``SIGKILL`` included. A signal for a
parent's death (Linux's ``PR_SET_PDEATHSIG``) would come at the death of the thread that started it.
"""

import os
import signal
import threading
import time
from collections.abc import Callable

STOP_LIMIT = 5.0
"""How long a process may take to end in good order once it is let go of [s]."""


def follow(lifeline: int, stop: Callable[[], None] | None = None) -> None:
    """Have this process, and all that it starts, end once nobody holds the pipe's other end.

    It gets a process group of its own: what a terminal sends, its starter alone decides about.

    Args:
        lifeline: File descriptor of the pipe's reading end, which stays open from now on.
        stop: Called then, to end within ``STOP_LIMIT`` by oneself; without it the end comes at once.
    """
    os.setpgid(0, 0)
    threading.Thread(
        target=_until_let_go, args=(lifeline, stop), name="lifeline", daemon=True
    ).start()


def _until_let_go(lifeline: int, stop: Callable[[], None] | None) -> None:
    while os.read(lifeline, 1):
        pass
    if stop is not None:
        stop()
        time.sleep(STOP_LIMIT)
    os.kill(0, signal.SIGKILL)  # the whole group: this process, and what it started
