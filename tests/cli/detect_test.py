"""`rva detect` from end to end, against what numpy makes of the same arrays.

usage: detect_test.py RVA
"""
import json
import os

import numpy as np

import program
from captures import CAMERA, IDENTITY, Camera, noisy, plain_color, read_image, with_box, write_capture

BOX = (20, 10, 11, 7)  # columns and rows of the thing left behind
HEIGHT = 60
FRAMES = 10
GREEN = (0, 255, 0)
ORANGE = (200, 100, 50)
GAUSSIAN = ('--method', 'gaussian')


def floor():
    """Tilted, with a strip beyond the default clip and one that is never measured."""
    depth = CAMERA.plane(1000, per_column=1)
    depth[44:] = 2600
    depth[:, :3] = 0
    return depth


def picture(width=CAMERA.width, height=CAMERA.height):
    return plain_color(width, height, ORANGE)


def pixels_in(box):
    x, y, w, h = box
    mask = np.zeros((CAMERA.height, CAMERA.width), bool)
    mask[y:y + h, x:x + w] = True
    return mask


def constant_mask(initial, final, threshold=50, clip=2000):
    before, after = initial[0].astype(int), final[0].astype(int)
    return (before > 0) & (after > 0) & (after < clip) & (before - after > threshold)


def statistics(frames):
    """Mean and deviation over the frames that measured a pixel, and whether half of them did."""
    depth = frames.astype(np.int64)
    count = np.maximum((depth > 0).sum(0), 1)
    mean = depth.sum(0) / count
    deviation = np.sqrt(count * (depth ** 2).sum(0) - depth.sum(0) ** 2) / count
    return mean, deviation, 2 * (depth > 0).sum(0) >= len(depth)


def gaussian_mask(initial, final, sigmas=3):
    mean_i, deviation_i, seen_i = statistics(initial)
    mean_f, deviation_f, seen_f = statistics(final)
    return seen_i & seen_f & (mean_f + sigmas * deviation_f < mean_i - sigmas * deviation_i)


def expected_finding(before_mm, after_mm, mask):
    """The single finding that is all of the mask; its number of pixels is odd, so medians are plain."""
    rows, columns = np.nonzero(mask)
    depth_m = np.median(after_mm[mask]) / 1000
    box = [columns.min(), rows.min(), np.ptp(columns) + 1, np.ptp(rows) + 1]
    centroid = [columns.mean(), rows.mean()]
    return {'bbox': box, 'area_px': mask.sum(), 'centroid': centroid,
            'position_m': CAMERA.deproject(*centroid, depth_m),
            'size_mm': [box[2] * depth_m / CAMERA.fx * 1000, box[3] * depth_m / CAMERA.fy * 1000],
            'height_mm': np.median((before_mm - after_mm)[mask])}


WITH_COLOR = {'color': CAMERA.fields(), 'color_from_depth': IDENTITY}


class DetectTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.initial_frames = noisy(floor(), FRAMES, 1.0, seed=1)
        self.final_frames = noisy(with_box(floor(), BOX, HEIGHT), FRAMES, 1.0, seed=2)

    def write(self, name, frames, **keys):
        return write_capture(self.folder / name, frames, **{'pictures': [picture()], **keys})

    def pair(self, **keys):
        return self.write('a', self.initial_frames, **keys), self.write('b', self.final_frames, **keys)

    def check_number(self, value):
        self.assertIsInstance(value, (int, float))
        self.assertNotIsInstance(value, bool)

    def check_numbers(self, values, count):
        self.assertEqual(len(values), count)
        for value in values:
            self.check_number(value)

    def check_contract(self, result):
        self.assertEqual((result['format'], result['version']), ('rva-detections', 1))
        self.assertIn(result['method'], ('constant', 'gaussian'))
        self.check_numbers(list(result['parameters'].values()), len(result['parameters']))
        self.assertEqual(set(result['frames']), {'initial', 'final'})
        self.assertEqual(result['final_from_initial'], IDENTITY)
        self.assertLessEqual({'compared', 'unseen', 'invalid'}, set(result['coverage']))
        self.assertAlmostEqual(sum(result['coverage'].values()), 1, places=12)
        runtime = result['runtime_ms']
        self.assertEqual(set(runtime), {'load', 'statistics', 'detect', 'regions', 'total'})
        self.assertGreaterEqual(min(runtime.values()), 0)
        self.assertGreater(runtime['total'], 0)
        findings = result['detections']
        self.assertEqual([f['id'] for f in findings], list(range(1, len(findings) + 1)))
        scores = [f['score'] for f in findings]
        self.assertEqual(scores, sorted(scores, reverse=True))
        for finding in findings:
            self.assertNotIn('p_value', finding, 'neither method has one')
            self.assertEqual(finding['kind'], 'added')
            for whole in [finding['id'], finding['area_px'], *finding['bbox']]:
                self.assertIs(type(whole), int)
            for key, count in {'bbox': 4, 'centroid': 2, 'position_m': 3, 'size_mm': 2}.items():
                self.check_numbers(finding[key], count)
            self.check_number(finding['height_mm'])
            self.check_number(finding['score'])

    def check_finding(self, finding, expected):
        for key, value in expected.items():
            np.testing.assert_allclose(finding[key], value, rtol=1e-5, err_msg=key)

    def check_changes(self, mask):
        changes = read_image(self.out / 'changes.png')
        self.assertEqual((changes.dtype, changes.ndim), (np.uint8, 2))
        np.testing.assert_array_equal(changes, np.where(mask, 255, 0))

    def test_constant_finds_the_box(self):
        result = self.detect(*self.pair(), '--method', 'constant')
        mask = constant_mask(self.initial_frames, self.final_frames)
        np.testing.assert_array_equal(mask, pixels_in(BOX))
        self.check_contract(result)
        self.check_changes(mask)
        self.assertEqual(result['method'], 'constant')
        self.assertEqual(result['frames'], {'initial': 1, 'final': 1})
        self.assertEqual(len(result['detections']), 1)
        self.check_finding(result['detections'][0],
                           expected_finding(self.initial_frames[0].astype(float),
                                            self.final_frames[0].astype(float), mask))

    def test_gaussian_finds_the_box(self):
        result = self.detect(*self.pair(), *GAUSSIAN)
        mask = gaussian_mask(self.initial_frames, self.final_frames)
        np.testing.assert_array_equal(mask, pixels_in(BOX))
        self.check_contract(result)
        self.check_changes(mask)
        self.assertEqual(result['method'], 'gaussian')
        self.assertEqual(result['frames'], {'initial': FRAMES, 'final': FRAMES})
        self.assertEqual(len(result['detections']), 1)
        self.check_finding(result['detections'][0],
                           expected_finding(self.initial_frames.mean(0), self.final_frames.mean(0), mask))

    def test_every_changed_pixel_is_in_changes_png(self):
        self.final_frames = noisy(with_box(floor(), BOX, 7), FRAMES, 1.0, seed=3)
        self.detect(*self.pair(), *GAUSSIAN)
        mask = gaussian_mask(self.initial_frames, self.final_frames)
        self.assertTrue(0 < mask.sum() < pixels_in(BOX).sum(), 'a box so low that noise decides')
        self.check_changes(mask)

    def test_calibrated_is_the_default(self):
        result = self.detect(*self.pair())
        self.assertEqual(result['method'], 'calibrated')
        self.assertEqual(result['parameters'], {'false_findings': 0.05, 'min_blob_px': 0, 'join_px': 30})
        self.assertAlmostEqual(sum(result['coverage'].values()), 1, places=12)
        (finding,) = result['detections']
        self.assertEqual(finding['kind'], 'added')
        np.testing.assert_allclose(finding['bbox'], BOX, atol=1)
        self.assertAlmostEqual(finding['height_mm'], HEIGHT, delta=3)
        self.assertLess(finding['p_value'], 0.05)
        self.assertAlmostEqual(finding['p_value'], -np.expm1(-10.0 ** -finding['score']))
        removed = self.detect(*reversed(self.pair()), out=self.folder / 'removed')
        self.assertEqual([f['kind'] for f in removed['detections']], ['removed'])

    def test_calibrated_says_what_it_could_have_found(self):
        printed = self.succeed('detect', *self.pair(), '--out', self.out).stdout
        picture = read_image(self.out / 'level_of_detection.png')
        picture = picture[:CAMERA.height, :CAMERA.width]  # the bar beside it needs more height than so small an image
        self.assertTrue((picture[:6] == 0).all(), 'nothing is judged at the border')
        self.assertTrue((picture[10:30, 10:-6] != 0).any(-1).all(), 'everything else is')
        level = json.loads((self.out / 'level_of_detection.json').read_text())
        self.assertEqual((level['format'], level['version']), ('rva-level-of-detection', 1))
        self.assertTrue(0 < level['judged'] < 1)
        for entry in level['by_distance']:
            self.assertLess(entry['from_m'], entry['to_m'])
            self.assertTrue(0 < entry['median_mm'] <= entry['p90_mm'])
            self.assertAlmostEqual(entry['width_mm'], 1000 * level['window_px'] * entry['to_m'] / CAMERA.fx)
        findable = level['findable']
        self.assertEqual([entry['size_mm'] for entry in findable], [5, 10, 20])
        shares = [entry['share'] for entry in findable]
        self.assertEqual(shares, sorted(shares))
        self.assertLessEqual(shares[-1], level['judged'])
        percents = [f'{100 * share:.0f} %' for share in shares]
        self.assertIn('{} inspected for objects from 5 mm up, {} from 10 mm, {} from 20 mm\n'.format(*percents), printed)
        other = self.folder / 'gaussian'
        self.detect(*self.pair(), *GAUSSIAN, out=other)
        self.assertFalse((other / 'level_of_detection.png').exists(), 'this method has none')

    def test_calibrated_says_what_one_frame_lacks(self):
        done = self.succeed('detect', *self.pair(), '--out', self.out, '--frames', 1)
        self.assertIn('a single frame does not show noise over time', done.stderr)

    def test_coverage_of_constant_counts_pixels(self):
        self.initial_frames[:, :, 8:12] = 0
        self.final_frames[:, 2:5] = 0
        coverage = self.detect(*self.pair(), '--method', 'constant')['coverage']
        before, after = self.initial_frames[0], self.final_frames[0]
        near = (after > 0) & (after < 2000)
        self.assertEqual(set(coverage), {'compared', 'unseen', 'invalid', 'beyond_clip'})
        self.assertAlmostEqual(coverage['compared'], np.mean(near & (before > 0)))
        self.assertAlmostEqual(coverage['unseen'], np.mean(near & (before == 0)))
        self.assertAlmostEqual(coverage['invalid'], np.mean(after == 0))
        self.assertAlmostEqual(coverage['beyond_clip'], np.mean(after >= 2000))

    def test_coverage_of_gaussian_takes_pixels_seen_in_half_of_the_frames(self):
        self.initial_frames[: FRAMES // 2, :, 40] = 0
        self.initial_frames[: FRAMES // 2 + 1, :, 45] = 0
        self.final_frames[: FRAMES // 2 + 1, :, 50] = 0
        coverage = self.detect(*self.pair())['coverage']
        before, after = statistics(self.initial_frames)[2], statistics(self.final_frames)[2]
        self.assertAlmostEqual(coverage['compared'], np.mean(before & after))
        self.assertAlmostEqual(coverage['unseen'], np.mean(~before & after))
        self.assertAlmostEqual(coverage['invalid'], np.mean(~after))

    def test_pixels_without_a_measurement_are_no_change(self):
        x, y, w, h = BOX
        self.initial_frames[:, y:y + h, x] = 0
        self.final_frames[:, y:y + h, x + 1] = 0
        for method in ('constant', 'gaussian'):
            with self.subTest(method):
                out = self.folder / method
                found = self.detect(*self.pair(), '--method', method, out=out)['detections']
                self.assertEqual([f['bbox'] for f in found], [[x + 2, y, w - 2, h]])

    def test_what_was_taken_away_is_not_added(self):
        initial, final = self.pair()
        for method in ('constant', 'gaussian'):
            with self.subTest(method):
                out = self.folder / method
                self.assertEqual(self.detect(final, initial, '--method', method, out=out)['detections'], [])

    def test_higher_of_two_boxes_comes_first(self):
        low, high = (8, 8, 7, 7), (50, 30, 7, 7)
        depth = with_box(with_box(floor(), low, 60), high, 120)
        self.final_frames = noisy(depth, FRAMES, 1.0, seed=4)
        for method in ('constant', 'gaussian'):
            with self.subTest(method):
                result = self.detect(*self.pair(), '--method', method, out=self.folder / method)
                self.check_contract(result)
                self.assertEqual([tuple(f['bbox']) for f in result['detections']], [high, low])

    def test_pictures_have_the_sizes_of_their_cameras(self):
        self.detect(*self.pair(pictures=[picture(100, 80)]))
        for name, shape in {'overlay.png': (80, 100, 3), 'depth_overlay.png': (48, 64, 3)}.items():
            image = read_image(self.out / name)
            self.assertEqual(image.dtype, np.uint8)
            self.assertTrue(image.shape == shape or name == 'depth_overlay.png', 'that has a legend at the right')
            self.assertGreaterEqual(image.shape, shape)

    def test_depth_overlay_shows_a_white_box_and_black_where_nothing_was_measured(self):
        self.detect(*self.pair())
        overlay = read_image(self.out / 'depth_overlay.png')[:CAMERA.height, :CAMERA.width]  # without the legend
        self.check_rectangle((overlay == 255).all(-1), BOX)
        self.assertFalse(overlay[5:40, 0].any())
        self.assertTrue(overlay[5, 40].any())

    def check_rectangle(self, drawn, box):
        """Lines around the box, a few pixels outside."""
        x, y, w, h = box
        columns = np.flatnonzero(drawn.sum(0) >= 0.9 * h)
        rows = np.flatnonzero(drawn.sum(1) >= 0.9 * w)
        sides = [columns.min(), rows.min(), columns.max(), rows.max()]
        for side, edge, outwards in zip(sides, [x, y, x + w - 1, y + h - 1], [-1, -1, 1, 1]):
            self.assertIn((side - edge) * outwards, range(0, 7), f'{sides} around {box}')

    def test_box_on_colour_goes_through_depth_and_both_cameras(self):
        camera = Camera(160, 120, 130.0, 126.0, 84.0, 55.0)
        turn, shift = np.radians(3.0), np.array([0.12, -0.03, 0.01])
        rotation = np.array([[np.cos(turn), 0, np.sin(turn)], [0, 1, 0], [-np.sin(turn), 0, np.cos(turn)]])
        matrix = np.vstack([np.column_stack([rotation, shift]), [0, 0, 0, 1]])
        self.detect(*self.pair(pictures=[picture(160, 120)], color=camera.fields(),
                               color_from_depth=matrix.ravel().tolist()))
        rows, columns = np.nonzero(pixels_in(BOX))
        depth_m = self.final_frames.mean(0)[rows, columns] / 1000
        seen = camera.project(CAMERA.deproject(columns, rows, depth_m) @ rotation.T + shift)
        (left, top), (right, bottom) = np.rint(seen.min(0)), np.rint(seen.max(0))
        overlay = read_image(self.out / 'overlay.png')
        self.check_rectangle((overlay == GREEN).all(-1), (left, top, right - left + 1, bottom - top + 1))
        self.assertEqual(tuple(overlay[110, 10]), ORANGE)

    def test_box_on_colour_is_scaled_where_the_colour_camera_is_not_described(self):
        self.detect(*self.pair(pictures=[picture(3 * CAMERA.width, 3 * CAMERA.height)]))
        overlay = read_image(self.out / 'overlay.png')
        self.check_rectangle((overlay == GREEN).all(-1), [3 * edge for edge in BOX])

    def test_finding_outside_the_colour_view_is_warned_about(self):
        aside = [*IDENTITY]
        aside[3] = 9.0
        pair = self.pair(color=CAMERA.fields(), color_from_depth=aside)
        done = self.succeed('detect', *pair, '--out', self.out)
        self.assertRegex(done.stderr, r'\Arva: warning: 1 finding[^\n]+depth_overlay\.png[^\n]+\n\Z')
        self.assertFalse((read_image(self.out / 'overlay.png') == GREEN).all(-1).any())

    def test_without_colour_there_is_a_warning_and_no_overlay(self):
        done = self.succeed('detect', *self.pair(pictures=[]), '--out', self.out)
        self.assertRegex(done.stderr, r'\Arva: warning: [^\n]*overlay\.png[^\n]*\n\Z')
        self.assertEqual(sorted(path.name for path in self.out.iterdir()),
                         ['changes.png', 'depth_overlay.png', 'detections.json', 'level_of_detection.json',
                          'level_of_detection.png'])

    def test_moved_camera_is_warned_about(self):
        initial = self.write('a', self.initial_frames, pose={'base': 'b1', 'pan_deg': 0}, **WITH_COLOR)
        final = self.write('b', self.final_frames, pose={'base': 'b1', 'pan_deg': 5}, **WITH_COLOR)
        done = self.succeed('detect', initial, final, '--method', 'calibrated', '--out', self.out)
        self.assertRegex(done.stderr, r'\Arva: warning: [^\n]*moved[^\n]*\n\Z')

    def test_json_prints_the_file(self):
        done = self.succeed('detect', *self.pair(**WITH_COLOR), '--out', self.out, '--json')
        self.assertEqual(done.stdout.encode(), (self.out / 'detections.json').read_bytes())
        self.assertEqual(done.stderr, '')

    def test_table_for_a_person_names_the_finding_and_the_folder(self):
        done = self.succeed('detect', *self.pair(), '--out', self.out)
        self.assertIn(' '.join(map(str, BOX)), done.stdout)
        self.assertIn(str(self.out), done.stdout)

    def test_fail_on_detection(self):
        initial, final = self.pair()
        found = self.detect(initial, final, '--fail-on-detection', status=3)
        self.assertEqual(len(found['detections']), 1)
        unchanged = self.write('unchanged', noisy(floor(), FRAMES, 1.0, seed=6))
        nothing = self.detect(initial, unchanged, '--fail-on-detection', out=self.folder / 'other')
        self.assertEqual(nothing['detections'], [])

    def test_frames_uses_only_the_first(self):
        self.initial_frames = noisy(floor(), 6, 0, seed=0)
        self.initial_frames[:, 40, 60] += np.arange(6, dtype=np.uint16)  # the least noise, or the camera is frozen
        self.final_frames = self.initial_frames[::-1].copy()
        self.final_frames[:3] = with_box(self.final_frames[:3], BOX, HEIGHT)
        initial, final = self.pair()
        few = self.detect(initial, final, *GAUSSIAN, '--frames', 3, out=self.folder / 'few')
        self.assertEqual(few['frames'], {'initial': 3, 'final': 3})
        self.assertEqual([tuple(f['bbox']) for f in few['detections']], [BOX])
        every = self.detect(initial, final, *GAUSSIAN, out=self.folder / 'every')
        self.assertEqual(every['detections'], [])

    def test_more_frames_than_there_are_is_a_warning(self):
        done = self.succeed('detect', *self.pair(**WITH_COLOR), '--out', self.out, '--frames', FRAMES + 1)
        for side, line in zip(('initial', 'final'), done.stderr.splitlines(), strict=True):
            self.assertIn('rva: warning: ', line)
            self.assertIn(side, line)

    def test_options_have_effect(self):
        near, speck = (35, 10, 6, 7), (52, 32, 3, 2)
        depth = floor()
        for box in (BOX, near, speck):
            depth = with_box(depth, box, HEIGHT)
        self.final_frames = noisy(depth, FRAMES, 1.0, seed=5)
        initial, final = self.pair()
        pair, everything = (20, 10, 21, 7), (20, 10, 35, 24)
        constant = ['--method', 'constant']
        table = {
            'join, default': ([*GAUSSIAN], {everything}),
            'join, none': ([*GAUSSIAN, '--join', 0], {BOX, near, speck}),
            'join, the distance of the first two': ([*GAUSSIAN, '--join', 5], {BOX, near, speck}),
            'join, more than that': ([*GAUSSIAN, '--join', 5.01], {pair, speck}),
            'join, the distance of the third': ([*GAUSSIAN, '--join', 20], {pair, speck}),  # 12 columns, 16 rows
            'join, more than that too': ([*GAUSSIAN, '--join', 20.01], {everything}),
            'min-blob, as large': ([*GAUSSIAN, '--min-blob', 6], {everything}),
            'min-blob, larger': ([*GAUSSIAN, '--min-blob', 7], {pair}),
            'sigmas, many': ([*GAUSSIAN, '--sigmas', 100], set()),
            'threshold, below': ([*constant, '--threshold', 0.055], {everything}),
            'threshold, above': ([*constant, '--threshold', 0.065], set()),
            'clip, behind': ([*constant, '--clip', 1.5], {everything}),
            'clip, before': ([*constant, '--clip', 0.9], set()),
        }
        for name, (options, boxes) in table.items():
            with self.subTest(name):
                result = self.detect(initial, final, *options, out=self.folder / name)
                self.assertEqual({tuple(f['bbox']) for f in result['detections']}, boxes)
                self.assertEqual(len(result['detections']), len(boxes))

    def test_parameters_state_the_options(self):
        initial, final = self.pair()
        gaussian = self.detect(initial, final, *GAUSSIAN, '--sigmas', 2.5, '--min-blob', 3, '--join', 4,
                               out=self.folder / 'g')
        self.assertEqual(gaussian['parameters'], {'sigmas': 2.5, 'min_blob_px': 3, 'join_px': 4})
        constant = self.detect(initial, final, '--method', 'constant', '--threshold', 0.03, '--clip', 3,
                               out=self.folder / 'c')
        self.assertEqual(constant['parameters'],
                         {'threshold_m': 0.03, 'clip_m': 3, 'min_blob_px': 0, 'join_px': 30})

    def test_small_blobs_stay_in_changes_png(self):
        result = self.detect(*self.pair(), *GAUSSIAN, '--min-blob', 1000)
        self.assertEqual(result['detections'], [])
        self.check_changes(pixels_in(BOX))

    def test_one_capture_is_no_pair(self):
        a, b = self.pair()
        link = self.folder / 'link'
        link.symlink_to(a)
        for same in (a, link, f'{a}/'):
            self.check_fails('detect', a, same, '--out', self.out, names=['both sides are the same capture'])
        self.check_fails('detect', '--initial', a, link, '--final', b, '--out', self.out, names=['given twice'])

    def test_copy_of_a_capture_is_refused_by_every_method(self):
        a = self.write('a', self.initial_frames)
        b = self.write('b', self.initial_frames, camera={'model': 'another name', 'serial': ''})
        for method in ('auto', 'constant', 'gaussian', 'calibrated'):
            self.check_fails('detect', a, b, '--out', self.out, '--method', method, names=['one is a copy of the other'])

    def test_frozen_camera_is_refused_where_noise_is_estimated(self):
        frozen = self.write('frozen', self.initial_frames[[0] * FRAMES])
        b = self.write('b', self.final_frames)
        for captures in ((frozen, b), (b, frozen)):
            for method in ('auto', 'gaussian', 'calibrated'):
                self.check_fails('detect', *captures, '--out', self.out, '--method', method,
                                 names=['the camera was frozen', 'capture again'])
        self.assertEqual(len(self.detect(frozen, b, '--method', 'constant')['detections']), 1)
        self.check_fails('noise', frozen, '--out', self.folder / 'noise', names=['the camera was frozen'])

    def test_provenance_names_captures_program_and_time(self):
        camera = {'model': 'D435', 'serial': '7'}
        self.write('a', self.initial_frames, camera=camera, captured_at='2026-01-02T03:04:05Z')
        self.write('b', self.final_frames[:4])
        made = self.detect('a', 'b/')['provenance']
        self.assertEqual(made['initial'], [{'path': 'a', 'format': 'rva-capture', 'frames': FRAMES, 'serial': '7',
                                            'captured_at': '2026-01-02T03:04:05Z'}])
        self.assertEqual(made['final'], [{'path': 'b/', 'format': 'rva-capture', 'frames': 4}])
        self.assertEqual(f"{made['version']}\n", self.succeed('--version').stdout)
        self.assertRegex(made['created_at'], r'\A20\d\d-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z\Z')

    def test_time_may_be_set_for_repeatable_bytes(self):
        a, b = self.pair()
        self.addCleanup(os.environ.pop, 'SOURCE_DATE_EPOCH', None)
        os.environ['SOURCE_DATE_EPOCH'] = '1767225600'
        self.assertEqual(self.detect(a, b)['provenance']['created_at'], '2026-01-01T00:00:00.000Z')
        for wrong in ('', 'today', '-1', '1.5', '99999999999999999999'):
            os.environ['SOURCE_DATE_EPOCH'] = wrong
            self.check_fails('detect', a, b, '--out', self.folder / 'other', names=['SOURCE_DATE_EPOCH'])

    def test_two_runs_agree(self):
        initial, final = self.pair()
        one, two = (self.detect(initial, final, out=self.folder / out) for out in ('one', 'two'))
        for result in (one, two):
            del result['runtime_ms'], result['provenance']['created_at']
        for name in ('changes.png', 'overlay.png', 'depth_overlay.png'):
            self.assertEqual((self.folder / 'one' / name).read_bytes(),
                             (self.folder / 'two' / name).read_bytes(), name)
        self.assertEqual(one, two)

    def test_out_is_made_with_its_parents(self):
        self.detect(*self.pair(), out=self.folder / 'x' / 'y' / 'z')
        self.assertEqual([path.name for path in (self.folder / 'x' / 'y').iterdir()], ['z'])

    def test_out_may_be_an_empty_folder_and_end_in_a_slash(self):
        self.out.mkdir()
        self.succeed('detect', *self.pair(), '--out', f'{self.out}/')
        self.assertTrue((self.out / 'detections.json').exists())
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ['a', 'b', 'out'])

    def test_overwrite_replaces_an_earlier_result(self):
        initial, final = self.pair()
        self.detect(initial, final)
        unchanged = self.write('unchanged', noisy(floor(), FRAMES, 1.0, seed=6))
        result = self.detect(initial, unchanged, '--overwrite', '--method', 'constant')
        self.assertEqual((result['method'], result['detections']), ('constant', []))
        self.check_changes(np.zeros((CAMERA.height, CAMERA.width), bool))
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ['a', 'b', 'out', 'unchanged'])

    def test_overwrite_removes_pictures_that_the_new_result_lacks(self):
        self.detect(*self.pair())
        self.detect(self.write('c', self.initial_frames, pictures=[]), self.write('d', self.final_frames, pictures=[]),
                    '--overwrite')
        self.assertFalse((self.out / 'overlay.png').exists())

    def test_overwrite_replaces_nothing_else(self):
        initial, final = self.pair()
        precious = self.out / 'thesis.txt'
        self.out.mkdir()
        precious.write_text('years of work')
        file = self.folder / 'file'
        file.write_text('years of work')
        for target in (self.out, file, initial):
            with self.subTest(target.name):
                self.check_fails('detect', initial, final, '--out', target, '--overwrite', names=[target])
        self.assertEqual({precious.read_text(), file.read_text()}, {'years of work'})

    def test_earlier_result_survives_a_failure(self):
        initial, final = self.pair()
        self.detect(initial, final)
        before = {path.name: path.read_bytes() for path in self.out.iterdir()}
        (final / 'depth' / '000004.png').write_text('no picture')
        self.check_fails('detect', initial, final, '--out', self.out, '--overwrite', names=['000004.png'])
        self.assertEqual({path.name: path.read_bytes() for path in self.out.iterdir()}, before)


if __name__ == '__main__':
    program.main()
