"""`.bag` files of realsense-viewer, from end to end.

usage: bag_test.py RVA [SHARED]
"""
import json
import os
import pathlib
import struct
import sys

import numpy as np

import program
from bags import COLOR, DEPTH, Bag, camera_info, image_message, lz4, u32, write_bag
from captures import CAMERA, noisy, plain_color, read_image, with_box, write_capture
from simulations import contents, depth_frames, description, frame_files

FRAMES = 5
RED = plain_color(CAMERA.width, CAMERA.height, (200, 30, 40))
BLUE = plain_color(CAMERA.width, CAMERA.height, (40, 30, 200))


class BagTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.frames = noisy(CAMERA.plane(1000, per_column=2), FRAMES, 1.0, seed=1)
        self.bag = self.folder / 'recording.bag'

    def write(self, **options):
        return write_bag(self.bag, self.frames, **options)

    def record(self, frames, *options):
        self.succeed('record', '--camera', f'replay:{self.bag}', '--frames', frames, '--out', self.out, *options)
        return self.out


class Reading(BagTest):
    def test_frames_are_those_that_were_written(self):
        for options in ({}, {'compression': 'none'}, {'unit_in_frames': True}, {'padding': 10}, {'frames_per_chunk': 1},
                        {'frames_per_chunk': FRAMES}, {'finish': False}, {'finish': False, 'compression': 'none'}):
            with self.subTest(options):
                self.write(frames_per_chunk=options.pop('frames_per_chunk', 2), **options)
                whole = FRAMES if options.get('finish', True) else 4
                np.testing.assert_array_equal(depth_frames(self.record(whole, '--overwrite')), self.frames[:whole])
                self.assertEqual(self.info(self.bag)['depth_frames'], whole)

    def test_says_what_the_camera_was(self):
        self.write(pictures=[(0, RED)], unit_m=0.0001)
        said = self.info(self.bag)
        self.assertEqual((said['format'], said['depth']['unit_m'], said['depth']['fx'], said['depth']['cy']),
                         ('bag', 0.0001, CAMERA.fx, CAMERA.cy))
        self.assertEqual(said['color']['fy'], CAMERA.fy)
        self.assertEqual(said['color_from_depth'][3], 0.015)
        self.assertEqual(said['captured_at'], '2023-11-14T22:13:20.001Z')
        camera = said['camera']
        self.assertEqual((camera['model'], camera['serial'], camera['firmware'], camera['usb']),
                         ('Intel RealSense D435', '0123', '5.12', '3.2'))
        self.assertAlmostEqual(camera['baseline_m'], 0.05, places=12)
        self.assertEqual(camera['settings']['Stereo Module']['Laser Power'], 150)
        self.assertNotIn('notes', said)
        self.assertEqual(said, {**self.info(self.record(1)), 'format': 'bag', 'depth_frames': FRAMES,
                                'fill_rate': said['fill_rate'], 'nearest_m': said['nearest_m'],
                                'farthest_m': said['farthest_m']})

    def test_colour_goes_with_the_depth_frame_nearest_in_time(self):
        self.write(pictures=[(1, RED), (4, BLUE)])
        self.assertEqual(self.info(self.bag)['color_frames'], 2)
        self.record(FRAMES)
        self.assertEqual([path.name for path in frame_files(self.out, 'color')], ['000001.png', '000004.png'])
        np.testing.assert_array_equal(read_image(self.out / 'color' / '000001.png'), RED)
        np.testing.assert_array_equal(read_image(self.out / 'color' / '000004.png'), BLUE)
        again = self.folder / 'again'
        self.succeed('record', '--camera', f'replay:{self.out}', '--frames', FRAMES, '--out', again)
        self.assertEqual(frame_contents(again), frame_contents(self.out), 'and stays with it')

    def test_infrared_is_kept(self):
        self.write(infrared=True)
        self.record(FRAMES)
        mean = np.mean(np.stack(self.frames[:FRAMES]) // 256, axis=0)
        np.testing.assert_allclose(read_image(self.out / 'infrared' / '000000.png') / 256, mean, atol=0.5 / 256)

    def test_metadata_and_lost_frames_are_kept(self):
        self.write(counters=[7, 8, 11, 12, 14])
        self.assertEqual(self.info(self.bag)['lost_frames'], 3)
        lines = [json.loads(line) for line in (self.record(FRAMES) / 'frames.jsonl').read_text().splitlines()]
        self.assertEqual([line['counter'] for line in lines], [7, 8, 11, 12, 14])
        self.assertEqual(lines[0]['exposure_us'], 8500)
        self.assertAlmostEqual(lines[3]['time_s'] - lines[0]['time_s'], 0.1, places=5)
        self.assertEqual(self.info(self.out)['lost_frames'], 3)
        self.assertIn('3 frame(s)', self.succeed('info', self.out).stdout)

    def test_findings_are_those_of_a_capture_folder(self):
        final = noisy(with_box(CAMERA.plane(1000, per_column=2), (20, 10, 11, 7), 60), FRAMES, 1.0, seed=2)
        other = self.folder / 'final.bag'
        self.write(pictures=[(0, RED)])
        write_bag(other, final, pictures=[(0, RED)], unit_in_frames=True)
        folders = [write_capture(self.folder / name, frames, pictures=[RED])
                   for name, frames in (('initial', self.frames), ('final', final))]
        by_bag = self.detect(self.bag, other, '--method', 'gaussian')
        by_folder = self.detect(*folders, '--method', 'gaussian', out=self.folder / 'folders')
        self.assertEqual(by_bag['detections'], by_folder['detections'])
        self.assertTrue((self.out / 'overlay.png').exists())

    def test_noise(self):
        self.write()
        self.succeed('noise', self.bag, '--out', self.out)
        self.assertEqual(json.loads((self.out / 'noise.json').read_text())['frames'], FRAMES)


class Stopped(BagTest):
    """What a recorder left that was killed, or a copy that was cut off."""

    def test_an_unfinished_bag_says_so(self):
        self.write(finish=False)
        self.assertIn('stopped', self.info(self.bag)['notes'][0])
        self.assertIn('note ', self.succeed('info', self.bag).stdout)

    def test_every_cut_gives_whole_frames_or_a_sentence(self):
        whole = self.write().read_bytes()
        read = set()
        for size in range(0, len(whole), max(1, len(whole) // 60)):
            self.bag.write_bytes(whole[:size])
            done = self.rva('info', self.bag, '--json')
            if done.returncode == 0:
                said = json.loads(done.stdout)
                self.assertIn('notes', said)
                read.add(said['depth_frames'])
            else:
                self.assertEqual(done.returncode, 1, done.stderr)
                self.check_line(done.stderr, [self.bag])
        self.assertTrue(read >= {2, 4}, read)

    def test_a_damaged_chunk(self):
        whole = bytearray(self.write(compression='lz4').read_bytes())
        chunk = whole.find(lz4(b'')[:4], len(whole) // 2)
        whole[chunk + 20:chunk + 60] = bytes(40)
        self.bag.write_bytes(whole)
        self.check_fails('info', self.bag, names=[self.bag, 'damaged'])
        self.bag.write_bytes(whole[:-100])  # without the end of its index, what is whole is looked for
        self.assertIn('damaged', ' '.join(self.info(self.bag)['notes']))

    def test_an_index_that_leads_elsewhere(self):
        whole = self.write().read_bytes()
        index_at = whole.rfind(b'chunk_pos=')
        for wrong in (0, 13, len(whole) - 4, 2**40, 2**63):
            self.bag.write_bytes(whole[:index_at + 10] + struct.pack('<Q', wrong) + whole[index_at + 18:])
            said = self.info(self.bag)
            self.assertEqual((said['depth_frames'], len(said['notes'])), (FRAMES, 1), 'the chunks themselves are read')


class Refused(BagTest):
    def check(self, *names):
        self.check_fails('info', self.bag, names=[self.bag, *names])

    def one_topic(self, topic, kind, message):
        bag = Bag(self.bag)
        bag.add(topic, kind, 0, message)
        bag.finish()

    def test_what_is_no_bag(self):
        for content in (b'', b'#ROSBAG V1.2\n' + bytes(5000), b'SQLite format 3\0' + bytes(5000), bytes(100),
                        b'#ROSBAG V2.0\n', b'#ROSBAG V2.0\n' + b'\xff' * 5000):
            self.bag.write_bytes(content)
            self.check()

    def test_other_recorders(self):
        self.one_topic('/camera/depth/image_rect_raw', 'sensor_msgs/Image', image_message(self.frames[0], '16UC1', 0, 0))
        self.check('/camera/depth/camera_info', 'intrinsics')
        self.one_topic('/camera/color/image_raw/compressed', 'sensor_msgs/CompressedImage', bytes(100))
        self.check('sensor_msgs/CompressedImage')
        Bag(self.bag).finish()
        self.check('no other image')

    def test_colour_only(self):
        bag = Bag(self.bag)
        bag.add(f'{COLOR}/info/camera_info', 'sensor_msgs/CameraInfo', 0, camera_info(CAMERA))
        bag.add(f'{COLOR}/image/data', 'sensor_msgs/Image', 0, image_message(RED, 'rgb8', 0, 0))
        bag.finish()
        self.check(COLOR, 'depth')

    def test_depth_that_cannot_be(self):
        sound = image_message(self.frames[0], 'mono16', 0, 0)
        wide = bytearray(sound)
        wide[21:25] = u32(2**31)
        for message, info, name in ((sound, None, 'camera_info'), (sound[:-10], camera_info(CAMERA), 'early'),
                                    (wide, camera_info(CAMERA), 'side'),
                                    (image_message(self.frames[0], '32FC1', 0, 0), camera_info(CAMERA), 'fewer bytes'),
                                    (image_message(self.frames[0], '64FC1', 0, 0), camera_info(CAMERA), '64FC1'),
                                    (image_message(self.frames[0][:-1], 'mono16', 0, 0), camera_info(CAMERA), '64x47'),
                                    (sound, camera_info(CAMERA, 'Kannala Brandt4', (0.1,) * 5), 'kannala_brandt4'),
                                    (sound, camera_info(CAMERA)[:100], 'early')):
            with self.subTest(name):
                bag = Bag(self.bag)
                if info:
                    bag.add(f'{DEPTH}/info/camera_info', 'sensor_msgs/CameraInfo', 0, info)
                bag.add(f'{DEPTH}/image/data', 'sensor_msgs/Image', 0, bytes(message))
                bag.finish()
                self.check(name)

    def test_depth_in_floating_point(self):
        metres = (self.frames[0] / 1000).astype(np.float32)
        metres[5:9, 10:20], metres[20:24, 10:20], metres[30:34, 10:20] = np.nan, -1.0, np.inf
        bag = Bag(self.bag)
        bag.add(f'{DEPTH}/info/camera_info', 'sensor_msgs/CameraInfo', 0, camera_info(CAMERA))
        bag.add(f'{DEPTH}/image/data', 'sensor_msgs/Image', 0, image_message(metres, '32FC1', 0, 0))
        bag.finish()
        said = self.info(self.bag)
        holes = np.mean(~np.isfinite(metres) | (metres <= 0))
        self.assertAlmostEqual(said['fill_rate'], 1 - holes)
        self.assertAlmostEqual(said['farthest_m'], self.frames[0].max() / 1000, places=6)

    def test_other_packing(self):
        whole = self.write(compression='none').read_bytes()
        self.bag.write_bytes(whole.replace(b'compression=none', b'compression=bz2.'))
        self.check('bz2', 'rosbag decompress')

    def test_a_unit_that_changes(self):
        bag = Bag(self.bag)
        bag.add(f'{DEPTH}/info/camera_info', 'sensor_msgs/CameraInfo', 0, camera_info(CAMERA))
        for i, unit_m in enumerate((0.001, 0.0001)):
            bag.add(f'{DEPTH}/image/data', 'sensor_msgs/Image', i, image_message(self.frames[0], 'mono16', i, i, unit_m))
        bag.finish()
        self.check('unit')

    def test_not_a_file(self):
        self.check_fails('info', '/dev/null', names=['/dev/null'])
        self.check_fails('info', self.folder / 'none.bag', names=['none.bag'])
        pipe = self.folder / 'pipe.bag'
        os.mkfifo(pipe)
        self.check_fails('info', pipe, names=[pipe])


class Real(BagTest):
    def test_a_d435(self):
        bag = SHARED / 'data' / 'd435.bag'
        if not bag.exists():
            self.skipTest(f'{bag} is not there')
        said = self.info(bag)
        self.assertEqual((said['depth_frames'], said['color_frames'], said['depth']['unit_m']), (2, 1, 0.001))
        for key, value in (('fx', 390.431), ('fy', 390.431), ('cx', 331.388), ('cy', 242.187)):
            self.assertAlmostEqual(said['depth'][key], value, places=3)
        self.assertEqual((said['camera']['model'], said['camera']['serial']), ('Intel RealSense D435', '728612070259'))
        self.assertAlmostEqual(said['color_from_depth'][3], 0.0143, places=4)


def frame_contents(folder):
    return {name: content for name, content in contents(folder).items() if str(name).endswith('.png')}


if __name__ == '__main__':
    SHARED = pathlib.Path(sys.argv.pop(2)) if len(sys.argv) > 2 else pathlib.Path('none')
    program.main()
