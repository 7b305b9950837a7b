"""Figures that characterise a simulated depth camera, from its captures.

Disparities are in pixels; a region is a pair of slices (rows, columns).
"""
import warnings

import cv2
import numpy as np

from simulation import BASELINE_M, FOCAL_PX

# Away from the borders and from the band on the left that the right imager does not see.
MIDDLE = (slice(60, 420), slice(200, 800))
WRONG_PX = 1.0  # further away than this is another match, not noise


def plane_residuals(disparity):
    """What is left of one disparity image after the best plane (a plane in space is linear in disparity)."""
    rows, columns = np.mgrid[:disparity.shape[0], :disparity.shape[1]]
    design = np.stack([np.ones(disparity.size), columns.ravel() / 100.0, rows.ravel() / 100.0], axis=1)
    values = disparity.ravel()
    use = np.isfinite(values)
    use &= np.abs(values - np.nanmedian(values)) < 10 * WRONG_PX
    for _ in range(3):
        plane, *_ = np.linalg.lstsq(design[use], values[use], rcond=None)
        residuals = values - design @ plane
        use = np.isfinite(residuals) & (np.abs(residuals) < WRONG_PX)
    return residuals.reshape(disparity.shape)


def rms(residuals):
    """Root mean square without wrong matches."""
    kept = residuals[np.abs(residuals) < WRONG_PX]
    return float(np.sqrt(np.mean(kept ** 2)))


def mean_over_frames(stack):
    """NaN where fewer than half of the frames measured."""
    with warnings.catch_warnings():
        warnings.simplefilter('ignore', RuntimeWarning)
        mean = np.nanmean(stack, axis=0)
    return np.where(np.isfinite(stack).mean(axis=0) >= 0.5, mean, np.nan)


def wall_noise(capture, region=MIDDLE):
    """Noise of a wall: over space in one frame, over time in one pixel, and what stays after all frames."""
    stack = capture.disparity_px[(slice(None), *region)]
    truth = capture.true_disparity_px[region]
    single = [rms(plane_residuals(frame)) for frame in stack]
    mean = mean_over_frames(stack)
    right = np.abs(mean - truth) < WRONG_PX
    over_time = np.nanstd(np.where(right, stack, np.nan), axis=0, ddof=1)
    distance_m = np.nanmedian(capture.true_depth_m[region])
    return {'distance_m': float(distance_m), 'frames': len(stack),
            'plane_rms_px': float(np.mean(single)),
            'over_time_median_px': float(np.nanmedian(over_time)),
            'over_time_rms_px': float(np.sqrt(np.nanmean(over_time ** 2))),
            'fixed_px': rms(plane_residuals(mean)),
            'plane_rms_mm': float(np.mean(single)) * 1000 * distance_m ** 2 / (FOCAL_PX * BASELINE_M),
            'fill': float(np.isfinite(stack).mean()),
            'wrong': float((np.abs(stack - truth) > WRONG_PX).mean())}


def fixed_pattern(capture, region=MIDDLE):
    return plane_residuals(mean_over_frames(capture.disparity_px[(slice(None), *region)]))


def correlation(a, b):
    use = (np.abs(a) < WRONG_PX) & (np.abs(b) < WRONG_PX)
    return float(np.corrcoef(a[use], b[use])[0, 1])


def neighbour_correlation(capture, lags, region=MIDDLE):
    """Of one frame's error with that of the pixel `lag` columns on."""
    residuals = plane_residuals(capture.disparity_px[0][region])
    return [correlation(residuals[:, :-lag], residuals[:, lag:]) for lag in lags]


def frame_correlation(capture, lags, region=MIDDLE):
    """Of one frame's deviation from the pixel's mean with that `lag` frames on."""
    stack = capture.disparity_px[(slice(None), *region)]
    deviation = stack - mean_over_frames(stack)
    return [correlation(deviation[:-lag], deviation[lag:]) for lag in lags]


def edge_distance_px(capture, step_m=0.03):
    """Of every pixel to the nearest true depth edge."""
    depth = np.nan_to_num(capture.true_depth_m, nan=100.0).astype(np.float32)
    kernel = np.ones((3, 3), np.uint8)
    edges = cv2.dilate(depth, kernel) - cv2.erode(depth, kernel) > step_m
    return cv2.distanceTransform((~edges).astype(np.uint8), cv2.DIST_L2, 3)


def noise_by_edge_distance(capture, limits_px, nearer_than_m=1.2):
    """Deviation over time of the disparity, root mean square, and share of wrong pixels, in rings around edges."""
    stack, truth = capture.disparity_px, capture.true_disparity_px
    distance = edge_distance_px(capture)
    with warnings.catch_warnings():
        warnings.simplefilter('ignore', RuntimeWarning)
        over_time = np.nanstd(stack, axis=0, ddof=1)
    wrong = np.abs(mean_over_frames(stack) - truth) > WRONG_PX
    usable = (capture.true_depth_m < nearer_than_m) & np.isfinite(over_time)
    usable[:, :160] = False  # not seen by both imagers
    rows = []
    for low, high in zip(limits_px[:-1], limits_px[1:]):
        ring = usable & (distance > low) & (distance <= high)
        rows.append({'from_px': low, 'to_px': high, 'pixels': int(ring.sum()),
                     'over_time_rms_px': float(np.sqrt(np.mean(np.minimum(over_time[ring], 10) ** 2))),
                     'wrong': float(wrong[ring].mean())})
    return rows


def dot_spacing_px(image):
    """Mean distance between dots, as if they lay on a square grid: counted as local maxima."""
    smooth = cv2.GaussianBlur(image.astype(np.float32), (0, 0), 1.0)
    peaks = (smooth == cv2.dilate(smooth, np.ones((5, 5)))) & (smooth > 1.5 * np.median(smooth))
    return float(np.sqrt(image.size / peaks.sum()))


def fattening_px(capture, label, row):
    """How far an object's depth reaches beyond it to the left and to the right in one row of the picture."""
    true = np.flatnonzero(capture.labels[row] == label)
    near = np.nanmedian(capture.true_depth_m[row][true])
    measured = mean_over_frames(capture.depth_m)[row]
    seen = np.flatnonzero(np.abs(measured - near) < 0.1 * near)
    seen = seen[(seen > true[0] - 40) & (seen < true[-1] + 40)]
    return int(true[0] - seen[0]), int(seen[-1] - true[-1])
