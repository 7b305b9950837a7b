"""`rva detect` where the camera was bumped or a servo came to rest beside its step, and nothing states it: simulated.

usage: turned_camera_test.py RVA
"""
import json

import program
from simulations import TOOLS, SimulationTest

FRAMES = ('--frames', 6)


class TurnedCameraTest(SimulationTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.before = cls.without_pose(cls.make('before', TOOLS, '--debris', 'none', '--seed', 1, *FRAMES))

    @staticmethod
    def without_pose(capture):
        path = capture / 'capture.json'
        description = json.loads(path.read_text())
        del description['pose']
        path.write_text(json.dumps(description))
        return capture

    def after(self, pan_deg, tilt_deg, *options):
        name = f'after {pan_deg} {tilt_deg} {len(options)}'
        return self.without_pose(self.make(name, TOOLS, '--pan', pan_deg, '--tilt', -20 + tilt_deg, *FRAMES, *options))

    def check(self, after, found, noticed):
        done = self.succeed('detect', self.before, after, '--out', self.out)
        result = json.loads((self.out / 'detections.json').read_text())
        self.assertEqual(len(result['detections']), found, done.stdout)
        self.assertEqual(result['method'], 'spatial' if noticed else 'calibrated')
        self.assertEqual('the camera turned by' in done.stderr, noticed, done.stderr)

    def test_a_camera_that_stood_still(self):
        self.check(self.after(0, 0, '--debris', 'none', '--seed', 2), 0, False)

    def test_an_unchanged_bay(self):
        for number, (pan_deg, tilt_deg) in enumerate([(0.1, 0), (0, -0.1), (0.325, 0), (-1, 0.5), (3, 0)]):
            with self.subTest(pan_deg=pan_deg, tilt_deg=tilt_deg):
                self.check(self.after(pan_deg, tilt_deg, '--debris', 'none', '--seed', 3 + number), 0, True)
                self.tidy()

    def test_three_tools(self):
        self.check(self.after(0.6, 0, '--seed', 9), 3, True)

    def test_a_method_by_name_warns(self):
        after = self.after(1, 0, '--debris', 'none', '--seed', 10)
        for method in ('constant', 'gaussian', 'calibrated'):
            done = self.succeed('detect', self.before, after, '--method', method, '--out', self.folder / method)
            self.assertRegex(done.stderr, r'warning: the camera turned by (0\.9|1)[^\n]* degrees')

    def tidy(self):
        for path in self.out.iterdir():
            path.unlink()
        self.out.rmdir()


if __name__ == '__main__':
    program.main()
