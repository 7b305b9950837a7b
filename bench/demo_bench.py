"""Performs the inspection of script/demo through the API, and counts which of its three objects are reported.

usage: demo_bench.py RVA [--runs 10] [--first-seed 1520001] [--frames 80] [--at-once 1]

Each run has a seed of its own, which draws the camera's noise and the robot's errors. The objects are projected into each
view by `rva simulate`. An object is reported if the box of a finding overlaps its own; a finding that overlaps none, in any
of its views, is another one.
"""
import argparse
import concurrent.futures
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / 'tests' / 'cli'))

from console_client import Console, ask  # noqa: E402

SCENE = ROOT / 'data' / 'scenes' / 'three-tools.yaml'
OBJECTS = ('flashlight', 'screwdriver', 'key')
VIEWS = [{'pan_deg': 0.0, 'tilt_deg': -20.0}, {'pan_deg': 9.0, 'tilt_deg': -20.0}]
MARGIN_PX = 4  # the robot comes to rest within half a servo step, 1.2 px
TASK_LIMIT_S = 1800
MOST_TRIES = 10


def boxes_of_objects(rva, view, folder):
    """The box of each object in a view, by name."""
    out = folder / f'view-{view["pan_deg"]:g}'
    subprocess.run([rva, 'simulate', SCENE, '--frames', '1', '--supersampling', '1', '--pan', str(view['pan_deg']), '--tilt',
                    str(view['tilt_deg']), '--out', out], check=True, capture_output=True)
    truth = json.loads((out / 'truth' / 'truth.json').read_text())
    return {entry['name']: entry['bbox'] for entry in truth['objects'] if entry['name'] in OBJECTS and 'bbox' in entry}


def overlap(a, b):
    return all(a[i] < b[i] + b[i + 2] + MARGIN_PX and b[i] < a[i] + a[i + 2] + MARGIN_PX for i in (0, 1))


class Inspection:
    """The steps of one inspection. Without a screen, views are given by their angles."""

    def __init__(self, rva, seed, frames, folder):
        (folder / 'console').mkdir()
        (folder / 'console' / 'index.html').write_text('<title>RVA</title>')
        self.server = subprocess.Popen([rva, 'serve', '--camera', f'sim:{SCENE}', '--robot', 'sim', '--seed', str(seed), '--data',
                                        folder / 'data', '--port', '0', '--console', folder / 'console', '--frames', str(frames)],
                                       stdout=subprocess.PIPE, encoding='utf-8')
        self.console = None
        self.address = self.server.stdout.readline().strip()

    def open_console(self):
        self.console = Console(self.address)
        self.console.wait_for(lambda status: status['camera']['streams'] and
                              abs(status['robot'].get('tilt_deg', 1e9) - VIEWS[0]['tilt_deg']) < 0.5)

    def ask(self, method, path, body=None):
        status, answer = ask(self.address, method, f'/api/{path}', body, client=self.console.client)
        if status >= 300:
            raise RuntimeError(f'{method} {path}: {answer}')
        return answer

    def take(self, side):
        """Captures a side, again where the computer is so busy that the simulated camera renders no frame in time."""
        for _ in range(MOST_TRIES):
            end = self.try_to_take(side)
            if end['end'] == 'done':
                return
            if 'no frame' not in end.get('problem', ''):
                break
        raise RuntimeError(end)

    def try_to_take(self, side):
        before = self.console.status['task']['number']
        self.ask('POST', 'inspections/1/capture', {'side': side, 'person': 'Ann'})
        last = 'check' if side == 'initial' else 'comparison'
        status = self.console.wait_for(
            lambda status: status['task']['number'] > before and status['task']['end'] != 'running' and
            (status['task']['kind'] == last or status['task']['end'] != 'done'), timeout_s=TASK_LIMIT_S)
        return status['task']

    def findings(self):
        self.open_console()
        self.ask('POST', 'inspections', {'aircraft': 'N1', 'zone': 'bay', 'work_order': 'W1', 'person': 'Ann'})
        self.ask('PUT', 'inspections/1/views', {'views': VIEWS})
        self.take('initial')
        self.ask('POST', 'simulation', {'done': True})
        self.take('final')
        return self.ask('GET', 'inspections/1')['findings']

    def end(self):
        if self.console:
            self.console.close()
        self.server.terminate()
        self.server.wait(60)
        self.server.stdout.close()


def judge(findings, boxes):
    """The names of the objects that are reported, and the number of findings that are of none, each counted once for all of
    its views."""
    reported, of_an_object = set(), set()
    for finding in findings:
        for name, box in boxes[finding['view']].items():
            if overlap(finding['bbox'], box):
                reported.add(name)
                of_an_object.add(finding['same_as'])
    return reported, len({finding['same_as'] for finding in findings} - of_an_object)


def run(rva, seed, frames, boxes):
    with tempfile.TemporaryDirectory(prefix='rva-demo-') as folder:
        inspection = Inspection(rva, seed, frames, pathlib.Path(folder))
        try:
            return (seed, *judge(inspection.findings(), boxes))
        finally:
            inspection.end()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('rva')
    parser.add_argument('--runs', type=int, default=10)
    parser.add_argument('--first-seed', type=int, default=1520001)
    parser.add_argument('--frames', type=int, default=80, help='depth frames of each view, over all of its captures')
    parser.add_argument('--at-once', type=int, default=1)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix='rva-demo-truth-') as folder:
        boxes = [boxes_of_objects(arguments.rva, view, pathlib.Path(folder)) for view in VIEWS]
    print('seed     ', *(f'{name:12}' for name in OBJECTS), 'other findings')
    seeds = range(arguments.first_seed, arguments.first_seed + arguments.runs)
    total, others = dict.fromkeys(OBJECTS, 0), []
    with concurrent.futures.ThreadPoolExecutor(arguments.at_once) as runs:
        for done in runs.map(lambda seed: run(arguments.rva, seed, arguments.frames, boxes), seeds):
            seed, reported, other = done
            print(f'{seed:9}', *(f'{"reported" if name in reported else "-":12}' for name in OBJECTS), other, flush=True)
            others.append(other)
            for name in reported:
                total[name] += 1
    print('all      ', *(f'{f"{total[name]} of {len(others)}":12}' for name in OBJECTS),
          f'{sum(others)}, at most {max(others)} in one')


if __name__ == '__main__':
    main()
