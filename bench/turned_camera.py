#!/usr/bin/python3
"""Measures how often `rva detect` notices that a camera moved, and what it then finds, in simulated trials in which the
captures do not state the motion.

usage: turned_camera.py RVA [--trials 40] [--first-seed N] [--only KIND]
Prints one line per trial, and the sums:
  unchanged   an unchanged bay, camera turned by 0.05 to 3 degrees in pan, tilt or both: findings, which are all false
  tools       the three tools of the thesis, camera turned likewise: tools found and false findings
  step        camera off by one servo step (0.325 degrees), poses stated as equal: noticed or not
  dithered    four dithered captures per side, one side off by a step, poses stated as equal: noticed or not
  rest        a camera at rest: noticed or not, which would be a false alarm
"""
import argparse
import json
import math
import pathlib
import random
import subprocess
import tempfile

import cv2

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCENES = ROOT / 'data' / 'scenes'
STEP_DEG = 0.325
FOUND = {}  # number of trials in which each tool was found
DITHERS = [(0.0, 0.0), (0.65, 0.0), (0.0, 0.65), (-0.65, -0.325)]


class Trials:
    def __init__(self, rva, folder):
        self.rva, self.folder = rva, folder

    def simulate(self, name, scene, seed, pan, tilt, debris='none', pose=None):
        """Simulates a capture, and removes its pose or replaces it by `pose`."""
        out = self.folder / name
        options = [] if debris is None else ['--debris', debris]
        subprocess.run([self.rva, 'simulate', SCENES / scene, '--out', out, '--frames', '10', '--overwrite', '--seed', str(seed),
                        '--pan', f'{pan:.4f}', '--tilt', f'{tilt:.4f}', *options], check=True, stdout=subprocess.DEVNULL)
        path = out / 'capture.json'
        description = json.loads(path.read_text())
        if pose is None:
            del description['pose']
        else:
            description['pose'] = pose
        path.write_text(json.dumps(description))
        return out

    def pose(self, name):
        return json.loads((self.folder / name / 'capture.json').read_text())['pose']

    def detect(self, *captures):
        out = self.folder / 'out'
        done = subprocess.run([self.rva, 'detect', *captures, '--out', out, '--overwrite'], capture_output=True, text=True)
        if done.returncode:
            return None, done.stderr
        return json.loads((out / 'detections.json').read_text()), done.stderr


def tools_hit(finding, capture):
    """Names of the tools that the finding's box meets in the image."""
    x, y, w, h = finding['bbox']
    labels = cv2.imread(str(capture / 'truth' / 'labels.png'), cv2.IMREAD_UNCHANGED)[y:y + h, x:x + w]
    objects = json.loads((capture / 'truth' / 'truth.json').read_text())['objects']
    return {entry['name'] for entry in objects if entry['role'] == 'debris' and (labels == entry['label']).any()}


def turn(rng):
    size = math.exp(rng.uniform(math.log(0.05), math.log(3.0))) * rng.choice((-1, 1))
    return size, rng.choice(((1, 0), (0, 1), (0.7, -0.7)))


def unchanged(trials, seed, rng):
    scene = rng.choice(('three-tools.yaml', 'hat-stringers.yaml', 'closed-wing.yaml', 'twelve-collars.yaml'))
    pan, tilt = rng.uniform(-10, 10), rng.uniform(-28, -12)
    size, (along_pan, along_tilt) = turn(rng)
    result, words = trials.detect(trials.simulate('a', scene, seed, pan, tilt),
                                  trials.simulate('b', scene, seed + 1, pan + size * along_pan, tilt + size * along_tilt))
    count = -1 if result is None else len(result['detections'])
    print(f'unchanged {seed} {scene} {size:+.3f} deg: {count} finding(s), {result and result["method"]}', flush=True)
    return count == 0


