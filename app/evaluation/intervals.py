"""Intervals of confidence for rates."""

import math

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
