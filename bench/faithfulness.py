"""Measures how faithful the simulated camera is, and repeats the thesis' experiments on it.

usage: faithfulness.py RVA OUT [--seeds N]
Writes OUT/faithfulness.json and plots OUT/*.png, and prints the figures of docs/simulator.md.
"""
import argparse
import json
import pathlib
import shutil
import sys
import tempfile

import matplotlib

matplotlib.use('Agg')
import matplotlib.pyplot as plt
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / 'tests/faithfulness'))
import experiments
import measures
from simulation import BASELINE_M, FOCAL_PX, simulate, wall_scene

SCENES = ROOT / 'data/scenes'
DISTANCES_M = (0.4, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0)
MATERIALS = ('green-primer', 'white-paint', 'anodised-aluminium', 'bare-aluminium', 'steel', 'black-rubber')
FRAME_COUNTS = (10, 20, 30, 40, 50, 60, 70, 80, 90, 100)


def save_plot(out, name):
    plt.tight_layout()
    plt.savefig(out / f'{name}.png', dpi=80)
    plt.close()


def walls(rva, out, work):
    rows = []
    for distance in DISTANCES_M:
        capture = simulate(rva, wall_scene(work, distance), work / 'wall', frames=40)
        rows.append(measures.wall_noise(capture))
        print('wall', {key: round(value, 4) for key, value in rows[-1].items()})
    distance = np.array([row['distance_m'] for row in rows])
    over_space = np.array([row['plane_rms_mm'] for row in rows])
    over_time = np.array([row['over_time_median_px'] for row in rows]) * 1000 * distance ** 2 / (FOCAL_PX * BASELINE_M)
    plt.figure(figsize=(6, 4))
    plt.loglog(distance, over_space, 'o-', label='over the plane, one frame')
    plt.loglog(distance, over_time, 's-', label='one pixel over 40 frames, median')
    for s, style in ((0.032, ':'), (0.08, '--')):
        plt.loglog(distance, s * 1000 * distance ** 2 / (FOCAL_PX * BASELINE_M), 'k' + style, label=f'z² · {s} px / fB')
    plt.xlabel('distance, m')
    plt.ylabel('deviation of depth, mm')
    plt.legend()
    save_plot(out, 'noise-by-distance')
    slope = float(np.polyfit(np.log(distance), np.log(over_space), 1)[0])
    print(f'deviation grows with distance to the power of {slope:.2f}')
    return {'walls': rows, 'power_of_distance': slope}


def patterns(rva, out, work):
    same = [measures.fixed_pattern(simulate(rva, wall_scene(work, 1.0), work / 'w', seed=seed, frames=40))
            for seed in (1, 2)]
    turned = measures.fixed_pattern(simulate(rva, wall_scene(work, 1.0, pan_deg=0.325), work / 'w', frames=40))
    capture = simulate(rva, wall_scene(work, 1.0), work / 'w', '--infrared', frames=100)
    space_lags, time_lags = list(range(1, 21)), [1, 2, 3, 5, 8, 12, 18, 25, 35, 50, 70]
    result = {'same_pose': measures.correlation(*same), 'one_servo_step': measures.correlation(same[0], turned),
              'between_captures_px': measures.rms(same[0] - same[1]),
              'space_lags_px': space_lags, 'space': measures.neighbour_correlation(capture, space_lags),
              'time_lags': time_lags, 'time': measures.frame_correlation(capture, time_lags),
              'dot_spacing_mm_at_1m': measures.dot_spacing_px(capture.infrared('left')[measures.MIDDLE]) / FOCAL_PX * 1000}
    figure, axes = plt.subplots(1, 3, figsize=(12, 3.6))
    axes[0].imshow(same[0], vmin=-0.25, vmax=0.25, cmap='coolwarm')
    axes[0].set_title('fixed error at 1 m, +-0.25 px')
    axes[1].plot(space_lags, result['space'], 'o-')
    axes[1].set_xlabel('pixels apart')
    axes[1].set_ylabel("correlation of one frame's error")
    axes[2].plot(time_lags, result['time'], 'o-')
    axes[2].axhline(0, color='k', linewidth=0.5)
    axes[2].set_xlabel('frames apart')
    axes[2].set_ylabel("correlation of a pixel's deviation")
    save_plot(out, 'correlation')
    print('pattern', {k: v if not isinstance(v, float) else round(v, 3) for k, v in result.items()})
    return {'pattern': result}


def limits(rva, work):
    nearest = []
    for distance in (0.150, 0.160, 0.165, 0.170, 0.175, 0.180, 0.200):
        capture = simulate(rva, wall_scene(work, distance), work / 'w', frames=2)
        right = np.abs(capture.disparity_px - capture.true_disparity_px) < measures.WRONG_PX
        nearest.append({'distance_m': distance, 'right': float(right[(slice(None), *measures.MIDDLE)].mean())})
    fills = []
    for material in MATERIALS:
        for turn in (0, 30, 50):
            capture = simulate(rva, wall_scene(work, 0.7, material, turn), work / 'w', frames=4)
            error = np.abs(capture.disparity_px - capture.true_disparity_px)[(slice(None), *measures.MIDDLE)]
            fills.append({'material': material, 'turned_deg': turn, 'fill': float(np.isfinite(error).mean()),
                          'wrong': float((error > measures.WRONG_PX).mean())})
    for row in nearest + fills:
        print(row)
    return {'nearest': nearest, 'fill': fills}


