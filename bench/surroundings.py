"""Measures how far the heights of findings are from the truth in simulated bays with debris at random.

usage: surroundings.py RVA [BAYS [FIRST_SEED]]

The truth is the median difference of the true depths without and with a piece of debris, over the pixels before that
surface, of those of at least a tenth of the piece, which is nearest behind it: what it lies on.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import cv2
import numpy as np

BAYS, FIRST_SEED, FRAMES = 20, 1, 8
MM_PER_STEP = 0.1  # of truth/depth.png
EDGE = 1.5  # the change of depth is more than so many times the height above what a piece lies on: it is at an edge


def scene(seed):
    return {'format': 'rva-scene', 'version': 1,
            'wing': {'stringers': {'profile': ['z', 'hat', 'l'][seed % 3], 'count': 5}},
            'robot': {'base': 'b1', 'at_m': [0, 0.10, 0], 'tilt_deg': -16 - 18 * (seed % 7) / 6},
            'debris': [{'random': 12, 'seed': seed}]}


def read(path):
    return cv2.imread(str(path), cv2.IMREAD_UNCHANGED)


def truth(capture):
    objects = json.loads((capture / 'truth' / 'truth.json').read_text())['objects']
    debris = [entry['label'] for entry in objects if entry['role'] == 'debris']
    return read(capture / 'truth' / 'depth.png') * MM_PER_STEP, read(capture / 'truth' / 'labels.png'), debris


def true_heights(before, after):
    """By label: the height above what the piece lies on, and the median change of depth, mm."""
    before_mm, surfaces, _ = truth(before)
    after_mm, labels, debris = truth(after)
    heights = {}
    for label in debris:
        pixels = (labels == label) & (before_mm > 0) & (after_mm > 0)
        change, under = (before_mm - after_mm)[pixels], surfaces[pixels]
        above = [np.median(change[under == surface]) for surface in np.unique(under)
                 if (under == surface).sum() > 0.1 * len(under)]
        above = [height for height in above if height > 0.3]
        if above:
            heights[label] = min(above), np.median(change)
    return heights, labels


def measured(rva, seed, folder):
    """For each piece that is found: its true heights, and what the largest finding on it states."""
    file = folder / 'scene.yaml'
    file.write_text(json.dumps(scene(seed)))
    before, after, out = (folder / name for name in ('before', 'after', 'out'))
    for number, (capture, debris) in enumerate(((before, ['--debris', 'none']), (after, []))):
        run(rva, 'simulate', file, *debris, '--frames', FRAMES, '--seed', 2 * seed + number, '--out', capture, '--overwrite')
    run(rva, 'detect', before, after, '--out', out, '--overwrite')
    heights, labels = true_heights(before, after)
    changed = read(out / 'changes.png') > 0
    pieces = {}
    for finding in json.loads((out / 'detections.json').read_text())['detections']:
        x, y, w, h = finding['bbox']
        box = np.s_[y:y + h, x:x + w]
        here = labels[box][changed[box]]
        label = max(heights, key=lambda one: (here == one).sum(), default=None)
        touched = label is not None and 2 * (here == label).sum() > len(here)
        if finding['kind'] != 'added' or not touched or 'height_mm' not in finding:
            continue
        if label not in pieces or finding['area_px'] > pieces[label]['area_px']:
            pieces[label] = finding
    return [(heights[label], finding) for label, finding in pieces.items()]


def run(*command):
    subprocess.run([str(part) for part in command], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def report(name, rows):
    print(f'{name}: {len(rows)} pieces')
    for key in ('height_mm', 'above_surroundings_mm'):
        errors = [finding[key] - above for (above, _), finding in rows if key in finding]
        print(f'  {key}: stated for {len(errors)}, median error {np.median(errors):+.1f} mm, in magnitude '
              f'{np.median(np.abs(errors)):.1f} mm, 90 % within {np.quantile(np.abs(errors), 0.9):.0f} mm')
    print(f"  background_jump: {sum(finding.get('background_jump', False) for _, finding in rows)}")


def main():
    rva = sys.argv[1]
    bays, first = (int(text) for text in (sys.argv[2:] + [BAYS, FIRST_SEED][len(sys.argv) - 2:])[:2])
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(first, first + bays):
            rows += measured(rva, seed, pathlib.Path(folder))
    report('on one surface', [row for row in rows if row[0][1] <= EDGE * row[0][0]])
    report('at an edge', [row for row in rows if row[0][1] > EDGE * row[0][0]])


if __name__ == '__main__':
    main()
