"""Intervals of confidence for rates and means, and a test for pairs."""

import math
from collections.abc import Sequence

import numpy as np

Z95 = 1.959963984540054


def wilson(successes: int, trials: int, z: float = Z95) -> tuple[float, float]:
    """Wilson's score interval for a rate (Wilson, 1927), by default at 95 %.

    Args:
        successes: how often it happened.
        trials: how often it could have happened; with none, nothing is known: (0, 1).
        z: quantile of the normal distribution.
    """
    if trials == 0:
        return 0.0, 1.0
    rate = successes / trials
    middle = rate + z**2 / (2 * trials)
    spread = z * math.sqrt(rate * (1 - rate) / trials + z**2 / (4 * trials**2))
    scale = 1 + z**2 / trials
    return max(0.0, (middle - spread) / scale), min(1.0, (middle + spread) / scale)


def bootstrap(
    groups: Sequence[Sequence[float]], *, seed: int = 0, draws: int = 1000, level: float = 0.95
) -> tuple[float, float]:
    """Percentile interval of the mean over all values, drawing whole groups with replacement.

    Args:
        groups: values that belong together and are not independent: the runs of one task.
        seed: of the draws.
        draws: how many samples are made.
        level: share of the samples' means between the two ends; with no group, (0, 1).
    """
    if not groups:
        return 0.0, 1.0
    sums = np.array([sum(group) for group in groups], float)
    counts = np.array([len(group) for group in groups], float)
    picked = np.random.default_rng(seed).integers(len(groups), size=(draws, len(groups)))
    means = sums[picked].sum(axis=1) / counts[picked].sum(axis=1)
    low, high = np.quantile(means, [(1 - level) / 2, (1 + level) / 2])
    return float(low), float(high)


def sign_test(first: int, second: int) -> float:
    """Exact two-sided p-value of McNemar's test.

    Args:
        first: pairs in which only the first succeeded.
        second: pairs in which only the second did.
    """
    pairs = first + second
    if pairs == 0:
        return 1.0
    tail = sum(math.comb(pairs, count) for count in range(min(first, second) + 1))
    return min(1.0, 2 * tail / 2**pairs)