def tools(trials, seed, rng):
    size, (along_pan, along_tilt) = turn(rng)
    pan, tilt = size * along_pan, -20 + size * along_tilt
    before = trials.simulate('a', 'three-tools.yaml', seed, 0, -20)
    after = trials.simulate('b', 'three-tools.yaml', seed + 1, pan, tilt, None)
    result, words = trials.detect(before, after)
    hits = [] if result is None else [tools_hit(finding, after) for finding in result['detections']]
    found = set().union(*hits)
    false = sum(not hit for hit in hits)
    for name in found:
        FOUND[name] = FOUND.get(name, 0) + 1
    print(f'tools {seed} {size:+.3f} deg: {sorted(found)}, {false} false, {result and result["method"]}', flush=True)
    return len(found) == 3 and false == 0


def noticed(words):
    return 'the camera turned by' in words or 'stated as equal' in words


def step(trials, seed, rng):
    off = rng.choice(((STEP_DEG, 0), (-STEP_DEG, 0), (0, STEP_DEG), (0, -STEP_DEG)))
    pan, tilt = rng.uniform(-10, 10), rng.uniform(-28, -12)
    pose = {'base': 'b1', 'pan_deg': 0.0, 'tilt_deg': 0.0}
    _, words = trials.detect(trials.simulate('a', 'three-tools.yaml', seed, pan, tilt, pose=pose),
                             trials.simulate('b', 'three-tools.yaml', seed + 1, pan + off[0], tilt + off[1], pose=pose))
    print(f'step {seed} {off}: {"noticed" if noticed(words) else "NOT noticed"}', flush=True)
    return noticed(words)


def rest(trials, seed, rng):
    scene = rng.choice(('three-tools.yaml', 'hat-stringers.yaml', 'closed-wing.yaml', 'twelve-collars.yaml'))
    pan, tilt = rng.uniform(-10, 10), rng.uniform(-28, -12)
    _, words = trials.detect(trials.simulate('a', scene, seed, pan, tilt), trials.simulate('b', scene, seed + 1, pan, tilt, None))
    print(f'rest {seed} {scene}: {"NOTICED" if noticed(words) else "not noticed"}', flush=True)
    return not noticed(words)


def dithered(trials, seed, rng):
    off = rng.choice(((STEP_DEG, 0), (-STEP_DEG, 0), (0, STEP_DEG), (0, -STEP_DEG)))
    pan, tilt = rng.uniform(-10, 10), rng.uniform(-28, -12)
    sides = {'--initial': [], '--final': []}
    for number, (aside, above) in enumerate(DITHERS):
        for side, (by_pan, by_tilt) in (('--initial', (0, 0)), ('--final', off)):
            name = f'{side[2:]}{number}'
            # The robot states the pose to which it was sent.
            subprocess.run([trials.rva, 'simulate', SCENES / 'three-tools.yaml', '--out', trials.folder / 'stated', '--frames', '1',
                            '--overwrite', '--debris', 'none', '--pan', f'{pan + aside:.4f}', '--tilt', f'{tilt + above:.4f}',
                            '--supersampling', '1'], check=True, stdout=subprocess.DEVNULL)
            sides[side].append(trials.simulate(name, 'three-tools.yaml', seed + 2 * number + (side == '--final'),
                                               pan + aside + by_pan, tilt + above + by_tilt, pose=trials.pose('stated')))
    _, words = trials.detect('--initial', *sides['--initial'], '--final', *sides['--final'])
    print(f'dithered {seed} {off}: {"noticed" if noticed(words) else "NOT noticed"}', flush=True)
    return noticed(words)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('rva')
    parser.add_argument('--trials', type=int, default=40)
    parser.add_argument('--first-seed', type=int, default=1)
    parser.add_argument('--only', choices=('unchanged', 'tools', 'step', 'dithered', 'rest'))
    arguments = parser.parse_args()
    sums = {}
    with tempfile.TemporaryDirectory(prefix='rva-turned-') as folder:
        trials = Trials(arguments.rva, pathlib.Path(folder))
        for kind in (unchanged, tools, step, dithered, rest):
            if arguments.only and kind.__name__ != arguments.only:
                continue
            rng = random.Random(arguments.first_seed)
            right = sum(kind(trials, arguments.first_seed + 100 * number, rng) for number in range(arguments.trials))
            sums[kind.__name__] = right
    for name, right in sums.items():
        print(f'{name}: {right} of {arguments.trials} right')
    for name, count in sorted(FOUND.items()):
        print(f'  {name} found in {count}')


if __name__ == '__main__':
    main()
