"""Endings: whoever ends a command, it gets to leave in good order."""

import os
import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from threading import Timer
from types import FrameType

ASKED = (signal.SIGTERM, signal.SIGHUP)
"""How an end is asked for: by whoever manages processes, and by a terminal that is closed."""
AGAIN = 0.05  # [s]
INTERRUPTED = 130
"""Exit code of what Ctrl-C ended."""


@contextmanager
def interrupted() -> Iterator[None]:
    """What ends the process otherwise without a word is in here an interrupt, like Ctrl-C.

    Signals that are ignored from the start, as under ``nohup``, stay so. An interrupt that comes
    while Python clears something away, where exceptions end unheard, comes once more.
    """
    before = {number: signal.getsignal(number) for number in ASKED}
    heeded = [number for number, handler in before.items() if handler != signal.SIG_IGN]
    for number in heeded:
        signal.signal(number, _interrupt)
    unheard = sys.unraisablehook
    if heeded:
        sys.unraisablehook = partial(_interrupt_again, by=heeded[0], otherwise=unheard)
    try:
        yield
    finally:
        sys.unraisablehook = unheard
        for number in heeded:
            signal.signal(number, before[number])


def _interrupt(_number: int, _frame: FrameType | None) -> None:
    raise KeyboardInterrupt


def _interrupt_again(
    lost: "sys.UnraisableHookArgs",
    by: int,
    otherwise: "Callable[[sys.UnraisableHookArgs], object]",
) -> None:
    if issubclass(lost.exc_type, KeyboardInterrupt):
        Timer(AGAIN, os.kill, (os.getpid(), by)).start()
    else:
        otherwise(lost)
