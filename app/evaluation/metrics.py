"""Metrics: the paper's figures and some more, each with its spread and its interval."""

import statistics
from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

from app.evaluation.intervals import bootstrap, wilson
from app.evaluation.results import Judged, Result


@dataclass(frozen=True, slots=True, kw_only=True)
class Metric:
    """Something that is told of every result."""

    name: str
    title: str
    meaning: str
    of: Callable[[Result], float | None]
    rate: bool = False
    """It is 0 or 1 for each result."""
    share: bool = True
    """It lies in [0, 1]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Figure:
    """A mean over results."""

    mean: float
    std: float | None
    """Over the means of the runs, as in the paper; None with a single run."""
    low: float
    """The 95 % interval: Wilson's for a rate in one run, else bootstrapped over tasks."""
    high: float
    count: int
    share: bool = True

    def __str__(self) -> str:
        spread = "" if self.std is None else f" ± {short(self.std)}"
        return f"{short(self.mean)}{spread}" if self.share else f"{self.mean:.2f}"


def _score(name: str) -> Callable[[Result], float | None]:
    return lambda result: final(result).scores.get(name)


def final(result: Result) -> Judged:
    """How it went in the world itself, or in the perfect executor where that is all there is."""
    return result.physics or result.plan


def _executability(result: Result) -> float | None:
    return 0.0 if result.status == "failed" else final(result).scores.get("exec")


def _core(result: Result) -> float | None:
    if result.physics is None and not result.symbolic:
        return None
    core = final(result).scores.get("core_gcr")
    return float(result.status != "failed" and core == 1)


def _success(result: Result) -> float | None:
    if result.verdict is not None:
        return float(result.verdict.success)
    if result.physics is None and not result.symbolic:
        return None
    return float(final(result).success and result.status != "failed")


METRICS = (
    Metric(
        name="sr",
        title="SR",
        meaning="all goal conditions hold at the end, in the world itself; a person's verdict goes first",
        of=_success,
        rate=True,
    ),
    Metric(
        name="core_sr",
        title="core SR",
        meaning="SR without conditions that standing near things brings about",
        of=_core,
        rate=True,
    ),
    Metric(
        name="plan_sr",
        title="Plan SR",
        meaning="the plan would succeed if no action ever slipped",
        of=lambda result: float(result.plan.success),
        rate=True,
    ),
    Metric(
        name="strict",
        title="strict Plan SR",
        meaning="Plan SR, and nothing is changed that was to be left alone",
        of=lambda result: float(result.plan.strict),
        rate=True,
    ),
    Metric(
        name="gcr", title="GCR", meaning="share of the goal conditions that hold", of=_score("gcr")
    ),
    Metric(
        name="core_gcr",
        title="core GCR",
        meaning="GCR over the core conditions",
        of=_score("core_gcr"),
    ),
    Metric(
        name="exec",
        title="Exec",
        meaning="share of the attempted actions that could be carried out",
        of=_executability,
    ),
    Metric(
        name="precision",
        title="Precision",
        meaning="share of what was to stay that did stay",
        of=_score("precision"),
    ),
    Metric(
        name="seconds",
        title="seconds",
        meaning="wall time of the model for one task [s]",
        of=lambda result: result.seconds,
        share=False,
    ),
)
BY_NAME = {metric.name: metric for metric in METRICS}


def figure(results: Iterable[Result], metric: Metric) -> Figure | None:
    """The metric's mean over the results; None where none of them tells it."""
    told = [(result, value) for result in results if (value := metric.of(result)) is not None]
    if not told:
        return None
    runs: dict[int, list[float]] = defaultdict(list)
    tasks: dict[str, list[float]] = defaultdict(list)
    for result, value in told:
        runs[result.run].append(value)
        tasks[result.task].append(value)
    values = [value for _, value in told]
    means = [statistics.fmean(of_run) for of_run in runs.values()]
    low, high = _interval(values, list(tasks.values()), metric)
    return Figure(
        mean=statistics.fmean(values),
        std=statistics.stdev(means) if len(means) > 1 else None,
        low=low,
        high=high,
        count=len(values),
        share=metric.share,
    )


def by_cell(results: Iterable[Result]) -> dict[str, list[Result]]:
    """The results of each method, in the order in which the methods first appear."""
    return grouped(results, lambda result: result.cell)


def grouped(results: Iterable[Result], key: Callable[[Result], str]) -> dict[str, list[Result]]:
    """The results by what ``key`` says of them."""
    found: dict[str, list[Result]] = {}
    for result in results:
        found.setdefault(key(result), []).append(result)
    return found


def length_class(result: Result) -> str:
    """The paper's classes of lengths of the ground truth."""
    if result.impossible:
        return "none"
    bounds = ((5, "0-5"), (10, "6-10"), (18, "11-18"))
    return next((name for most, name in bounds if result.steps <= most), "19 and more")


def short(value: float) -> str:
    """Two decimals, without the zero before the point, as the paper prints them."""
    text = f"{value:.2f}"
    return text.removeprefix("0") if value < 1 and text != "1.00" else "1"


def _interval(
    values: Sequence[float], tasks: Sequence[Sequence[float]], metric: Metric
) -> tuple[float, float]:
    if metric.rate and len(tasks) == len(values):
        return wilson(round(sum(values)), len(values))
    return bootstrap(tasks)
