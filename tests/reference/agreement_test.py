"""Holds `constant`, `gaussian` and the regions to the thesis in plain Python: every pixel, every box.

usage: agreement_test.py RVA PROBE SHARED
Random stacks and masks go through the probe; recordings, where SHARED has them, through the program itself.
The reference is thesis.py beside this file.
"""
import json
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

import cv2
import numpy as np

import thesis

RVA, PROBE, SHARED = (pathlib.Path(argument) for argument in sys.argv[1:4])
CONSTANT, GAUSSIAN, REGIONS = range(3)
CASES_PER_KIND = 200


class Case:
    def __init__(self, method, initial, final, **parameters):
        self.method, self.initial, self.final = method, initial, final
        self.unit, self.threshold, self.clip, self.sigmas = 0.001, 0.05, 2.0, 3.0
        self.min_blob, self.join = 0, 30.0
        self.__dict__.update(parameters)

    def encoded(self):
        frames, height, width = self.initial.shape
        head = struct.pack('<6i5d', self.method, frames, len(self.final), width, height, self.min_blob, self.unit,
                           self.threshold, self.clip, self.sigmas, self.join)
        return head + self.initial.astype('<u2').tobytes() + self.final.astype('<u2').tobytes()

    def expected(self):
        if self.method == CONSTANT:
            changed = thesis.constant(self.initial, self.final, self.threshold / self.unit, self.clip / self.unit)
        elif self.method == GAUSSIAN:
            changed = thesis.gaussian(self.initial, self.final, self.sigmas)
        else:
            changed = self.initial[0] > 0
        mask = changed.astype(np.uint8) * 255
        return mask, thesis.boxes(mask, self.min_blob, self.join)


def answers(cases):
    output = subprocess.run([PROBE], input=b''.join(case.encoded() for case in cases), stdout=subprocess.PIPE,
                            check=True, timeout=120).stdout
    at = 0
    for case in cases:
        _, height, width = case.initial.shape
        mask = np.frombuffer(output, np.uint8, height * width, at).reshape(height, width)
        at += height * width
        count, = struct.unpack_from('<i', output, at)
        at += 4
        boxes = np.frombuffer(output, '<i4', 4 * count, at).reshape(count, 4).tolist()
        at += 16 * count
        yield mask, sorted(boxes)
    assert at == len(output)


def random_stack(random, frames, shape):
    """Few levels, so that ties are common; holes; now and then depths at the ends of 16 bits."""
    base = random.choice([1, 700, 1990, 20000, 65400])
    levels = random.choice([1, 3, 40])
    stack = np.clip(base + random.integers(0, levels + 1, (frames, *shape)), 1, 65535)
    stack[random.random(stack.shape) < random.choice([0.0, 0.05, 0.5])] = 0
    return stack.astype(np.uint16)


def random_pair(random, method):
    shape = (int(random.integers(1, 40)), int(random.integers(1, 60)))
    most = 1 if method == CONSTANT else int(random.choice([1, 2, 7, 20]))
    initial = random_stack(random, most, shape)
    final = random_stack(random, max(1, most - int(random.integers(0, 2))), shape)
    # A part that came nearer by about what the thresholds ask for.
    v, u = random.integers(0, shape[0]), random.integers(0, shape[1])
    gap = int(random.choice([1, 5, 50, 51]))
    patch = initial[:1, v:v + 9, u:u + 9]
    final[:, v:v + 9, u:u + 9] = np.where(patch > gap, patch - gap, 0)
    return Case(method, initial, final, unit=float(random.choice([0.001, 0.0001, 1 / 5000])),
                threshold=float(random.choice([0.0, 0.001, 0.005, 0.05])), clip=float(random.choice([0.1, 2.0, 100.0])),
                sigmas=float(random.choice([0.0, 0.5, 3.0])), min_blob=int(random.choice([0, 1, 4])),
                join=float(random.choice([0.0, 2.0, 30.0])))


def random_mask(random):
    height, width = int(random.integers(1, 120)), int(random.integers(1, 200))
    mask = (random.random((height, width)) < random.choice([0.0, 0.003, 0.2])).astype(np.uint16)
    for _ in range(int(random.integers(0, 9))):
        v, u, size = random.integers(0, height), random.integers(0, width), random.integers(1, 60, 2)
        mask[v:v + size[0], u:u + size[1]] = random.integers(0, 4) > 0
    return Case(REGIONS, mask[None] * 255, mask[None] * 255, min_blob=int(random.choice([0, 2, 30])),
                join=float(random.choice([0.0, 1.0, 1.5, 5.0, 30.0, 30.5, 500.0])))


