"""Measures the errors of each simulated camera model on walls, on slopes and at edges of a scene.

usage: camera_models.py RVA [--scene FILE] [--models NAME,NAME...] [--seed S]
"""
import argparse
import json
import pathlib
import subprocess
import tempfile

import cv2
import numpy as np

SCENE = pathlib.Path(__file__).resolve().parents[1] / 'data' / 'scenes' / 'three-tools.yaml'
MODELS = 'd435,census-5,census-13,semi-global,correlation-5,correlation-9'
FRAMES = 4
UNSEEN_PX = 130  # columns that the right imager does not see


def read(path):
    return cv2.imread(str(path), cv2.IMREAD_UNCHANGED).astype(float)


def disparities(capture):
    """The disparities of all frames and of the truth, in pixels; NaN where there is none."""
    stated = json.loads((capture / 'capture.json').read_text())
    numerator = stated['depth']['fx'] * stated['camera']['baseline_m']
    frames = np.array([read(capture / 'depth' / f'{k:06d}.png') for k in range(FRAMES)]) * stated['depth']['unit_m']
    truth = read(capture / 'truth' / 'depth.png') * 1e-4
    with np.errstate(divide='ignore'):
        return tuple(np.where(depth > 0, numerator / depth, np.nan) for depth in (frames, truth))


def places(truth):
    """Masks of the pixels where the true disparity changes by less than 0.05 px per pixel, by more, and within 4 px of a
    jump."""
    filled = np.nan_to_num(truth)
    change = np.hypot(cv2.Sobel(filled, cv2.CV_64F, 1, 0), cv2.Sobel(filled, cv2.CV_64F, 0, 1)) / 8
    edge = cv2.dilate((change > 0.5).astype(np.uint8), np.ones((9, 9))) > 0
    seen = np.isfinite(truth)
    seen[:, :UNSEEN_PX] = False
    return {'wall': seen & ~edge & (change < 0.05), 'slope': seen & ~edge & (change >= 0.05), 'edge': seen & edge}


def row(model, frames, truth):
    cells = [model]
    for where in places(truth).values():
        measured = where & np.isfinite(frames).all(axis=0)
        error = frames[0][measured] - truth[measured]
        spread = 1.4826 * np.median(np.abs(error - np.median(error)))
        over_time = np.median(frames[:, measured].std(axis=0))
        cells.append(f'{measured.sum() / where.sum():.2f}, {spread:.3f}, {over_time:.3f}, {np.mean(np.abs(error) > 1):.3f}')
    return '| ' + ' | '.join(cells) + ' |'


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('rva')
    parser.add_argument('--scene', default=SCENE)
    parser.add_argument('--models', default=MODELS)
    parser.add_argument('--seed', default='5')
    arguments = parser.parse_args()
    print('| model | wall: measured, spread px, over time px, off by 1 px | slope | edge |\n| --- | --- | --- | --- |')
    with tempfile.TemporaryDirectory(prefix='rva-models-') as folder:
        for model in arguments.models.split(','):
            capture = pathlib.Path(folder) / model.replace(':', '-')
            subprocess.run([arguments.rva, 'simulate', arguments.scene, '--camera-model', model, '--frames', str(FRAMES),
                            '--seed', arguments.seed, '--out', capture], check=True, stdout=subprocess.DEVNULL)
            print(row(model, *disparities(capture)), flush=True)


if __name__ == '__main__':
    main()
