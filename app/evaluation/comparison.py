"""Comparison: two evaluations of the same tasks, pair by pair."""

import statistics
from collections.abc import Iterable
from dataclasses import dataclass

from app.evaluation.intervals import bootstrap, sign_test
from app.evaluation.metrics import Metric
from app.evaluation.results import Result


@dataclass(frozen=True, slots=True, kw_only=True)
class Comparison:
    """The second minus the first, over the pairs that both have."""

    first: str
    second: str
    metric: str
    pairs: int
    only_first: int
    """Pairs in which the first is better."""
    only_second: int
    difference: float
    low: float
    """The 95 % interval of the difference, bootstrapped over tasks."""
    high: float
    p: float
    """Exact, two-sided: how likely so uneven a split is where both are equally good."""

    @property
    def verdict(self) -> str:
        """In words."""
        if self.p >= 0.05:
            return "no difference shown"
        return f"{self.second if self.only_second > self.only_first else self.first} is better"


def compare(
    first: Iterable[Result], second: Iterable[Result], metric: Metric, names: tuple[str, str]
) -> Comparison:
    """Pair the results by task, language and run; what only one of the two has is left out."""
    ours = {_pair(result): metric.of(result) for result in first}
    theirs = {_pair(result): metric.of(result) for result in second}
    differences: dict[str, list[float]] = {}
    for pair in ours.keys() & theirs.keys():
        before, after = ours[pair], theirs[pair]
        if before is not None and after is not None:
            differences.setdefault(pair[0], []).append(after - before)
    groups = [differences[task] for task in sorted(differences)]
    values = [value for group in groups for value in group]
    better, worse = sum(value > 0 for value in values), sum(value < 0 for value in values)
    low, high = bootstrap(groups) if groups else (0.0, 0.0)
    return Comparison(
        first=names[0],
        second=names[1],
        metric=metric.name,
        pairs=len(values),
        only_first=worse,
        only_second=better,
        difference=statistics.fmean(values) if values else 0.0,
        low=low,
        high=high,
        p=sign_test(worse, better),
    )


def _pair(result: Result) -> tuple[str, str, int]:
    return result.task, result.language, result.run
