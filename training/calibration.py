"""Probabilities from a network's outputs, and how far they are true."""
import numpy as np


def probabilities(outputs, temperature):
    """The softmax of N x C outputs, divided by the temperature."""
    scaled = outputs.astype(float) / temperature
    shares = np.exp(scaled - scaled.max(axis=1, keepdims=True))
    return shares / shares.sum(axis=1, keepdims=True)


def fitted_temperature(outputs, labels):
    """The temperature with the greatest likelihood (Guo et al., ICML 2017)."""
    rows = np.arange(len(labels))
    candidates = np.geomspace(0.2, 10.0, 400)
    loss = [-np.log(np.maximum(probabilities(outputs, t)[rows, labels], 1e-12)).mean() for t in candidates]
    return float(candidates[int(np.argmin(loss))])


def threshold_that_keeps(best, share):
    """The probability that this share of findings reaches."""
    return float(np.quantile(best, 1.0 - share))


def expected_calibration_error(best, right, bins=15):
    """The mean distance of stated probability and share of right ones, over bins of equal width."""
    number = np.minimum((best * bins).astype(int), bins - 1)
    return sum(np.abs(best[number == k].mean() - right[number == k].mean()) * (number == k).mean()
               for k in np.unique(number))
