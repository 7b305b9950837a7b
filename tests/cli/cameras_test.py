"""Cameras: which are there, how one does today, and what a recorder leaves that is killed.

usage: cameras_test.py RVA
"""
import json
import os
import signal
import subprocess
import time

import program
from captures import CAMERA, noisy, write_capture
from simulations import WALL

FRAMES = 12


class Cameras(program.ProgramTest):
    def test_says_which_are_there_or_how_to_get_them(self):
        done = self.succeed('cameras')
        self.assertRegex(done.stdout, r'realsense:|no camera is plugged in|librealsense2-dev')
        said = json.loads(self.succeed('cameras', '--json').stdout)
        self.assertEqual((said['format'], said['version']), ('rva-cameras', 1))

    def test_a_camera_that_is_not_there(self):
        self.check_fails('record', '--camera', 'realsense:none-such', '--frames', 1, '--out', self.out)
        done = self.rva('record', '--camera', 'realsense:', '--frames', 1, '--out', self.out)
        self.assertEqual(done.returncode, 2)
        done = self.rva('record', '--camera', 'realsense', '--gain', 1, '--frames', 1, '--out', self.out)
        self.assertEqual(done.returncode, 2)
        self.assertIn('--gain', done.stderr)

    def test_what_cannot_turn_it(self):
        for robot in ('sim', 'none'):
            for command in (('map', '--grid', '0,10,2,-20,-10,2', '--out', self.folder / 'map.ply'),
                            ('serve', '--data', self.folder / 'data')):
                if (command[0], robot) == ('serve', 'none'):
                    continue
                done = self.rva(*command, '--camera', 'realsense', '--robot', robot)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.check_line(done.stderr, ['--robot'])


class Check(program.ProgramTest):
    """`rva noise --camera`, before a scene that stays."""

    def setUp(self):
        super().setUp()
        self.history = self.folder / 'history'

    def check(self, seed, sigma=2.0, depth=1000, status=0, frames=FRAMES):
        source = write_capture(self.folder / f'seen-{seed}', noisy(CAMERA.plane(depth), FRAMES, sigma, seed),
                               camera={'model': 'D435', 'serial': '12/3', 'baseline_m': 0.05})
        done = self.succeed('noise', '--camera', f'replay:{source}', '--frames', frames, '--history', self.history,
                            '--json', status=status)
        return json.loads(done.stdout)

    def unfit(self, said):
        return [quantity['name'] for quantity in said['quantities'] if not quantity['fit']]

    def test_judges_by_earlier_checks(self):
        for seed in range(5):
            said = self.check(seed)
            self.assertEqual((said['known'], said['fit'], said['earlier']), (False, True, seed))
        self.assertEqual([path.name for path in self.history.iterdir()], ['12-3.jsonl'])
        self.assertTrue(self.check(5)['known'])
        self.assertEqual(self.unfit(self.check(6, sigma=4.0, status=3)), ['noise'])
        self.assertEqual(self.unfit(self.check(7, depth=1300, status=3)), ['distance'])
        said = self.check(8)
        self.assertEqual((said['fit'], said['earlier']), (True, 6), 'what was unfit is no standard')

    def test_says_what_to_do(self):
        for seed in range(5):
            self.check(seed)
        source = write_capture(self.folder / 'noisy', noisy(CAMERA.plane(1000), FRAMES, 9.0, 9), camera={'serial': '12/3'})
        done = self.succeed('noise', '--camera', f'replay:{source}', '--frames', FRAMES, '--history', self.history, status=3)
        self.assertIn('not fit: noise; clean its windows', done.stdout)

    def test_a_damaged_history_is_said_and_kept(self):
        self.check(1)
        file = self.history / '12-3.jsonl'
        file.write_text('{"taken_at": 3}\n')
        self.check_fails('noise', '--camera', f'replay:{self.folder / "seen-1"}', '--frames', FRAMES, '--history',
                         self.history, names=['12-3.jsonl:1', 'taken_at'])

    def test_wrong_usage(self):
        source = write_capture(self.folder / 'source', noisy(CAMERA.plane(1000), FRAMES, 2.0, 1))
        for arguments in ((), (source,), ('--out', self.out), (source, '--camera', f'replay:{source}'),
                          ('--camera', f'replay:{source}', '--out', self.out),
                          ('--camera', f'replay:{source}', '--frames', 3),
                          ('--camera', f'replay:{source}', '--least-checks', 2)):
            with self.subTest(arguments):
                self.assertEqual(self.rva('noise', *arguments).returncode, 2)
        self.check_fails('noise', '--camera', f'replay:{source}', '--frames', FRAMES + 1, '--history', self.history,
                         names=[f'{FRAMES} of {FRAMES + 1}'])


class Killed(program.ProgramTest):
    def test_a_recorder_that_is_killed_loses_the_frames_in_flight_alone(self):
        with subprocess.Popen(self.command('record', '--camera', f'sim:{WALL}', '--frames', 5000, '--out', self.out),
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=self.folder) as process:
            def written():
                return sorted(self.folder.glob('out.partial-*/depth/0*.png'))
            deadline = time.monotonic() + program.TIMEOUT_S
            while len(written()) < 3 and time.monotonic() < deadline:
                time.sleep(0.01)
            os.kill(process.pid, signal.SIGKILL)
        self.assertFalse(self.out.exists())
        partial, = self.folder.glob('out.partial-*')
        said = self.info(partial)
        self.assertEqual(said['depth_frames'], len([path for path in written() if path.name.count('.') == 1]))
        self.assertGreaterEqual(said['depth_frames'], 3)
        begun = len((partial / 'frames.jsonl').read_text().splitlines())
        self.assertLessEqual(begun - said['depth_frames'], 2 * os.cpu_count())


if __name__ == '__main__':
    program.main()
