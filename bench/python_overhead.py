#!/usr/bin/python3
"""How long a call from Python takes in which there is next to nothing to compute: python_overhead.py [CALLS]

Run with PYTHONPATH=build/python. Compares captures of 32 x 24 pixels, so that nearly all of the time is what a call costs
whatever it computes: taking the arguments, reading small files, making detections.json, and giving the result to Python.
What Python itself adds is less than that.
"""
import pathlib
import random
import statistics
import struct
import sys
import tempfile
import time

import rva

WIDTH, HEIGHT = 32, 24


def write_capture(folder, chance, nearer_mm):
    """Two noisy depth images of a wall at 1 m, with a square in the middle that is nearer."""
    folder.mkdir()
    for i in range(2):
        depth_mm = [1000 + chance.randint(-1, 1) - (nearer_mm if 8 < p % WIDTH < 16 and 8 < p // WIDTH < 16 else 0)
                    for p in range(WIDTH * HEIGHT)]
        header = f'P5\n{WIDTH} {HEIGHT}\n65535\n'.encode()
        (folder / f'{i:06}.pgm').write_bytes(header + struct.pack(f'>{WIDTH * HEIGHT}H', *depth_mm))
    return rva.open(folder, intrinsics=(30, 30, 16, 12), depth_unit=1)


def main():
    calls = int(sys.argv[1]) if len(sys.argv) > 1 else 200
    chance = random.Random(1)
    took_ms = []
    with tempfile.TemporaryDirectory() as name:
        before = write_capture(pathlib.Path(name) / 'before', chance, 0)
        after = write_capture(pathlib.Path(name) / 'after', chance, 100)
        for _ in range(calls):
            start = time.perf_counter()
            result = rva.detect(before, after, method='constant', threshold=0.05)
            took_ms.append(1000 * (time.perf_counter() - start))
            assert len(result) == 1
    quartiles = statistics.quantiles(took_ms, n=4)
    print(f'{calls} calls: median {quartiles[1]:.2f} ms, quartiles {quartiles[0]:.2f} and {quartiles[2]:.2f} ms')


if __name__ == '__main__':
    main()