def edges(rva, out, work):
    post = '''  - { name: post, shape: box, size_mm: [60, 10, 400], at_m: [0.05, 0.7, 0.25], material: green-primer }
'''
    capture = simulate(rva, wall_scene(work, 2.0, more=post), work / 'w', frames=5)
    reach = np.array([measures.fattening_px(capture, 2, row) for row in range(130, 350, 2)])
    wing = simulate(rva, SCENES / 'three-tools.yaml', work / 'w', '--debris', 'none', frames=40)
    rings = measures.noise_by_edge_distance(wing, (0, 1, 2, 3, 4, 5, 6, 8, 10, 14, 20, 60))
    plt.figure(figsize=(6, 4))
    centers = [(row['from_px'] + row['to_px']) / 2 for row in rings]
    plt.semilogy(centers, [row['over_time_rms_px'] for row in rings], 'o-', label='deviation over time, px')
    plt.semilogy(centers, [row['wrong'] for row in rings], 's-', label='share wrong by more than 1 px')
    plt.xlabel('distance to a depth edge, px')
    plt.legend()
    save_plot(out, 'edges')
    result = {'reach_mean_px': reach.mean(axis=0).tolist(), 'reach_5_px': np.percentile(reach, 5, axis=0).tolist(),
              'reach_95_px': np.percentile(reach, 95, axis=0).tolist(), 'rings': rings}
    print('edges', result)
    return {'edges': result}


def inspection(rva, work, scene, seed, frames):
    """Captures before and after, from one pose with different noise."""
    simulate(rva, SCENES / scene, work / 'initial', '--debris', 'none', frames=frames, seed=1000 + 2 * seed)
    simulate(rva, SCENES / scene, work / 'final', frames=frames, seed=1001 + 2 * seed)


def thesis(rva, out, work, seeds):
    rows = []

    def run(scene, seed, method, frames, *options):
        result = experiments.detect(rva, work / 'initial', work / 'final', work / 'result', '--method', method,
                                    *options, *(['--frames', frames] if method == 'gaussian' else []))
        rows.append({'scene': scene, 'seed': seed, 'method': ' '.join([method, *map(str, options[1:])]), 'frames': frames,
                     'found': result.found, 'false': result.false_findings,
                     'false_median_px': float(np.median(result.false_sizes_px or [0])),
                     'statistics_ms': result.statistics_ms})

    for seed in range(seeds):
        inspection(rva, work, 'three-tools.yaml', seed, 100)
        for threshold in ('0.01', '0.05'):
            run('three-tools', seed, 'constant', 1, '--threshold', threshold)
        for frames in FRAME_COUNTS:
            run('three-tools', seed, 'gaussian', frames)
        for scene in ('twelve-collars', 'three-smallest-collars'):
            inspection(rva, work, f'{scene}.yaml', seed, 100)
            for frames in (10, 40, 100):
                run(scene, seed, 'gaussian', frames)
        print(f'seed {seed} done', flush=True)
    plot_frame_counts(out, rows)
    print_thesis(rows)
    return {'thesis': rows}


def plot_frame_counts(out, rows):
    figure, left = plt.subplots(figsize=(6, 4))
    counts = [[row['false'] for row in rows
               if row['scene'] == 'three-tools' and row['method'].startswith('gaussian') and row['frames'] == n]
              for n in FRAME_COUNTS]
    low, median, high = np.percentile(counts, (25, 50, 75), axis=1)
    left.errorbar(FRAME_COUNTS, median, yerr=(median - low, high - median), fmt='o-', color='C0')
    left.set_xlabel('depth images a side')
    left.set_ylabel('false blobs, median and quartiles', color='C0')
    times = [np.median([row['statistics_ms'] for row in rows
                        if row['method'].startswith('gaussian') and row['frames'] == n]) for n in FRAME_COUNTS]
    right = left.twinx()
    right.plot(FRAME_COUNTS, times, 's--', color='C1')
    right.set_ylabel('statistics, ms', color='C1')
    save_plot(out, 'false-by-frames')


def print_thesis(rows):
    keys = sorted({(row['scene'], row['method'], row['frames']) for row in rows})
    for key in keys:
        chosen = [row for row in rows if (row['scene'], row['method'], row['frames']) == key]
        names = sorted({name for row in chosen for name in row['found']})
        found = {name: f"{sum(row['found'].get(name, False) for row in chosen)}/{len(chosen)}" for name in names}
        false = [row['false'] for row in chosen]
        print(*key, 'false', f'{np.mean(false):.1f} ({min(false)}-{max(false)})', 'median size',
              np.median([row['false_median_px'] for row in chosen]), found)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('rva', type=pathlib.Path)
    parser.add_argument('out', type=pathlib.Path)
    parser.add_argument('--seeds', type=int, default=10, help='of the experiments of the thesis')
    arguments = parser.parse_args()
    rva, out = arguments.rva.resolve(), arguments.out
    out.mkdir(parents=True, exist_ok=True)
    work = pathlib.Path(tempfile.mkdtemp(prefix='rva-faithfulness-'))
    try:
        report = {**walls(rva, out, work), **patterns(rva, out, work), **limits(rva, work), **edges(rva, out, work)}
        if arguments.seeds > 0:
            report.update(thesis(rva, out, work, arguments.seeds))
    finally:
        shutil.rmtree(work)
    (out / 'faithfulness.json').write_text(json.dumps(report, indent=1) + '\n')


if __name__ == '__main__':
    main()
