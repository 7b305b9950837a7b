"""`rva record` from end to end: from a simulated camera and from recordings.

usage: record_test.py RVA
"""
import json
import shutil
import signal

import numpy as np

import program
from captures import (CAMERA, TUM_INTRINSICS, noisy, plain_color, read_image, write_capture, write_open3d,
                      write_tum)
from simulations import CHEAP, WALL, SimulationTest, contents, depth_frames, description, frame_files

FRAMES = 3


class RecordTest(SimulationTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.recording = cls.make('recording', WALL, '--frames', FRAMES, *CHEAP)

    def arguments(self, uri, frames=FRAMES, *options):
        return ['record', '--camera', uri, '--frames', frames, '--out', self.out, *options]

    def record(self, uri, frames=FRAMES, *options):
        done = self.succeed(*self.arguments(uri, frames, *options))
        self.assertEqual((done.stdout, done.stderr), (f'{self.out}\n', ''))
        return self.out

    def replay(self, source, *rest):
        return self.record(f'replay:{source}', *rest)


class FromReplay(RecordTest):
    def test_frames_are_those_of_the_recording(self):
        self.replay(self.recording)
        np.testing.assert_array_equal(depth_frames(self.out), depth_frames(self.recording))
        self.assertEqual(len(frame_files(self.out, 'color')), 1)
        np.testing.assert_array_equal(read_image(self.out / 'color' / '000000.png'),
                                      read_image(self.recording / 'color' / '000000.png'))
        self.assertEqual(description(self.out), description(self.recording))
        self.assertEqual(self.info(self.out)['depth_frames'], FRAMES)
        self.assertFalse((self.out / 'truth').exists(), 'a recording has no truth')

    def test_a_name_that_ends_in_mcap_gives_a_recording(self):
        self.out = self.folder / 'out.mcap'
        self.replay(self.recording)
        recorded = self.info(self.out)
        self.assertEqual((recorded['format'], recorded['depth_frames']), ('mcap', FRAMES))
        self.check_fails(*self.arguments(f'replay:{self.recording}'), names=['out.mcap', 'already exists'])
        self.check_fails(*self.arguments(f'replay:{self.recording}', FRAMES + 1, '--overwrite'), names=['3 of 4 frames'])
        again = self.folder / 'again'
        self.succeed('record', '--camera', f'replay:{self.out}', '--frames', FRAMES, '--out', again)
        np.testing.assert_array_equal(depth_frames(again), depth_frames(self.recording))
        for key in ('depth', 'color', 'color_from_depth', 'camera', 'pose', 'infrared'):
            self.assertEqual(description(again).get(key), description(self.recording).get(key), key)

    def test_fewer_frames_are_the_first_ones(self):
        self.replay(self.recording, 2)
        np.testing.assert_array_equal(depth_frames(self.out), depth_frames(self.recording)[:2])

    def test_more_frames_than_there_are(self):
        self.check_fails(*self.arguments(f'replay:{self.recording}', FRAMES + 1),
                         names=['3 of 4 frames', 'fewer frames'])

    def test_unknown_keys_are_kept(self):
        source = self.folder / 'source'
        shutil.copytree(self.recording, source)
        said = description(source)
        said['site'] = {'bay': [3, 'left'], 'nothing': None}
        said['depth']['exposure_us'] = 8500
        said['pose']['operator'] = 'Zoë'
        (source / 'capture.json').write_text(json.dumps(said))
        self.assertEqual(description(self.replay(source)), said)

    def test_open3d_becomes_ours(self):
        frames = noisy(CAMERA.plane(5000), FRAMES, 1.0, seed=2)
        picture = plain_color(CAMERA.width, CAMERA.height, (200, 100, 50))
        source = write_open3d(self.folder / 'source', frames, pictures=[picture] * 2, depth_scale=5000,
                              serial_number='f0190')
        self.replay(source)
        np.testing.assert_array_equal(depth_frames(self.out), frames)
        self.assertEqual(len(frame_files(self.out, 'color')), 2)
        made = description(self.out)
        self.assertEqual((made['format'], made['depth']['unit_m'], made['depth']['fy'], made['camera']['serial']),
                         ('rva-capture', 1 / 5000, CAMERA.fy, 'f0190'))

    def test_tum_becomes_ours(self):
        frames = noisy(CAMERA.plane(5000), FRAMES, 1.0, seed=2)
        source = write_tum(self.folder / 'source', frames)
        self.check_fails(*self.arguments(f'replay:{source}'), names=[source, 'intrinsics'])
        self.replay(source, FRAMES, *TUM_INTRINSICS)
        np.testing.assert_array_equal(depth_frames(self.out), frames)
        self.assertEqual(description(self.out)['depth']['fy'], CAMERA.fy)

    def test_damaged_recording(self):
        source = write_capture(self.folder / 'source', noisy(CAMERA.plane(1000), FRAMES, 1.0, seed=2))
        self.replay(source, 2)
        kept = contents(self.out)
        whole = (source / 'depth' / '000002.png').read_bytes()
        (source / 'depth' / '000002.png').write_bytes(whole[:len(whole) // 2])
        self.check_fails(*self.arguments(f'replay:{source}', FRAMES, '--overwrite'), names=['depth/000002.png'])
        self.assertEqual(contents(self.out), kept)
        self.check_fails(*self.arguments(f'replay:{self.folder / "none"}', 1, '--overwrite'), names=['none'])

    def test_recording_is_never_its_own_target(self):
        """What a simulation contains beyond a recording would be lost."""
        source = self.folder / 'source'
        shutil.copytree(self.recording, source)
        kept = contents(source)
        self.check_fails('record', '--camera', f'replay:{source}', '--frames', 1, '--out', source, '--overwrite',
                         names=['truth'])
        self.assertEqual(contents(source), kept)


class FromSimulation(RecordTest):
    def test_is_what_simulate_makes(self):
        simulated = self.make('simulated', WALL, '--frames', 2, '--seed', 5)
        self.record(f'sim:{WALL}', 2, '--seed', 5)
        np.testing.assert_array_equal(depth_frames(self.out), depth_frames(simulated))
        self.assertEqual(len(frame_files(self.out, 'color')), 2)
        without_origin = description(simulated)
        del without_origin['simulation']
        self.assertEqual(description(self.out), without_origin)

    def test_interruption_leaves_nothing(self):
        self.check_interrupted(signal.SIGTERM, *self.arguments(f'sim:{WALL}', 2000))

    def test_progress_is_for_terminals(self):
        seen = self.on_a_terminal(*self.arguments(f'replay:{self.recording}'))
        self.assertIn('recording 1/3', seen)
        self.assertTrue(seen.endswith('\r\033[K'), repr(seen))

    def test_existing_folder_is_kept_or_replaced(self):
        self.replay(self.recording)
        made = contents(self.out)
        self.check_fails(*self.arguments(f'replay:{self.recording}', 1), names=[self.out, 'already exists'])
        self.assertEqual(contents(self.out), made)
        self.replay(self.recording, 1, '--overwrite')
        self.assertEqual(len(frame_files(self.out)), 1)

    def test_dithered_captures_are_of_one_base_a_few_servo_steps_apart(self):
        self.succeed('record', '--camera', f'sim:{WALL}', '--frames', 1, '--dither', 3, '--out', self.out)
        folders = sorted(path.name for path in self.out.iterdir())
        self.assertEqual(folders, ['dither-00', 'dither-01', 'dither-02'])
        poses = [description(self.out / folder)['pose'] for folder in folders]
        self.assertEqual({pose['base'] for pose in poses}, {'b1'})
        for pose, (pan, tilt) in zip(poses, ((0, 0), (4, 5), (2, 6))):
            self.assertAlmostEqual(pose['pan_deg'], 0.325 * pan, places=9)
            self.assertAlmostEqual(pose['tilt_deg'], 0.325 * tilt, places=9)
        self.succeed('record', '--camera', f'sim:{WALL}', '--frames', 1, '--dither', 2, '--out', self.out, '--overwrite')
        self.assertEqual(len(list(self.out.iterdir())), 2)

    def test_dither_needs_a_robot(self):
        self.check_usage('record', '--camera', f'replay:{self.recording}', '--dither', 2, '--out', self.out,
                         names=['--dither'])
        for dither in (0, 17, -1, 'two'):
            self.check_usage('record', '--camera', f'sim:{WALL}', '--dither', dither, '--out', self.out,
                             names=['--dither'])

    def test_wrong_usage(self):
        for uri in ('', 'sim:', 'replay:', 'sim', str(WALL), 'SIM:x', 'http://camera', ':', f' sim:{WALL}', 'a\nb:c'):
            with self.subTest(uri):
                self.check_usage(*self.arguments(uri))
        for frames in (0, -1, 1_000_001, 2**64, 'many', 1.5):
            with self.subTest(frames=frames):
                self.check_usage(*self.arguments(f'sim:{WALL}', frames), names=['--frames'])
        for arguments in (['record'], ['record', '--camera', f'sim:{WALL}'], ['record', '--out', self.out],
                          self.arguments(f'sim:{WALL}', 1, '--seed', -1), self.arguments(f'sim:{WALL}', 1, 'more')):
            with self.subTest(arguments):
                self.check_usage(*arguments)

    def check_usage(self, *arguments, names=()):
        done = self.rva(*arguments)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.check_line(done.stderr, names)
        self.assertEqual(self.names(), [])


if __name__ == '__main__':
    program.main()
