"""Every program of examples/, run on small inputs of data/.

usage: examples_test.py FOLDER_OF_PROGRAMS REPOSITORY
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np

PROGRAMS, ROOT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
NAMES = sorted(path.stem for path in (ROOT / 'examples').glob('*.cpp'))
BIN = ROOT / 'data' / 'bin-tools'
SCENES = ROOT / 'data' / 'scenes'
TIMEOUT_S = 120
NUMBER = r'(-?\d+(?:\.\d+)?)'
POSITION = re.compile(rf'at \({NUMBER}, {NUMBER}, {NUMBER}\) m')


def run(name, *arguments):
    return subprocess.run([PROGRAMS / name, *map(str, arguments)], stdin=subprocess.DEVNULL, capture_output=True,
                          text=True, timeout=TIMEOUT_S)


def pose(capture):
    numbers = json.loads((capture / 'capture.json').read_text())['pose']['world_from_camera']
    return np.array(numbers).reshape(4, 4)


def pixels(capture, output):
    """Where the findings of an output project to."""
    camera = json.loads((capture / 'capture.json').read_text())['depth']
    points = np.array(POSITION.findall(output), float)
    return points[:, :2] / points[:, 2:] * (camera['fx'], camera['fy']) + (camera['cx'], camera['cy'])


class ExamplesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix='rva-test-')
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)
        cls.initial, cls.final = cls.folder / 'initial', cls.folder / 'final'
        cls.simulated = [run('simulate', SCENES / 'moved-robot-initial.yaml', cls.initial, 1),
                         run('simulate', SCENES / 'moved-robot.yaml', cls.final, 2)]

    def succeed(self, name, *arguments):
        done = run(name, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def number(self, pattern, output):
        found = re.search(pattern.replace('#', NUMBER), output)
        self.assertTrue(found, f'{pattern} in {output}')
        return float(found[1])

    def boxes_hit(self, points):
        """The names of the true objects that a finding lies on."""
        truth = json.loads((BIN / 'truth.json').read_text())['objects']
        return {entry['name'] for entry in truth for u, v in points
                if 0 <= u - entry['bbox'][0] <= entry['bbox'][2] and 0 <= v - entry['bbox'][1] <= entry['bbox'][3]}

    def test_all_are_listed_and_state_their_usage(self):
        self.assertEqual(len(NAMES), 8)
        page = (ROOT / 'examples' / 'README.md').read_text()
        for name in NAMES:
            with self.subTest(name):
                self.assertIn(f'({name}.cpp)', page)
                done = run(name)
                self.assertEqual((done.returncode, done.stdout), (2, ''))
                self.assertRegex(done.stderr, rf'\Ausage: {name} [^\n]+\n\Z')

    def test_errors_are_one_line(self):
        missing = self.folder / 'missing'
        for name, *arguments in (('open_capture', missing), ('statistics', missing), ('statistics', BIN / 'final'),
                                 ('detect', missing, BIN / 'final'), ('register_views', missing, missing),
                                 ('simulate', missing, self.folder / 'none'), ('own_camera', self.initial),
                                 ('own_detector', BIN / 'initial', self.final), ('talk_to_robot', missing)):
            with self.subTest(name):
                done = run(name, *arguments)
                self.assertEqual((done.returncode, done.stdout), (1, ''))
                self.assertRegex(done.stderr, rf'\A{name}: [^\n]+: [^\n]+; [^\n]+\n\Z')

    def test_open_capture(self):
        output = self.succeed('open_capture', BIN / 'final')
        self.assertIn('640x480, fx 619.871 fy 619.871 cx 314.241 cy 238.906', output)
        self.assertIn('frames      1 depth, 1 color', output)
        self.assertIn('depth unit  0.0001 m\n', output)
        self.assertLess(self.number('depth +# to', output), self.number(r'depth +[\d.]+ to #', output))

    def test_simulate(self):
        for done, capture in zip(self.simulated, (self.initial, self.final)):
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(len(list((capture / 'depth').glob('*.png'))), 10)

    def test_statistics(self):
        output = self.succeed('statistics', self.initial)
        self.assertTrue(output.startswith('10 frames'), output)
        self.assertTrue(0.01 < self.number('# px', output) < 0.1, output)

    def test_detect_finds_tools_in_a_bin(self):
        output = self.succeed('detect', BIN / 'initial', BIN / 'final')
        self.assertRegex(output, r'\A\d+ finding\(s\) by method calibrated\n')
        self.assertRegex(output, r'\n  1 added +at \(.+\) m  size \d+ x \d+ mm  height [\d.]+ mm  p-value [\d.e-]+\n')
        self.assertLessEqual({'whisk', 'torch'}, self.boxes_hit(pixels(BIN / 'final', output)))
        self.assertAlmostEqual(sum(float(share) for share in re.findall(rf'{NUMBER} %', output)), 100, delta=0.2)

    def test_detect_finds_tools_after_the_camera_moved(self):
        output = self.succeed('detect', self.initial, self.final)
        self.assertRegex(output, r'\A\d+ finding\(s\) by method spatial\n')
        self.assertGreaterEqual(len(POSITION.findall(output)), 3)

    def test_register_views(self):
        output = self.succeed('register_views', self.initial, self.final)
        rows = np.array([line.split() for line in output.splitlines()[1:4]], float)
        truth = np.linalg.inv(pose(self.initial)) @ pose(self.final)
        np.testing.assert_allclose(rows[:, :3], truth[:3, :3], atol=0.005)
        np.testing.assert_allclose(rows[:, 3], truth[:3, 3], atol=0.005)
        self.assertTrue(0 < self.number('translation along x y z  #', output) < 5, output)

    def test_own_camera_records_a_plane_that_registration_refuses(self):
        plane = self.folder / 'plane'
        self.succeed('own_camera', plane)
        self.assertIn('frames      20 depth', self.succeed('open_capture', plane))
        self.assertAlmostEqual(self.number('# px', self.succeed('statistics', plane)), 0.1, delta=0.01)
        done = run('register_views', plane, plane)
        self.assertEqual((done.returncode, done.stdout), (1, ''))
        self.assertRegex(done.stderr, r'\Aregister_views: refused: [^\n]+\n\Z')

    def test_own_detector(self):
        output = self.succeed('own_detector', BIN / 'initial', BIN / 'final')
        self.assertLessEqual({'whisk', 'torch'}, self.boxes_hit(pixels(BIN / 'final', output)))

    def test_talk_to_robot(self):
        rows = re.findall(rf'target +{NUMBER} +{NUMBER} deg, joints +{NUMBER} +{NUMBER} deg',
                          self.succeed('talk_to_robot', 'sim'))
        self.assertEqual(len(rows), 12)
        targets, joints = np.split(np.array(rows, float), 2, axis=1)
        self.assertLessEqual(np.abs(targets - joints).max(), 0.1625)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1], verbosity=2, warnings='ignore')
