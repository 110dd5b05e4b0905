"""Endings: whoever ends a command, it gets to leave in good order."""

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

ASKED = (signal.SIGTERM, signal.SIGHUP)
"""How an end is asked for: by whoever manages processes, and by a terminal that is closed."""


@contextmanager
def interrupted() -> Iterator[None]:
    """What ends the process otherwise without a word is in here an interrupt, like Ctrl-C.

    Signals that are ignored from the start, as under ``nohup``, stay so.
    """
    before = {number: signal.getsignal(number) for number in ASKED}
    heeded = [number for number, handler in before.items() if handler != signal.SIG_IGN]
    for number in heeded:
        signal.signal(number, _interrupt)
    try:
        yield
    finally:
        for number in heeded:
            signal.signal(number, before[number])


def _interrupt(_number: int, _frame: FrameType | None) -> None:
    raise KeyboardInterrupt
