"""Infrared images as evidence, from captures to findings.

usage: infrared_test.py RVA
"""
import json
import pathlib
import shutil
import subprocess
import tempfile

import cv2
import program

HEAD = """format: rva-scene
version: 1
wing: {}
light: { ambient: 0.02 }
robot: { at_m: [0, 0.10, 0], tilt_deg: -20 }
"""
COLLARS = [('0.53', 0.135, 0.378), ('0.36', -0.085, 0.562), ('0.27', -0.195, 0.562), ('0.44', 0.025, 0.745),
           ('0.53', 0.135, 0.745)]
DITHER, FRAMES = 8, 5


class InfraredTest(program.ProgramTest):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix='rva-test-')
        cls.addClassCleanup(temporary.cleanup)
        cls.recorded = pathlib.Path(temporary.name)
        debris = ''.join(f'  - {{ kind: collar-{inches}, on: [{x}, {y}] }}\n' for inches, x, y in COLLARS)
        for seed, (side, text) in enumerate({'before': HEAD, 'unchanged': HEAD, 'after': HEAD + 'debris:\n' + debris}.items()):
            scene = cls.recorded / f'{side}.yaml'
            scene.write_text(text)
            subprocess.run([program.PROGRAM, 'record', '--camera', f'sim:{scene}', '--frames', str(FRAMES), '--dither',
                            str(DITHER), '--seed', str(seed), '--out', cls.recorded / side], check=True, capture_output=True)

    def setUp(self):
        super().setUp()
        self.before, self.unchanged, self.after = (self.own_copy(side) for side in ('before', 'unchanged', 'after'))

    def own_copy(self, side):
        shutil.copytree(self.recorded / side, self.folder / side)
        return sorted((self.folder / side).iterdir())

    def compare(self, initial, final):
        done = self.succeed('detect', '--initial', *initial, '--final', *final, '--out', self.out, '--overwrite')
        return json.loads((self.out / 'detections.json').read_text()), done.stderr

    def test_they_show_what_depth_does_not(self):
        result, _ = self.compare(self.before, self.after)
        self.assertGreater(result['coverage']['appearance'], 0.3)
        findings = result['detections']
        self.assertGreaterEqual(len(findings), 3, 'of five collars')
        for finding in findings:
            self.assertEqual(finding['kind'] == 'appearance', finding['evidence'] == ['appearance'], finding)
        alone = [finding['kind'] == 'appearance' for finding in findings]
        self.assertEqual(alone, sorted(alone), 'findings of appearance alone come last')
        self.assertIn(True, alone)
        self.assertEqual([finding['id'] for finding in findings], list(range(1, len(findings) + 1)))
        changes = cv2.imread(str(self.out / 'changes.png'), cv2.IMREAD_UNCHANGED)
        for finding in findings:
            x, y, width, height = finding['bbox']
            self.assertEqual(changes[y:y + height, x:x + width].max(), 255)
        for capture in self.before + self.after:
            shutil.rmtree(capture / 'infrared')
        by_depth, _ = self.compare(self.before, self.after)
        self.assertNotIn('appearance', by_depth['coverage'])
        self.assertLess(len(by_depth['detections']), len(findings))
        self.assertNotIn('evidence', json.dumps(by_depth))

    def test_where_nothing_changed_they_show_nothing(self):
        result, _ = self.compare(self.before, self.unchanged)
        self.assertEqual([finding for finding in result['detections'] if finding['kind'] == 'appearance'], [])

    def test_a_side_without_them_is_compared_by_depth_which_is_said(self):
        shutil.rmtree(self.after[2] / 'infrared')
        result, said = self.compare(self.before, self.after)
        self.assertIn('not every capture has infrared images: depth alone was compared', said)
        self.assertNotIn('appearance', result['coverage'])

    def test_fewer_than_four_captures_leave_too_much_under_dots(self):
        result, said = self.compare(self.before[:3], self.after[:3])
        self.assertNotIn('appearance', result['coverage'])
        self.assertNotIn('infrared', said)

    def test_means_of_16_bits_count_by_their_scale(self):
        for capture in self.before + self.after:
            images = sorted((capture / 'infrared').iterdir())
            mean = sum(cv2.imread(str(image), cv2.IMREAD_UNCHANGED).astype(float) for image in images) / len(images)
            for image in images:
                image.unlink()
            cv2.imwrite(str(images[0]), (mean * 256).round().astype('uint16'))
            description = capture / 'capture.json'
            description.write_text(json.dumps({**json.loads(description.read_text()),
                                               'infrared': {'scale': 256, 'frames': FRAMES}}))
        result, _ = self.compare(self.before, self.after)
        self.assertGreaterEqual(len(result['detections']), 3)
        for bad in ({'scale': 0}, {'scale': 256, 'frames': 1e300}, {'scale': 256, 'frames': 0}):
            description.write_text(json.dumps({**json.loads(description.read_text()), 'infrared': bad}))
            self.check_fails('info', self.after[-1], names=[list(bad)[-1]])


if __name__ == '__main__':
    program.main()
