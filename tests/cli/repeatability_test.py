"""`rva robot repeatability` from end to end, on the simulated robot.

usage: repeatability_test.py RVA
"""
import json
import os
import signal
import subprocess

import program
from simulations import TOOLS, WALL

REPEATABILITY = ('robot', 'repeatability')


class RepeatabilityTest(program.ProgramTest):
    def arguments(self, *options, camera='sim:three-tools', robot='sim', pose=(-30, -35)):
        waypoints = self.folder / 'waypoints.json'
        pan_deg, tilt_deg = pose
        waypoints.write_text(json.dumps({'format': 'rva-waypoints', 'version': 1,
                                         'waypoints': [{'pan_deg': pan_deg, 'tilt_deg': tilt_deg}]}))
        return (*REPEATABILITY, '--camera', camera, '--robot', robot, '--waypoints', waypoints, '--returns', 4,
                '--frames', 2, *options)

    def refused(self, *options, names=(), status=1, **keys):
        arguments = self.arguments(*options, **keys)
        before = self.names()
        done = self.rva(*arguments)
        self.assertEqual((done.returncode, done.stdout), (status, ''), done.stderr)
        self.check_line(done.stderr, names)
        self.assertEqual(self.names(), before)

    def test_states_every_return_and_a_verdict(self):
        arguments = self.arguments('--json', '--out', self.out, '--most-deviation', 10, '--most-play', 5)
        done = self.succeed(*arguments)
        self.assertEqual(done.stdout, self.out.read_text())
        result = json.loads(done.stdout)
        self.assertEqual((result['format'], result['version'], result['verdict'], result['returns']),
                         ('rva-repeatability', 1, 'fit', 4))
        self.assertEqual(result['pictures'], 'infrared under the lamp')
        [pose] = result['poses']
        self.assertEqual((pose['pan_deg'], pose['tilt_deg'], len(pose['still'])), (-30, -35, 6))
        sides = {(back['pan_from'], back['tilt_from']) for back in pose['returns']}
        self.assertEqual(len(sides), 4, 'it arrives from each side in both joints')
        for joint in ('pan', 'tilt'):
            figures = result[joint]
            for name in ('deviation_deg', 'deviation_from_larger_deg', 'play_deg', 'noise_deg'):
                self.assertLessEqual(figures[name]['low'], figures[name]['value'])
                self.assertLessEqual(figures[name]['value'], figures[name]['high'])
            off = [abs(back[f'{joint}_deg']) for back in pose['returns'] if back[f'{joint}_from'] == 'smaller']
            self.assertEqual(figures['most_off_deg'], max(off))
            self.assertLess(figures['most_off_deg'], 0.33, 'a servo rests within half a step')
            self.assertLess(figures['noise_deg']['value'], 0.005)
            self.assertAlmostEqual(pose['known_turn'][f'{joint}_deg'], pose['seen_turn'][f'{joint}_deg'], delta=0.35)
        self.assertEqual([c['fitness'] for c in result['criteria']], 8 * ['fit'])
        self.refused('--out', self.out, names=['already exists', '--overwrite'])

    def test_a_robot_that_is_not_fit_ends_with_a_status_of_its_own(self):
        text = self.succeed(*self.arguments('--most-off', 0.05), status=3).stdout
        self.assertRegex(text, r'pan: most_off 0\.\d+ .*limit 0\.05: unfit')
        self.assertIn('unfit: tighten the screws', text)

    def test_what_cannot_be_measured_is_refused(self):
        self.refused('--geometry', WALL, names=[WALL])
        self.refused(robot='serial:/dev/ttyNONE', names=['/dev/ttyNONE', 'no such device'])
        self.refused(robot='serial:/dev/null', names=['/dev/null'])
        self.refused(camera=f'sim:{WALL}', pose=(0, -78), names=['measures no depth', 'aim it'])
        self.refused(camera='sim:no-such-scene', names=['no-such-scene', 'no such file'])

    def test_wrong_usage_is_explained(self):
        for keys, names in (({'robot': 'none'}, ['none cannot turn the camera']),
                            ({'robot': 'walking'}, ['serial:DEVICE']),
                            ({'camera': 'realsense'}, ['simulated one cannot turn a real camera']),
                            ({'camera': f'replay:{self.folder}'}, ['sim:SCENE']),
                            ({'pose': (0, 5)}, ['10 degrees around it', '--leave']),
                            ({'pose': (100, 0)}, ['waypoint 1'])):
            with self.subTest(**keys):
                self.refused(status=2, names=names, **keys)
        for option in (('--returns', 1), ('--returns', 'many'), ('--frames', 0), ('--most-off', 0),
                       ('--most-play', 'nan'), ('--leave', 1)):
            with self.subTest(option=option):
                self.refused(*option, status=2, names=[option[0]])
        self.assertEqual(self.rva('robot').returncode, 2)

    def test_an_interrupt_leaves_nothing(self):
        ours, theirs = os.openpty()
        with subprocess.Popen(self.command(*self.arguments('--out', self.out)), stdout=subprocess.DEVNULL,
                              stderr=theirs, stdin=subprocess.DEVNULL, cwd=self.folder) as process:
            os.close(theirs)
            seen = b''
            while b'returns' not in seen:
                part = program.read_terminal(ours)
                self.assertTrue(part, seen)
                seen += part
            process.send_signal(signal.SIGINT)
            while program.read_terminal(ours):
                pass
            self.assertEqual(process.wait(program.TIMEOUT_S), 130)
        os.close(ours)
        self.assertFalse(self.out.exists())


if __name__ == '__main__':
    program.main()
