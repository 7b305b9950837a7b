"""Probabilities from a network's outputs, and how far they are true."""
import numpy as np


def probabilities(outputs, temperature):
    """The softmax of N x C outputs, divided by the temperature."""
    scaled = outputs.astype(float) / temperature
    shares = np.exp(scaled - scaled.max(axis=1, keepdims=True))
    return shares / shares.sum(axis=1, keepdims=True)


def fitted_calibration(outputs, labels, others):
    """The temperature (Guo et al., ICML 2017) and the addition to the last output with the greatest likelihood.

    The last label is that of all other objects. Their share in training and validation is not that of findings, so
    that they count as if they were the share `others`.
    """
    rows = np.arange(len(labels))
    other = labels == outputs.shape[1] - 1
    weights = np.where(other, others / max(other.sum(), 1), (1 - others) / max((~other).sum(), 1))

    def loss(temperature, addition):
        shifted = outputs.astype(float)
        shifted[:, -1] += addition
        return -(weights * np.log(np.maximum(probabilities(shifted, temperature)[rows, labels], 1e-12))).sum()

    additions = np.linspace(-6, 6, 61) if other.any() else [0.0]
    candidates = [(t, b) for t in np.geomspace(0.3, 5.0, 60) for b in additions]
    temperature, addition = min(candidates, key=lambda candidate: loss(*candidate))
    return float(temperature), float(addition)


def threshold_that_keeps(best, share):
    """The probability that this share of findings reaches."""
    return float(np.quantile(best, 1.0 - share))


def expected_calibration_error(best, right, bins=15):
    """The mean distance of stated probability and share of right ones, over bins of equal width."""
    number = np.minimum((best * bins).astype(int), bins - 1)
    return sum(np.abs(best[number == k].mean() - right[number == k].mean()) * (number == k).mean()
               for k in np.unique(number))
