"""Runs: all attempts of an evaluation, over processes, continued where an earlier run stopped."""

import time
from collections.abc import Callable, Container, Generator, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from contextlib import ExitStack, closing
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from app.evaluation.attempt import OpenModel, Unit, attempt
from app.evaluation.processes import processes
from app.evaluation.results import Cell, Result, open_results, read_results, write_result
from app.evaluation.suites import Suite
from app.evaluation.tasks import ENGLISH

RESULTS = "results.jsonl"
"""The file in an evaluation's folder that grows by a line for each attempt."""
OpenModels = Callable[[], OpenModel]
"""Called once in every process; it must survive pickling where there are several."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Progress:
    """How far an evaluation has come."""

    done: int
    """Attempts there are results of, those of earlier runs included."""
    total: int
    seconds_left: float | None
    """Guessed from this run's attempts; None before the first."""
    last: Result | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Evaluation:
    """What is to be measured: every task of the suite, by every method, so many times."""

    suite: Suite
    cells: tuple[Cell, ...]
    runs: int = 1
    languages: tuple[str, ...] = (ENGLISH,)
    """A task is skipped in languages it has no sentence in; ``all`` stands for those it has."""
    physics: bool = False
    seconds: float | None = None
    """No attempt is begun after so long; what is there then is a partial result."""

    def units(self) -> list[Unit]:
        """Every attempt, a whole round of all tasks and methods before the next run begins."""
        return [
            Unit(task=task, cell=cell, run=run, language=language, physics=self.physics)
            for run in range(self.runs)
            for cell in self.cells
            for task in self.suite.tasks
            for language in self._languages(task.variants)
        ]

    def _languages(self, variants: object) -> list[str]:
        have = [ENGLISH, *(variants if isinstance(variants, dict) else ())]
        return have if "all" in self.languages else [one for one in have if one in self.languages]


@dataclass(slots=True)
class Clock:
    """Guesses the time left, and tells when it is up."""

    limit: float | None
    started: float = field(default_factory=time.monotonic)
    attempts: int = 0

    def seconds_left(self, remaining: int) -> float | None:
        """For so many more attempts, at the speed so far."""
        if self.attempts == 0:
            return None
        return remaining * (time.monotonic() - self.started) / self.attempts

    @property
    def is_up(self) -> bool:
        """Whether no further attempt is to begin."""
        return self.limit is not None and time.monotonic() - self.started > self.limit


def evaluate(
    evaluation: Evaluation,
    open_models: OpenModels,
    out: Path,
    *,
    jobs: int = 1,
    report: Callable[[Progress], bool] = lambda _: False,
) -> list[Result]:
    """Make every attempt there is no result of yet, adding each result to the folder's file.

    Args:
        evaluation: what to measure.
        open_models: makes what opens models, once in each process.
        out: folder of the results; made where there is none.
        jobs: processes.
        report: told of every result; True stops, and what is there stays.

    Returns:
        All results of the evaluation, in the order of its units; fewer where it was stopped.

    Raises:
        ModelUnavailable: there is no model to ask.
        UnknownName: there is no such planner or model.
    """
    return evaluate_units(
        evaluation.units(), open_models, out, jobs=jobs, seconds=evaluation.seconds, report=report
    )


def evaluate_units(
    units: Sequence[Unit],
    open_models: OpenModels,
    out: Path,
    *,
    jobs: int = 1,
    seconds: float | None = None,
    report: Callable[[Progress], bool] = lambda _: False,
) -> list[Result]:
    """The same for attempts of any kind; those of one key are made once."""
    out.mkdir(parents=True, exist_ok=True)
    units = list({unit.key: unit for unit in units}.values())
    results = {result.key: result for result in read_results(out / RESULTS)}
    waiting = [unit for unit in units if unit.key not in results]
    done, clock = len(units) - len(waiting), Clock(seconds)
    stopped = report(Progress(done=done, total=len(units), seconds_left=None))
    attempts = _attempts([] if stopped else waiting, open_models, jobs, clock)
    with open_results(out / RESULTS) as file, closing(attempts):
        for result in attempts:
            results[result.key] = result
            write_result(file, result)
            done, clock.attempts = done + 1, clock.attempts + 1
            left = clock.seconds_left(len(units) - done)
            if report(Progress(done=done, total=len(units), seconds_left=left, last=result)):
                break
    return [results[unit.key] for unit in units if unit.key in results]


def _attempts(
    units: Sequence[Unit], open_models: OpenModels, jobs: int, clock: Clock
) -> Generator[Result]:
    if jobs > 1:
        with ExitStack() as stack:
            begin = partial(_begin, open_models)
            pools = [stack.enter_context(processes(1, begin)) for _ in range(jobs)]
            yield from _in_pools(pools, units, clock)
        return
    open_model = open_models()
    for unit in units:
        if clock.is_up:
            return
        yield attempt(unit, open_model)


def _in_pools(
    pools: Sequence[ProcessPoolExecutor], units: Sequence[Unit], clock: Clock
) -> Iterator[Result]:
    """Results as they come in; never more attempts under way than there are processes."""
    free, waiting = list(pools), list(units)
    last: dict[ProcessPoolExecutor, str] = {}
    running: dict[Future[Result], ProcessPoolExecutor] = {}
    while True:
        while free and waiting and not clock.is_up:
            pool = free.pop(0)
            others = {start for other, start in last.items() if other is not pool}
            unit = waiting.pop(next_place(waiting, last.get(pool), others))
            last[pool] = unit.start
            running[pool.submit(_attempt, unit)] = pool
        if not running:
            return
        ended, _ = wait(running, return_when=FIRST_COMPLETED)
        for future in ended:
            free.append(running.pop(future))
            yield future.result()


def next_place(waiting: Sequence[Unit], last: str | None, others: Container[str]) -> int:
    """Which attempt a process is to make next: one whose prompt begins like its last one.

    The model has read that beginning already. Else one of a kind that no other process is at, else
    the first.
    """
    starts = [unit.start for unit in waiting]
    if last in starts:
        return starts.index(last)
    return next((place for place, start in enumerate(starts) if start not in others), 0)


_process: list[OpenModel] = []
"""What opens models in this process, where it is one of several."""


def _begin(open_models: OpenModels) -> None:
    _process[:] = [open_models()]


def _attempt(unit: Unit) -> Result:
    return attempt(unit, _process[0])
