"""Inputs as people have them: other units, names, layouts and colour images. What is sound in them is compared.

usage: opened_inputs_test.py RVA
"""
import io
import json
import shutil
import struct

import cv2
import numpy as np

import program
from captures import (CAMERA, IDENTITY, TUM_INTRINSICS, noisy, plain_color, with_box, write_capture, write_open3d, write_tum)
from db3s import write_db3
from ros_recordings import (ALIGNED, COLOR, DEPTH, KINDS_OF_FILES, Ros2, compressed_color, compressed_depth, in_metres,
                            quantised_depth, write_mcap, write_messages, write_ros1, write_ros2)
from simulations import depth_frames

BOX = (20, 10, 11, 7)
FRAMES = 5
HEIGHT_MM = 60
FLOOR_MM = 1000
TUM_UNITS_PER_MM = 5
WITH_COLOR = {'color': CAMERA.fields(), 'color_from_depth': IDENTITY}


def npy(array):
    file = io.BytesIO()
    np.save(file, array)
    return file.getvalue()


WRITERS = ((write_ros1, 'bag'), (write_ros2, 'db3'), (write_mcap, 'mcap'))


class OpenedInputsTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        floor = CAMERA.plane(FLOOR_MM)
        self.frames = {'before': noisy(floor, FRAMES, 1.0, seed=1),
                       'after': noisy(with_box(floor, BOX, HEIGHT_MM), FRAMES, 1.0, seed=2)}
        self.picture = plain_color(CAMERA.width, CAMERA.height, (60, 90, 120))

    def write(self, how):
        for side, frames in self.frames.items():
            how(self.folder / side, frames)

    def compare(self, *options):
        done = self.succeed('detect', self.folder / 'before', self.folder / 'after', *options, '--out', self.out, '--overwrite')
        return json.loads((self.out / 'detections.json').read_text()), done.stderr

    def check_box(self, *options):
        result, said = self.compare(*options)
        findings = result['detections']
        self.assertEqual(len(findings), 1, said)
        self.assertEqual(findings[0]['kind'], 'added')
        self.assertAlmostEqual(findings[0]['height_mm'], HEIGHT_MM, delta=3)
        self.assertAlmostEqual(findings[0]['position_m'][2], (FLOOR_MM - HEIGHT_MM) / 1000, delta=0.01)
        return said

    def info(self, path, *options):
        return json.loads(self.succeed('info', path, *options, '--json').stdout)

    def describe(self, side, **changes):
        file = self.folder / side / 'capture.json'
        description = json.loads(file.read_text())
        for key, value in changes.items():
            description[key] = {**description.get(key, {}), **value} if isinstance(value, dict) else value
        file.write_text(json.dumps({key: value for key, value in description.items() if value is not None}))

    # Recordings of ROS

    def write_ros(self, side, ros, ending, messages_of):
        frames = self.frames[side]
        messages = [message for i, frame in enumerate(frames) for message in messages_of(ros, i, frame)]
        return write_messages(self.folder / f'{side}.{ending}', ros, messages)

    def detect_files(self, ending, *options):
        done = self.succeed('detect', self.folder / f'before.{ending}', self.folder / f'after.{ending}', *options,
                            '--out', self.out, '--overwrite')
        findings = json.loads((self.out / 'detections.json').read_text())['detections']
        self.assertEqual(len(findings), 1, done.stderr)
        self.assertAlmostEqual(findings[0]['height_mm'], HEIGHT_MM, delta=3)
        return done.stderr

    def test_compressed_depth_and_colour_are_read(self):
        for compress in (compressed_depth, lambda frame: quantised_depth(frame / 1000)):
            def messages(ros, i, frame):
                yield '/camera/depth/camera_info', 'sensor_msgs/CameraInfo', i / 30, ros.info()
                yield '/camera/depth/image/compressedDepth', 'sensor_msgs/CompressedImage', i / 30, ros.compressed(compress(frame), 'depth', i)
                yield '/camera/color/camera_info', 'sensor_msgs/CameraInfo', i / 30, ros.info()
                yield '/camera/color/image/compressed', 'sensor_msgs/CompressedImage', i / 30, ros.compressed(compressed_color(self.picture), 'color', i)

            for ros, ending in KINDS_OF_FILES:
                with self.subTest(ros=ros.__name__, ending=ending):
                    for side in self.frames:
                        self.write_ros(side, ros, ending, messages)
                    self.detect_files(ending)
                    info = self.info(self.folder / f'after.{ending}')
                    self.assertEqual((info['depth_frames'], info['color_frames']), (FRAMES, FRAMES))

    def test_compressed_depth_is_that_of_the_file(self):
        def messages(ros, i, frame):
            yield '/camera/depth/camera_info', 'sensor_msgs/CameraInfo', i / 30, ros.info()
            yield '/camera/depth/image/compressedDepth', 'sensor_msgs/CompressedImage', i / 30, ros.compressed(compressed_depth(frame), 'depth', i)

        file = self.write_ros('after', Ros2, 'mcap', messages)
        self.succeed('export', file, '--to', 'mcap', '--out', self.folder / 'again.mcap')
        self.succeed('record', '--camera', f'replay:{self.folder / "again.mcap"}', '--frames', FRAMES, '--out', self.folder / 'folder')
        np.testing.assert_array_equal(depth_frames(self.folder / 'folder'), self.frames['after'])

    def test_depth_compressed_in_another_way_is_named(self):
        def messages(ros, i, frame):
            yield '/camera/depth/camera_info', 'sensor_msgs/CameraInfo', i / 30, ros.info()
            yield '/camera/depth/image/compressedDepth', 'sensor_msgs/CompressedImage', i / 30, ros.compressed(('16UC1; compressedDepth rvl', bytes(99)), 'depth', i)

        self.check_fails('info', self.write_ros('after', Ros2, 'mcap', messages), names=['rvl', 'not supported'])

    def test_colour_that_cannot_be_decompressed_does_not_stop_depth(self):
        def messages(ros, i, frame):
            yield '/camera/depth/camera_info', 'sensor_msgs/CameraInfo', i / 30, ros.info()
            yield '/camera/depth/image', 'sensor_msgs/Image', i / 30, ros.image(frame, '16UC1', 'depth', i)
            yield '/camera/color/camera_info', 'sensor_msgs/CameraInfo', i / 30, ros.info()
            yield '/camera/color/image/compressed', 'sensor_msgs/CompressedImage', i / 30, ros.compressed(('h264', bytes(99)), 'color', i)

        for side in self.frames:
            self.write_ros(side, Ros2, 'mcap', messages)
        self.detect_files('mcap')

    def test_static_transforms_relate_colour_to_depth(self):
        def messages(ros, i, frame):
            if i == 0:
                edges = [('base', 'depth', (0.3, 0, 0.1, 0, 0, 0, 1)), ('base', 'color', (0.315, 0, 0.1, 0, 0, 0, 1))]
                yield '/tf_static', 'tf2_msgs/TFMessage', 0.0, ros.transforms(edges)
            yield '/camera/depth/camera_info', 'sensor_msgs/CameraInfo', i / 30, ros.info()
            yield '/camera/depth/image', 'sensor_msgs/Image', i / 30, ros.image(frame, '16UC1', 'depth', i)
            yield '/camera/color/camera_info', 'sensor_msgs/CameraInfo', i / 30, ros.info()
            yield '/camera/color/image', 'sensor_msgs/Image', i / 30, ros.image(self.picture, 'rgb8', 'color', i)

        for ros, ending in KINDS_OF_FILES:
            with self.subTest(ros=ros.__name__, ending=ending):
                file = self.write_ros('after', ros, ending, messages)
                color_from_depth = self.info(file)['color_from_depth']
                np.testing.assert_allclose(np.reshape(color_from_depth, (4, 4))[:3, 3], (-0.015, 0, 0), atol=1e-9)

    def test_static_transforms_that_are_no_rotation_are_noted(self):
        def messages(ros, i, frame):
            if i == 0:
                yield '/tf_static', 'tf2_msgs/TFMessage', 0.0, ros.transforms([('depth', 'color', (0, 0, 0, 0, 0, 0, 0))])
            yield '/camera/depth/camera_info', 'sensor_msgs/CameraInfo', i / 30, ros.info()
            yield '/camera/depth/image', 'sensor_msgs/Image', i / 30, ros.image(frame, '16UC1', 'depth', i)
            yield '/camera/color/camera_info', 'sensor_msgs/CameraInfo', i / 30, ros.info()
            yield '/camera/color/image', 'sensor_msgs/Image', i / 30, ros.image(self.picture, 'rgb8', 'color', i)

        self.assertIn('cannot be read', ' '.join(self.info(self.write_ros('after', Ros2, 'mcap', messages))['notes']))

    # Units

    def test_a_unit_that_is_given_overrides_every_format(self):
        self.write(lambda at, mm: write_capture(at, mm * 4))
        self.assertIn('0.25 mm were given instead', self.check_box('--depth-unit', '0.25'))
        for side in self.frames:
            shutil.rmtree(self.folder / side)
        self.write(lambda at, mm: write_open3d(at, mm * 4, pictures=[self.picture]))
        self.check_box('--depth-unit', '0.25')
        for side in self.frames:
            shutil.rmtree(self.folder / side)
        self.write(write_tum)
        said = self.check_box('--depth-unit', '1', *TUM_INTRINSICS)
        self.assertNotIn('assumed', said)
        self.assertAlmostEqual(self.info(self.folder / 'before', '--depth-unit', '1', *TUM_INTRINSICS)['depth']['unit_m'], 0.001)

    def test_a_unit_that_is_assumed_is_named(self):
        self.write(lambda at, mm: write_tum(at, mm * TUM_UNITS_PER_MM))
        self.assertIn('steps of 0.2 mm are assumed', self.check_box(*TUM_INTRINSICS))
        self.assertIn('steps of 0.2 mm are assumed', ' '.join(self.info(self.folder / 'before', *TUM_INTRINSICS)['notes']))

    def test_units_that_differ_are_compared_in_metres_and_named(self):
        self.frames['before'] = self.frames['before'] * 10
        self.write(lambda at, mm: write_capture(at, mm))
        self.describe('before', depth={'unit_m': 0.0001})
        self.assertIn('in steps of 0.1 mm and of 1 mm', self.check_box())
        for method in ('constant', 'gaussian'):
            result, _ = self.compare('--method', method)
            self.assertGreaterEqual(len(result['detections']), 1, method)

    def test_units_that_print_differently_are_the_same(self):
        self.write(write_capture)
        self.describe('before', depth={'unit_m': 0.0010000000474974513})
        self.assertNotIn('steps of', self.check_box())

    def test_a_unit_out_of_range_is_refused(self):
        self.write(write_capture)
        for unit in ('0', '-1', 'nan', '1e9'):
            refused = self.rva('info', self.folder / 'before', '--depth-unit', unit)
            self.assertEqual(refused.returncode, 2, refused.stderr)

    # Layouts

    def test_numbered_files_are_read_in_the_order_of_their_numbers(self):
        frames = np.stack([np.full((CAMERA.height, CAMERA.width), 1000 + 2 * i, np.uint16) for i in range(12)])
        write_capture(self.folder / 'before', frames)
        depth = self.folder / 'before' / 'depth'
        for i, file in enumerate(sorted(depth.iterdir())):
            file.rename(depth / f'{i}.png')
        self.succeed('noise', self.folder / 'before', '--out', self.out)
        noise = json.loads((self.out / 'noise.json').read_text())
        self.assertGreater(noise['welch']['rejected'], 0.9)

    def test_bare_depth_images_are_read_with_intrinsics_that_are_given(self):
        self.write(write_capture)
        for side in self.frames:
            (self.folder / side / 'capture.json').unlink()
        self.check_fails('info', self.folder / 'before', names=['contains 5 images', 'intrinsics'])
        self.assertIn('steps of 1 mm are assumed', self.check_box(*TUM_INTRINSICS))
        for side in self.frames:
            for file in (self.folder / side / 'depth').iterdir():
                file.rename(self.folder / side / file.name)
            (self.folder / side / 'depth').rmdir()
        self.check_box(*TUM_INTRINSICS)

    def test_association_lists_pair_depth_and_colour_in_either_order(self):
        for depth_first in (True, False):
            for side, frames in self.frames.items():
                folder = write_tum(self.folder / side, frames * TUM_UNITS_PER_MM, pictures=[(10 + i / 30, self.picture) for i in range(FRAMES)])
                names = [f'{10 + i / 30:.6f}' for i in range(FRAMES)]
                files = [(f'{name} depth/{name}.png', f'{name} rgb/{name}.png') for name in names]
                (folder / 'depth.txt').unlink()
                (folder / 'rgb.txt').unlink()
                (folder / 'associations.txt').write_text('# made by associate.py\n' + '\n'.join(
                    ' '.join(pair if depth_first else reversed(pair)) for pair in files))
            self.check_box(*TUM_INTRINSICS)
            self.assertEqual(self.info(self.folder / 'after', *TUM_INTRINSICS)['color_frames'], FRAMES)
        (self.folder / 'after' / 'associations.txt').write_text('10.0 depth/a.png 10.0\n')
        self.check_fails('info', self.folder / 'after', *TUM_INTRINSICS, names=['associations.txt:1', 'seconds file seconds file'])

    def test_names_with_spaces_and_a_byte_order_mark_in_a_list(self):
        self.write(lambda at, mm: write_tum(at, mm * TUM_UNITS_PER_MM))
        for side in self.frames:
            depth = self.folder / side / 'depth'
            for file in depth.iterdir():
                file.rename(depth / f'frame {file.name}')
            listed = self.folder / side / 'depth.txt'
            lines = listed.read_text().replace('depth/', 'depth/frame ').splitlines()
            listed.write_bytes(b'\xef\xbb\xbf' + '\r\n'.join(line for line in lines if not line.startswith('#')).encode())
        self.check_box(*TUM_INTRINSICS)

    def test_an_intrinsic_file_of_another_name_or_by_rows(self):
        self.write(lambda at, mm: write_open3d(at, mm, pictures=[self.picture]))
        expected = self.info(self.folder / 'before')['depth']
        for side in self.frames:
            file = self.folder / side / 'intrinsic.json'
            description = json.loads(file.read_text())
            matrix = description['intrinsic_matrix']
            description['intrinsic_matrix'] = [matrix[0], 0, matrix[6], 0, matrix[4], matrix[7], 0, 0, 1]
            file.write_text(json.dumps(description))
            file.rename(file.with_name('camera_intrinsics.json'))
        said = self.info(self.folder / 'before')
        self.assertEqual(said['depth'], expected)
        self.assertIn('row by row', ' '.join(said['notes']))
        self.check_box()

    def test_a_folder_around_one_recording_is_that_recording(self):
        for side, frames in self.frames.items():
            (self.folder / side).mkdir()
            write_db3(self.folder / side / f'{side}_0.db3', frames)
            (self.folder / side / 'metadata.yaml').write_text('rosbag2_bagfile_information: {}\n')
        self.check_box()
        shutil.copy(self.folder / 'before' / 'before_0.db3', self.folder / 'before' / 'before_1.db3')
        self.check_fails('info', self.folder / 'before', names=['contains 2 recordings', 'before_0.db3'])

    # Recordings of ROS

    def test_depth_of_a_ros_node_is_read_in_millimetres_and_in_metres(self):
        for write, ending in WRITERS:
            for encoding, convert in (('16UC1', lambda frames: frames), ('32FC1', in_metres)):
                with self.subTest(ending, encoding=encoding):
                    for side, frames in self.frames.items():
                        (self.folder / side).mkdir(exist_ok=True)
                        path = self.folder / side / f'node.{ending}'
                        write(path, [(DEPTH, encoding, convert(frames)), (COLOR, 'rgb8', [self.picture] * FRAMES)])
                    self.check_box()
                    said = self.info(self.folder / 'before')
                    self.assertEqual(said['depth']['fx'], CAMERA.fx)
                    self.assertEqual(said['color_frames'], FRAMES)
                    self.assertNotIn('color_from_depth', said)
                    for side in self.frames:
                        shutil.rmtree(self.folder / side)

    def test_the_camera_s_own_depth_is_chosen_or_the_topic_that_is_given(self):
        aligned = self.frames['before'] + 100
        streams = [(ALIGNED, '16UC1', aligned), (DEPTH, '16UC1', self.frames['before']), (COLOR, 'rgb8', [self.picture] * FRAMES)]
        for write, ending in WRITERS:
            recording = write(self.folder / f'both.{ending}', streams)
            self.assertLess(self.info(recording)['farthest_m'], 1.05)
            said = self.info(recording, '--topic', ALIGNED)
            self.assertGreater(said['nearest_m'], 1.05)
            self.assertEqual(said['color_from_depth'], IDENTITY)
            for topic in (COLOR, '/nothing'):
                self.check_fails('info', recording, '--topic', topic, names=[topic, 'no depth image'])

    def test_without_camera_info_intrinsics_are_asked_for(self):
        for write, ending in WRITERS:
            recording = write(self.folder / f'bare.{ending}', [(DEPTH, '16UC1', self.frames['before'])], infos=False)
            self.check_fails('info', recording, names=['/camera/depth/camera_info', 'intrinsics'])
            self.assertEqual(self.info(recording, *TUM_INTRINSICS)['depth']['width'], CAMERA.width)

    def test_a_recording_of_ros_without_depth_is_refused_with_what_it_has(self):
        for write, ending in WRITERS:
            recording = write(self.folder / f'color.{ending}', [(COLOR, 'rgb8', [self.picture])])
            self.check_fails('info', recording, names=['no depth', COLOR])

    # MCAP

    def test_mcap_files_of_every_kind_give_the_same_frames(self):
        streams = [(DEPTH, '16UC1', self.frames['before']), (COLOR, 'rgb8', [self.picture] * FRAMES)]
        for options in ({}, {'compression': 'lz4'}, {'compression': 'zstd'}, {'index': False}, {'messages_per_chunk': 0, 'index': False},
                        {'messages_per_chunk': 100, 'compression': 'zstd'}, {'encoding': 'ros1', 'compression': 'lz4'}):
            with self.subTest(options):
                recording = write_mcap(self.folder / 'node.mcap', streams, **options)
                self.succeed('record', '--camera', f'replay:{recording}', '--frames', FRAMES, '--out', self.out, '--overwrite')
                np.testing.assert_array_equal(depth_frames(self.out), self.frames['before'])
                self.assertEqual(self.info(recording)['color_frames'], FRAMES)
                self.assertNotIn('notes', self.info(recording))

    def test_an_mcap_file_cut_at_any_byte_gives_its_whole_chunks(self):
        whole = write_mcap(self.folder / 'whole.mcap', [(DEPTH, '16UC1', self.frames['before'])], messages_per_chunk=2).read_bytes()
        cut = self.folder / 'cut.mcap'
        seen = []
        for length in [*range(0, len(whole), len(whole) // 60), len(whole) - 1, len(whole)]:
            cut.write_bytes(whole[:length])
            done = self.rva('info', cut, '--json')
            self.assertIn(done.returncode, (0, 1), done.stderr)
            seen.append(json.loads(done.stdout)['depth_frames'] if done.returncode == 0 else 0)
            if done.returncode == 1:
                self.check_line(done.stderr, [cut])
            elif seen[-1] < FRAMES:
                self.assertIn('cut short', json.loads(done.stdout)['notes'][0])
        self.assertEqual(seen, sorted(seen))
        self.assertEqual(seen[-1], FRAMES)
        self.assertGreater(len(set(seen)), 3)

    def test_a_damaged_chunk_of_an_mcap_file_is_noticed(self):
        path = write_mcap(self.folder / 'node.mcap', [(DEPTH, '16UC1', self.frames['before'])], messages_per_chunk=2, index=False)
        data = bytearray(path.read_bytes())
        data[len(data) // 2] ^= 0x40
        path.write_bytes(data)
        said = self.info(path)
        self.assertLess(said['depth_frames'], FRAMES)
        self.assertIn('1 damaged part(s)', said['notes'][0])

    # Colour

    def test_colour_that_cannot_be_read_leaves_depth(self):
        def cut(file):
            cv2.imwrite(str(file.with_suffix('.jpg')), self.picture)
            data = file.with_suffix('.jpg').read_bytes()
            file.unlink()
            file.with_suffix('.jpg').write_bytes(data[:-40])

        for spoil in (cut, lambda file: file.write_bytes(b''), lambda file: cv2.imwrite(str(file), self.picture[::2, ::2])):
            self.write(lambda at, mm: write_capture(at, mm, pictures=[self.picture], **WITH_COLOR))
            for side in self.frames:
                spoil(next((self.folder / side / 'color').iterdir()))
            said = self.check_box()
            self.assertIn('there is no overlay.png', said)
            self.assertFalse((self.out / 'overlay.png').exists())
            for side in self.frames:
                shutil.rmtree(self.folder / side)

    def test_colour_of_16_bits_is_read(self):
        self.write(lambda at, mm: write_capture(at, mm, pictures=[self.picture]))
        for side in self.frames:
            for file in (self.folder / side / 'color').iterdir():
                cv2.imwrite(str(file), self.picture.astype(np.uint16) * 257)
        self.check_box()
        self.assertTrue((self.out / 'overlay.png').exists())

    def test_colour_whose_pose_is_unknown_is_drawn_on_with_a_warning(self):
        self.write(lambda at, mm: write_capture(at, mm, pictures=[self.picture], color=CAMERA.fields()))
        self.assertIn('does not state the pose of its colour imager', self.check_box())
        self.check_fails('export', self.folder / 'before', '--to', 'open3d', '--out', self.out / 'x', names=['color_from_depth'])

    def test_colour_and_depth_are_paired_by_their_numbers(self):
        pictures = [plain_color(CAMERA.width, CAMERA.height, (grey,) * 3) for grey in (40, 80, 120)]
        write_capture(self.folder / 'before', self.frames['before'][:4], pictures=pictures, **WITH_COLOR)
        for kind, first in (('depth', 0), ('color', 1)):
            for i, file in enumerate(sorted((self.folder / 'before' / kind).iterdir())):
                file.rename(file.with_name(f'{kind}_{i + first:03}.png'))
        self.succeed('export', self.folder / 'before', '--to', 'open3d', '--out', self.out)
        greys = [cv2.imread(str(file)).mean() for file in sorted((self.out / 'color').iterdir())]
        np.testing.assert_allclose(greys[1:], (40, 80, 120), atol=2)

    # What is no capture

    def test_a_file_that_is_no_recording_is_named_for_what_it_is(self):
        png = cv2.imencode('.png', self.picture)[1].tobytes()
        kinds = {b'': 'empty', b'version https://git-lfs.github.com/spec/v1\noid sha256:0\n': 'Git LFS',
                 b'ply\nformat ascii 1.0\n': 'point cloud', b'# .PCD v0.7\n': 'point cloud', b'PK\x03\x04' + bytes(60): 'archive',
                 b'\x1f\x8b\x08' + bytes(60): 'gzip', bytes(257) + b'ustar\0' + bytes(60): 'tar',
                 struct.pack('>I', 24) + b'ftypmp42' + bytes(60): 'video', png: 'single image', b'\x93NUMPY\x01\x00': 'NumPy'}
        for i, (data, kind) in enumerate(kinds.items()):
            file = self.folder / f'file{i}'
            file.write_bytes(data)
            self.check_fails('info', file, names=[file.name, kind])

    def test_depth_in_files_that_are_not_read_names_them(self):
        write_capture(self.folder / 'before', self.frames['before'][:1])
        depth = self.folder / 'before' / 'depth'
        for file in depth.iterdir():
            file.rename(depth / 'frame.raw')
        self.check_fails('info', self.folder / 'before', names=['frame.raw', 'PNG'])

    def test_depth_in_tiff_pgm_and_numpy_s_files(self):
        writers = {'tiff': lambda at, frame: cv2.imwrite(at, frame), 'tif': lambda at, frame: cv2.imwrite(at, frame / np.float32(1000)),
                   'pgm': lambda at, frame: cv2.imwrite(at, frame), 'npy': np.save}
        for ending, write in writers.items():
            for convert in (lambda frame: frame, lambda frame: in_metres(frame).astype(float)) if ending == 'npy' else (lambda frame: frame,):
                with self.subTest(ending):
                    self.write(write_capture)
                    for side, frames in self.frames.items():
                        for i, file in enumerate(sorted((self.folder / side / 'depth').iterdir())):
                            write(str(file.with_suffix(f'.{ending}')), convert(frames[i]))
                            file.unlink()
                    self.check_box()
                    for side in self.frames:
                        shutil.rmtree(self.folder / side)

    def test_images_that_are_there_in_several_kinds_of_files_count_once(self):
        self.write(write_capture)
        for side, frames in self.frames.items():
            for i, file in enumerate(sorted((self.folder / side / 'depth').iterdir())):
                np.save(file.with_suffix('.npy'), frames[i])
        self.assertEqual(self.info(self.folder / 'before')['depth_frames'], FRAMES)
        self.check_box()

    def test_depth_files_that_contain_something_else_are_named(self):
        wrong = {'tiff': [(cv2.imencode('.tiff', self.picture)[1].tobytes(), 'channel'), (b'II*\0', 'TIFF'), (b'', 'TIFF')],
                 'pgm': [(cv2.imencode('.pgm', self.picture[..., 0])[1].tobytes(), '16 bits'), (b'P5\n64 48\n65535\n' + bytes(10), 'ends early'),
                         (b'P5', 'number'), (b'P5\n99999 99999\n65535\n', '99999x99999'), (b'P2\n1 1\n65535\n7', 'P5')],
                 'npy': [(npy(np.zeros((2, 3, 4), np.uint16)), '3 dimensions'), (npy(np.zeros((48, 64), np.int64)), 'i8'),
                         (npy(np.asfortranarray(np.zeros((48, 64), np.uint16))), 'columns'), (npy(np.zeros((48, 64), np.uint16))[:200], 'ends early'),
                         (b'\x93NUMPY', 'ends early'), (b'', 'NumPy')]}
        for ending, files in wrong.items():
            for content, problem in files:
                with self.subTest(ending, problem=problem):
                    write_capture(self.folder / 'before', self.frames['before'][:1])
                    for file in (self.folder / 'before' / 'depth').iterdir():
                        file.with_suffix(f'.{ending}').write_bytes(content)
                        file.unlink()
                    self.check_fails('info', self.folder / 'before', names=[f'000000.{ending}', problem])
                    shutil.rmtree(self.folder / 'before')

    def test_intrinsics_that_cannot_be_right_are_refused(self):
        write_capture(self.folder / 'before', self.frames['before'][:1])
        for wrong in ({'cx': -500.0}, {'cy': 1e4}, {'fx': CAMERA.fx * 5}, {'cx': 0.0, 'cy': 0.0}):
            write_capture(self.folder / 'wrong', self.frames['before'][:1])
            self.describe('wrong', depth=wrong)
            self.check_fails('info', self.folder / 'wrong', names=[*wrong])
            shutil.rmtree(self.folder / 'wrong')


if __name__ == '__main__':
    program.main()
