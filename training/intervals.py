"""Intervals of shares, without SciPy."""
import math


def at_most(k, n, p):
    """The probability of at most k successes in n trials."""
    return math.fsum(math.comb(n, i) * p ** i * (1 - p) ** (n - i) if n < 1000 else
                     math.exp(math.lgamma(n + 1) - math.lgamma(i + 1) - math.lgamma(n - i + 1) + i * math.log(p) +
                              (n - i) * math.log1p(-p)) for i in range(k + 1))


def root(falls_below, low=1e-12, high=1 - 1e-12):
    """Where a function that is true up to some p and false beyond it changes."""
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if falls_below(middle) else (low, middle)
    return (low + high) / 2


def clopper_pearson(k, n, confidence=0.95):
    """The exact interval of a share of k in n (Clopper and Pearson, 1934)."""
    tail = (1 - confidence) / 2
    low = 0.0 if k == 0 else root(lambda p: 1 - at_most(k - 1, n, p) < tail)
    high = 1.0 if k == n else root(lambda p: at_most(k, n, p) > tail)
    return low, high
