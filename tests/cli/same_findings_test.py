"""What the console shows of an inspection is what `rva detect` finds in the captures of its export, to the byte.

usage: same_findings_test.py RVA [INSPECTIONS [FIRST_SEED]]

Bays, debris, planned work and the robot's errors are drawn by chance, two inspections unless more are asked for. Each side
has four captures, the fewest whose infrared images are compared, too.
"""
import json
import random
import re
import subprocess
import sys

import program
from console_client import Console, ask
from simulations import contents

INSPECTIONS, FIRST_SEED = 2, 31


def scene(seed):
    """A scene file of a bay that its seed draws."""
    chance = random.Random(seed)
    coats = ['green-primer', 'white-paint', 'anodised-aluminium', 'carbon-fibre', 'yellow-primer']
    fittings = {kind: chance.randint(0, 2) for kind in ('brackets', 'hoses', 'cables', 'sealant')}
    wing = {'stringers': {'profile': chance.choice(['l', 'z', 'hat']), 'count': chance.randint(3, 5),
                          'material': chance.choice(coats)},
            'skin': {'upper': chance.random() < 0.5, 'material': chance.choice(coats)},
            'fittings': {**fittings, 'seed': seed}, 'dirt': chance.choice([0.0, 0.5])}
    return {'format': 'rva-scene', 'version': 1, 'wing': wing,
            'work': {'collars': chance.randint(0, 1), 'brackets': chance.randint(0, 1), 'seed': seed},
            'light': {'ambient': chance.choice([0.0, 0.05])},
            'robot': {'at_m': [0.0, 0.10, 0.0], 'pan_deg': round(chance.uniform(-10, 10), 2),
                      'tilt_deg': round(chance.uniform(-28, -18), 2)},
            'debris': [{'random': 8, 'seed': seed}]}


class SameFindingsTest(program.ProgramTest):
    def test_console_and_command_line_agree(self):
        (self.folder / 'console').mkdir()
        (self.folder / 'console' / 'index.html').write_text('<title>RVA</title>')
        shown = 0
        for seed in range(FIRST_SEED, FIRST_SEED + INSPECTIONS):
            with self.subTest(seed=seed):
                data = self.folder / f'data-{seed}'
                self.inspect(seed, data)
                found = self.compare(data)
                print(f'seed {seed}: {found} findings', file=sys.stderr)
                shown += found
        self.assertGreater(shown, 0, 'nothing was compared')

    def inspect(self, seed, data):
        file = self.folder / f'scene-{seed}.yaml'
        file.write_text(json.dumps(scene(seed)))
        server = subprocess.Popen(self.command('serve', '--camera', f'sim:{file}', '--robot', 'sim', '--seed', seed, '--data',
                                               data, '--port', 0, '--console', self.folder / 'console', '--frames', 16, '--dither', 4),
                                  stdout=subprocess.PIPE, encoding='utf-8')
        self.addCleanup(server.stdout.close)
        try:
            address = server.stdout.readline().strip()
            console = Console(address)
            self.addCleanup(console.close)
            self.wait_for_rest(console, scene(seed)['robot'])
            self.ask(address, 'inspections', {'aircraft': 'N1', 'zone': 'bay', 'work_order': 'W1', 'person': 'Ann'}, 201)
            self.take(address, console, 'initial')
            self.ask(address, 'simulation', {'done': True}, 200)
            self.take(address, console, 'final')
        finally:
            server.terminate()
            server.wait(60)

    @staticmethod
    def wait_for_rest(console, view):
        def stands(robot, axis):
            return abs(robot.get(axis, 1e9) - view[axis]) < 0.5
        console.wait_for(lambda status: status['camera']['streams'] and stands(status['robot'], 'pan_deg')
                         and stands(status['robot'], 'tilt_deg'))

    def ask(self, address, path, body, status):
        answered, answer = ask(address, 'POST', f'/api/{path}', body)
        self.assertEqual(answered, status, answer)

    def take(self, address, console, side):
        before = console.wait_for(lambda status: True)['task']['number']
        self.ask(address, 'inspections/1/capture', {'side': side, 'person': 'Ann'}, 202)
        status = console.wait_for(lambda status: status['task']['number'] > before and status['task']['end'] != 'running',
                                  timeout_s=240)
        self.assertEqual(status['task']['end'], 'done', status['task'])

    def compare(self, data):
        """How many findings there are, the same from either. The captures that are compared again are exported ones."""
        exported = self.folder / f'{data.name}-exported'
        self.succeed('export', '--data', data, '--inspection', 1, '--out', exported)
        self.assertEqual(contents(exported / 'initial'), contents(data / 'inspections' / '000001' / 'initial'))
        record = json.loads((exported / 'inspection.json').read_text())
        initial, final = ([exported / capture for capture in round['captures'][0]] for round in record['captured'])
        self.assertEqual([len(initial), len(final)], [4, 4])
        self.succeed('detect', '--initial', *initial, '--final', *final, '--classify', '--out', self.out, '--overwrite')
        shown = exported / record['rounds'][0]['results'][0]
        findings = [timeless((folder / 'detections.json').read_text()) for folder in (shown, self.out)]
        self.assertEqual(*findings)
        for name in ('changes.png', 'level_of_detection.png'):
            self.assertEqual((shown / name).read_bytes(), (self.out / name).read_bytes(), name)
        return len(json.loads(findings[0])['detections'])


def timeless(detections):
    """The text without how long it took and its provenance, which comes last: nothing else may differ."""
    untimed = re.sub(r'"runtime_ms": \{[^}]*\}', '"runtime_ms": null', detections)
    return re.sub(r',\s*"provenance": \{.*\Z', '\n}\n', untimed, flags=re.DOTALL)


if __name__ == '__main__':
    if len(sys.argv) > 2:
        INSPECTIONS = int(sys.argv.pop(2))
    if len(sys.argv) > 2:
        FIRST_SEED = int(sys.argv.pop(2))
    program.main()