class Random(unittest.TestCase):
    def hold(self, cases):
        changed = found = 0
        for index, (case, (mask, boxes)) in enumerate(zip(cases, answers(cases), strict=True)):
            expected_mask, expected_boxes = case.expected()
            with self.subTest(case=index):
                np.testing.assert_array_equal(mask, expected_mask)
                self.assertEqual(boxes, expected_boxes)
            changed += int((expected_mask > 0).sum())
            found += len(expected_boxes)
        self.assertGreater(changed, 1000, 'the cases would not tell a detector from one that finds nothing')
        self.assertGreater(found, 100)

    def test_constant(self):
        random = np.random.default_rng(1)
        self.hold([random_pair(random, CONSTANT) for _ in range(CASES_PER_KIND)])

    def test_gaussian(self):
        random = np.random.default_rng(2)
        self.hold([random_pair(random, GAUSSIAN) for _ in range(CASES_PER_KIND)])

    def test_regions(self):
        random = np.random.default_rng(3)
        self.hold([random_mask(random) for _ in range(CASES_PER_KIND)])


def split_frames(capture, first, second):
    """Copies the depth frames of a capture into two, in turn: one side may not be compared with itself."""
    for half in (first, second):
        (half / 'depth').mkdir(parents=True)
        shutil.copy(capture / 'capture.json', half)
    for index, frame in enumerate(sorted((capture / 'depth').glob('*.png'))):
        shutil.copy(frame, (first, second)[index % 2] / 'depth' / f'{index // 2:06}.png')


class Recordings(unittest.TestCase):
    def hold(self, initial, final, method, **options):
        frames = options.pop('frames', 10**6)
        flags = [part for name, value in options.items() for part in (f'--{name.replace("_", "-")}', str(value))]
        if frames < 10**6:
            flags += ['--frames', str(frames)]
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / 'out'
            subprocess.run([RVA, 'detect', initial, final, '--method', method, '--out', out, *flags], check=True,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=60)
            mask = cv2.imread(str(out / 'changes.png'), cv2.IMREAD_UNCHANGED)
            boxes = sorted(found['bbox'] for found in json.loads((out / 'detections.json').read_text())['detections'])
        (i, unit), (f, _) = thesis.depths(initial, frames), thesis.depths(final, frames)
        for side in (i, f):
            side[side == 65535] = 0  # no measurement to the program, a depth of 65 m to the thesis
        case = Case(CONSTANT if method == 'constant' else GAUSSIAN, i, f, unit=unit, **options)
        expected_mask, expected_boxes = case.expected()
        np.testing.assert_array_equal(mask, expected_mask)
        self.assertEqual(boxes, expected_boxes)
        return len(boxes)

    def setUp(self):
        self.data = SHARED / 'data'
        if not self.data.is_dir():
            self.skipTest(f'no recordings in {self.data}')

    def test_bin_of_tools(self):
        for camera in ('camera0', 'camera1'):
            folder = self.data / 'bin-tools' / camera
            for threshold in (0.05, 0.02, 0.01):
                with self.subTest(camera=camera, threshold=threshold):
                    found = self.hold(folder / 'initial', folder / 'final', 'constant', threshold=threshold, min_blob=20)
                    self.assertGreater(found, 0)

    def test_arm(self):
        folder = self.data / 'arm-realsense'
        self.assertGreater(self.hold(folder / 'initial', folder / 'final', 'constant'), 0)
        for options in ({}, {'sigmas': 1.0}, {'frames': 2}, {'min_blob': 5, 'join': 10.0}):
            with self.subTest(**options):
                self.assertGreater(self.hold(folder / 'initial', folder / 'final', 'gaussian', **options), 0)

    def test_room(self):
        folder = self.data / 'room-kinect'
        with tempfile.TemporaryDirectory() as halves:
            initial, final = pathlib.Path(halves) / 'initial', pathlib.Path(halves) / 'final'
            split_frames(folder / 'frame000', initial, final)
            self.hold(initial, final, 'gaussian')
        self.hold(folder / 'frame000', folder / 'frame040', 'constant', clip=4.0)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1], verbosity=2, warnings='ignore')
