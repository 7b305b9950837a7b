"""Runs the C++ benchmarks and their Python peers alternately, and merges their rows.

usage: run.py RVA_BENCH RVA_MOVED_BENCH OUT.json [--quick]
"""
import json
import os
import pathlib
import platform
import subprocess
import sys
import tempfile
import time

import cv2
import numpy as np

import thesis_regions

ROUNDS = 3
HEIGHT, WIDTH = 480, 848


def least_ms(run, rounds):
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        run()
        times.append(1000 * (time.perf_counter() - start))
    return min(times)


def machine():
    model = next((line.split(':', 1)[1].strip() for line in open('/proc/cpuinfo') if line.startswith('model name')), '')
    return {'cpu': model, 'cores': os.cpu_count(), 'system': platform.platform(), 'numpy': np.__version__,
            'opencv': cv2.__version__}


def numpy_rows(inputs):
    """Times of mean and standard deviation of both sets of an inspection, as the thesis computes them."""
    frames = np.fromfile(inputs / 'frames.u16', np.uint16).reshape(-1, HEIGHT, WIDTH)
    for count in (10, 40, 100):
        sets = frames[:count], frames[count:2 * count]
        yield f'statistics/{count}', 'numpy', least_ms(lambda: [(s.mean(0), s.std(0)) for s in sets], 3)


def thesis_rows(inputs, quick):
    for blobs in (10, 100) if quick else (10, 100, 500):
        mask = cv2.imread(str(inputs / f'mask-{blobs}.png'), cv2.IMREAD_UNCHANGED)
        color = np.zeros((HEIGHT, WIDTH, 3), np.uint8)
        rounds = 1 if blobs == 500 else 3
        yield f'regions/{blobs}', 'thesis', least_ms(lambda: thesis_regions.draw_changes(color, mask), rounds)


def run_ours(program, folder):
    subprocess.run([program, folder / 'rows.json'], check=True)
    return json.loads((folder / 'rows.json').read_text())


def moved_rows(program, folder, quick):
    scenes = pathlib.Path(__file__).parent.parent / 'data' / 'scenes'
    subprocess.run([program, scenes / 'moved-robot-initial.yaml', scenes / 'moved-robot.yaml', folder / 'moved.json',
                    *(['--quick'] if quick else [])], check=True)
    return json.loads((folder / 'moved.json').read_text())


def main():
    program, moved_program, out = (pathlib.Path(argument) for argument in sys.argv[1:4])
    quick = '--quick' in sys.argv
    cv2.setNumThreads(1)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([program, '--export', folder], check=True)
        rows, peers = run_ours(program, folder), {}
        for _ in range(ROUNDS):
            for peer_name, peer, ms in numpy_rows(folder):
                peers[peer_name, peer] = min(ms, peers.get((peer_name, peer), ms))
            for row, again in zip(rows, run_ours(program, folder), strict=True):
                for key in ('ours_ms', 'peer_ms'):
                    if key in row:
                        row[key] = min(row[key], again[key])
        for peer_name, peer, ms in thesis_rows(folder, quick):
            peers[peer_name, peer] = ms
        rows += moved_rows(moved_program, folder, quick)
    for row in rows:
        if 'peer_ms' not in row and (row['name'], row['peer']) in peers:
            row['peer_ms'] = peers[row['name'], row['peer']]
    rows = [row for row in rows if 'peer_ms' in row]  # --quick omits some peers
    for row in rows:
        row['ratio'] = row['peer_ms'] / row['ours_ms']
    out.write_text(json.dumps({'machine': machine(), 'rows': rows}, indent=1) + '\n')
    print(f'{"what":22} {"ours ms":>9}  {"peer":15} {"peer ms":>10} {"ratio":>9}')
    for row in rows:
        print(f'{row["name"]:22} {row["ours_ms"]:9.2f}  {row["peer"]:15} {row["peer_ms"]:10.2f} {row["ratio"]:9.2f}')
    print(out)


if __name__ == '__main__':
    main()
