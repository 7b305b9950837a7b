"""One scene in every folder format: the same findings, and `rva info` states what was put in.

usage: formats_test.py RVA
"""
import json

import numpy as np

import program
from captures import (CAMERA, IDENTITY, TUM_INTRINSICS, Camera, depth_fields, noisy, plain_color, read_image,
                      with_box, write_capture, write_image, write_open3d, write_tum)

BOX = (20, 10, 11, 7)
FRAMES = 6
TUM_UNITS_PER_MM = 5
RED, BLUE = (200, 30, 40), (40, 30, 200)
POSE = {'base': 'b1', 'pan_deg': 12.5, 'tilt_deg': -18.0,
        'world_from_camera': [*IDENTITY[:3], 0.5, *IDENTITY[4:]]}


class FormatsTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        floor = CAMERA.plane(1000, per_column=2)
        floor[:, -4:] = 0
        self.initial = noisy(floor, FRAMES, 1.0, seed=1)
        self.final = noisy(with_box(floor, BOX, 60), FRAMES, 1.0, seed=2)
        self.picture = plain_color(CAMERA.width, CAMERA.height, RED)

    def each_format(self):
        """By name: the format, what writes it from frames of millimetres, and the options that it needs."""
        def capture(ending):
            return lambda at, mm: write_capture(at, mm, pictures=[self.picture], picture_ending=ending)

        def open3d(units_per_mm=1, **keys):
            return lambda at, mm: write_open3d(at, mm * units_per_mm, pictures=[self.picture], **keys)

        def tum(at, mm):
            return write_tum(at, mm * TUM_UNITS_PER_MM, pictures=[(10, self.picture)])

        return {
            'capture': ('rva-capture', capture('png'), []),
            'capture, jpeg': ('rva-capture', capture('jpg'), []),
            'open3d': ('open3d', open3d(depth_scale=1000), []),
            'open3d, unstated scale': ('open3d', open3d(), []),
            'open3d, other name': ('open3d', open3d(description='camera_intrinsic.json'), []),
            'open3d, other scale': ('open3d', open3d(4, depth_scale=4000), []),
            'tum': ('tum', tum, TUM_INTRINSICS),
        }

    def check_close(self, one, other, where):
        if isinstance(one, dict):
            self.assertEqual(set(one), set(other), where)
            for key in one:
                self.check_close(one[key], other[key], f'{where}.{key}')
        elif isinstance(one, list):
            self.assertEqual(len(one), len(other), where)
            for i, pair in enumerate(zip(one, other)):
                self.check_close(*pair, f'{where}[{i}]')
        elif isinstance(one, float):
            np.testing.assert_allclose(one, other, rtol=1e-5, atol=1e-9, err_msg=where)
        else:
            self.assertEqual(one, other, where)

    def test_every_format_gives_the_same_detections(self):
        for method in ('constant', 'gaussian'):
            results = {}
            for name, (_, write, options) in self.each_format().items():
                place = self.folder / method / name
                out = place / 'out'
                result = self.detect(write(place / 'a', self.initial), write(place / 'b', self.final),
                                     '--method', method, *options, out=out)
                self.assertEqual([tuple(f['bbox']) for f in result['detections']], [BOX])
                del result['runtime_ms'], result['provenance']
                if method == 'gaussian':
                    del result['detections'][0]['score']  # it depends on how coarse the unit is
                results[name] = result, read_image(out / 'changes.png')
            expected, changes = results['capture']
            for name, (result, its_changes) in results.items():
                with self.subTest(method=method, format=name):
                    self.check_close(result, expected, 'detections.json')
                    np.testing.assert_array_equal(its_changes, changes)

    def test_formats_mix(self):
        initial = write_capture(self.folder / 'a', self.initial)
        final = write_open3d(self.folder / 'b', self.final)
        found = self.detect(initial, final)['detections']
        self.assertEqual([tuple(f['bbox']) for f in found], [BOX])

    def test_info_states_depth_in_every_format(self):
        measured = self.final[self.final > 0]
        for name, (kind, write, options) in self.each_format().items():
            with self.subTest(name):
                info = self.info(write(self.folder / name, self.final), *options)
                self.assertEqual(info['format'], kind)
                self.assertIs(info['sound'], True)
                self.assertEqual(info['depth_frames'], FRAMES)
                for key, value in CAMERA.fields().items():
                    self.assertAlmostEqual(info['depth'][key], value, msg=key)
                units_per_mm = {'tum': TUM_UNITS_PER_MM, 'open3d, other scale': 4}.get(name, 1)
                self.assertAlmostEqual(info['depth']['unit_m'], 0.001 / units_per_mm)
                self.assertAlmostEqual(info['fill_rate'], measured.size / self.final.size)
                self.assertAlmostEqual(info['nearest_m'], measured.min() / 1000)
                self.assertAlmostEqual(info['farthest_m'], measured.max() / 1000)

    def test_info_states_all_of_a_capture(self):
        color = Camera(80, 60, 70.5, 71.5, 39.0, 30.0)
        shift = [*IDENTITY[:3], 0.015, *IDENTITY[4:]]
        depth = {**depth_fields(unit_m=0.0001), 'distortion_model': 'brown_conrady',
                 'distortion': [0.1, -0.2, 0.001, 0.002, 0.05]}
        camera = {'model': 'Intel RealSense D435', 'serial': '0123', 'baseline_m': 0.05}
        capture = write_capture(self.folder / 'a', self.initial, pictures=[plain_color(80, 60, RED)] * 2,
                                depth=depth, color=color.fields(), color_from_depth=shift, pose=POSE,
                                camera=camera, captured_at='2026-01-01T00:00:00Z')
        info = self.info(capture)
        self.assertEqual((info['depth_frames'], info['color_frames']), (FRAMES, 2))
        self.assertEqual(info['depth'], depth)
        self.assertEqual({key: info['color'][key] for key in color.fields()}, color.fields())
        self.assertEqual(info['camera'], camera)
        self.assertEqual(info['captured_at'], '2026-01-01T00:00:00Z')
        np.testing.assert_allclose(info['color_from_depth'], shift, atol=1e-12)
        moved = info['pose'].pop('world_from_camera')
        np.testing.assert_allclose(moved, POSE['world_from_camera'], atol=1e-12)
        self.assertEqual(info['pose'], {key: POSE[key] for key in ('base', 'pan_deg', 'tilt_deg')})

    def test_info_for_a_person_names_what_counts(self):
        capture = write_capture(self.folder / 'a', self.initial, pictures=[self.picture], pose=POSE)
        text = self.succeed('info', capture).stdout
        for word in ('rva-capture', f'{FRAMES} frame', '64x48', 'base b1', 'sound'):
            self.assertIn(word, text)

    def test_what_is_optional_may_be_missing(self):
        info = self.info(write_capture(self.folder / 'a', self.initial))
        self.assertEqual(info['color_frames'], 0)
        self.assertEqual(info['depth']['distortion_model'], 'none')
        for key in ('color', 'color_from_depth', 'pose', 'camera', 'captured_at'):
            self.assertNotIn(key, info)
        bare = write_capture(self.folder / 'b', self.initial, pose={}, camera={})
        self.assertEqual(self.info(bare)['depth_frames'], FRAMES)

    def test_unknown_keys_are_no_error(self):
        capture = write_capture(self.folder / 'a', self.initial, note='left of the door',
                                exposure={'us': [1, 2]}, depth={**depth_fields(), 'laser_power': 150},
                                pose={'base': 'b1', 'robot': 7})
        self.assertEqual(self.info(capture)['pose'], {'base': 'b1'})

    def test_open3d_names_its_camera(self):
        capture = write_open3d(self.folder / 'a', self.initial, device_name='Intel RealSense L515',
                               serial_number='f0', color_format='RGB8', fps=30.0, stream_length_usec=1)
        camera = self.info(capture)['camera']
        self.assertEqual((camera['model'], camera['serial']), ('Intel RealSense L515', 'f0'))

    def test_open3d_matrix_is_by_columns(self):
        capture = write_open3d(self.folder / 'a', self.initial)
        matrix = json.loads((capture / 'intrinsic.json').read_text())['intrinsic_matrix']
        depth = self.info(capture)['depth']
        stated = [[depth['fx'], 0, depth['cx']], [0, depth['fy'], depth['cy']], [0, 0, 1]]
        np.testing.assert_array_equal(np.reshape(matrix, (3, 3), order='F'), stated)

    def test_tum_takes_the_colour_nearest_to_the_first_depth(self):
        blue = plain_color(CAMERA.width, CAMERA.height, BLUE)
        pictures = [(9.5, blue), (9.98, self.picture), (10.03, blue), (10.1, blue)]
        capture = write_tum(self.folder / 'a', self.initial * TUM_UNITS_PER_MM, pictures=pictures)
        before = write_tum(self.folder / 'before', self.initial[::-1] * TUM_UNITS_PER_MM)
        self.detect(before, capture, *TUM_INTRINSICS)
        self.assertEqual(tuple(read_image(self.out / 'overlay.png')[20, 20]), RED)

    def test_tum_lists_may_come_from_windows_and_contain_empty_lines(self):
        capture = write_tum(self.folder / 'a', self.initial * TUM_UNITS_PER_MM)
        text = (capture / 'depth.txt').read_text().replace('\n', '\r\n')
        (capture / 'depth.txt').write_text(text + '\r\n\n', newline='')
        self.assertEqual(self.info(capture, *TUM_INTRINSICS)['depth_frames'], FRAMES)

    def test_first_frame_is_the_first_by_name_or_list(self):
        frames = np.stack([self.final[0], *self.initial[1:]])
        for name, (_, write, options) in self.each_format().items():
            with self.subTest(name):
                place = self.folder / name
                found = self.detect(write(place / 'a', self.initial), write(place / 'b', frames), *options,
                                    '--method', 'constant', out=place / 'out')['detections']
                self.assertEqual([tuple(f['bbox']) for f in found], [BOX])

    def test_tum_frames_follow_the_list(self):
        capture = write_tum(self.folder / 'a', self.initial * TUM_UNITS_PER_MM)
        write_image(capture / 'depth' / 'zzz.png', self.final[0] * TUM_UNITS_PER_MM)
        lines = (capture / 'depth.txt').read_text()
        (capture / 'depth.txt').write_text('9.9 depth/zzz.png\n' + lines)
        initial = write_tum(self.folder / 'b', self.initial * TUM_UNITS_PER_MM)
        found = self.detect(initial, capture, '--method', 'constant', *TUM_INTRINSICS)['detections']
        self.assertEqual([tuple(f['bbox']) for f in found], [BOX])


if __name__ == '__main__':
    program.main()
