"""Processes: a pool of them that is gone with whoever made it, however that one ends."""

import multiprocessing
import os
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing.connection import Pipe
from typing import Protocol

from app.lifeline import follow


class Readable(Protocol):
    """The reading end of a pipe, whatever the system calls it."""

    def fileno(self) -> int:
        """Its file descriptor."""
        ...


def nothing() -> None:
    """What a process does first where there is nothing to get ready."""


@contextmanager
def processes(number: int, begin: Callable[[], None] = nothing) -> Iterator[ProcessPoolExecutor]:
    """So many processes, each of which calls ``begin`` first; it must survive pickling.

    Whoever leaves early, by an error or an interrupt, leaves nothing running.
    """
    lifeline, held = Pipe(duplex=False)
    context = multiprocessing.get_context("spawn")
    pool = ProcessPoolExecutor(number, context, initializer=_begin, initargs=(lifeline, begin))
    with lifeline, held:
        try:
            yield pool
            pool.shutdown()
        finally:
            held.close()
            pool.shutdown()


def _begin(lifeline: Readable, begin: Callable[[], None]) -> None:
    follow(os.dup(lifeline.fileno()))
    begin()
