"""`rva noise` from end to end, against numpy on the same frames.

usage: noise_test.py RVA
"""
import json
import math

import numpy as np

import program
from captures import CAMERA, noisy, read_image, write_capture

UNIT_M = 0.0001  # fine, so that rounding hardly adds to the noise
SIGMA_MM = 3.0
SIGMA_UNITS = SIGMA_MM / (UNIT_M * 1000)
FRAMES = 40
WELCH_FRAMES = 10
BASELINE_M = 0.055
BLACK, GREY, WHITE = 0, 96, 255


def scene():
    """Two walls in units, one at 1.5 m and one at 2.1 m, and a corner that is never measured."""
    depth = np.full((CAMERA.height, CAMERA.width), 15000.0)
    depth[:, 40:] = 21000
    depth[:6, :5] = 0
    return depth


def population(frames):
    """Count, mean and deviation of every pixel over the frames that measured it."""
    depth = np.where(frames > 0, frames.astype(float), np.nan)
    count = (frames > 0).sum(0)
    mean = np.nansum(depth, axis=0) / np.maximum(count, 1)
    square = np.nansum((depth - mean) ** 2, axis=0) / np.maximum(count, 1)
    return count, mean, np.sqrt(square)


def lower_quantile(values, share):
    return np.sort(values)[int(share * (len(values) - 1))]


def t_p_value(t, freedom):
    """Two-sided p-value of Student's t, by Simpson's rule over its density."""
    steps = 2000
    x = np.linspace(0, 1, steps + 1)[:, None] * np.minimum(np.abs(t), 60)
    constant = np.array([math.lgamma((f + 1) / 2) - math.lgamma(f / 2) for f in freedom])
    density = np.exp(constant - 0.5 * np.log(freedom * np.pi) - (freedom + 1) / 2 * np.log1p(x * x / freedom))
    weights = np.ones(steps + 1)
    weights[1:-1:2], weights[2:-1:2] = 4, 2
    return 1 - 2 * (weights @ density) * x[-1] / steps / 3


def welch_p_values(first, last):
    """For pixels that every frame measured: p-values as Welch (1947) has them."""
    n = len(first)
    first, last = (frames.reshape(n, -1).astype(float) for frames in (first, last))
    a, b = first.var(0, ddof=1) / n, last.var(0, ddof=1) / n
    t = (first.mean(0) - last.mean(0)) / np.sqrt(a + b)
    return t_p_value(t, (a + b) ** 2 * (n - 1) / (a * a + b * b))


class NoiseTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.frames = noisy(scene(), FRAMES, SIGMA_UNITS, seed=7)

    def noise(self, frames, *options, **keys):
        capture = write_capture(self.folder / 'capture', frames, unit_m=UNIT_M, **keys)
        self.succeed('noise', capture, '--out', self.out, *options)
        return json.loads((self.out / 'noise.json').read_text())

    def check_figures(self, figures, deviation):
        std_mm = deviation * UNIT_M * 1000
        self.assertEqual(figures['pixels'], deviation.size)
        np.testing.assert_allclose(figures['median_std_mm'], lower_quantile(std_mm, 0.5), rtol=1e-6)
        np.testing.assert_allclose(figures['p95_std_mm'], lower_quantile(std_mm, 0.95), rtol=1e-6)

    def test_deviation_is_that_of_the_noise(self):
        report = self.noise(self.frames)
        self.assertEqual((report['format'], report['version'], report['frames']), ('rva-noise', 1, FRAMES))
        # The deviation of n numbers is expected to fall short of sigma by about 3 / (4 n).
        self.assertAlmostEqual(report['overall']['median_std_mm'], SIGMA_MM * (1 - 0.75 / FRAMES), delta=0.05)
        _, _, deviation = population(self.frames)
        self.check_figures(report['overall'], deviation[scene() > 0])

    def test_distance_classes_part_the_pixels(self):
        self.frames[1:, 20:24] = 0  # measured once: no deviation
        self.frames[2:, 30:34] = 0
        report = self.noise(self.frames, '--bin', 0.5)
        count, mean, deviation = population(self.frames)
        mean_m = mean * UNIT_M
        for figures in report['by_distance']:
            inside = (count >= 2) & (mean_m >= figures['from_m']) & (mean_m < figures['to_m'])
            self.check_figures(figures, deviation[inside])
            self.assertAlmostEqual(figures['to_m'] - figures['from_m'], 0.5)
        self.assertGreaterEqual(len(report['by_distance']), 2)
        self.assertEqual(sum(f['pixels'] for f in report['by_distance']), (count >= 2).sum())
        self.check_figures(report['overall'], deviation[count >= 2])

    def test_subpixel_error_needs_the_baseline(self):
        report = self.noise(self.frames, camera={'baseline_m': BASELINE_M})
        count, mean, deviation = population(self.frames)
        disparity_px = (CAMERA.fx * BASELINE_M * deviation / UNIT_M / np.maximum(mean, 1) ** 2)[count >= 2]
        np.testing.assert_allclose(report['overall']['subpixel_rms_px'], np.sqrt(np.mean(disparity_px ** 2)),
                                   rtol=1e-9)
        self.assertTrue(all('subpixel_rms_px' in figures for figures in report['by_distance']))

    def test_without_baseline_there_is_no_subpixel_error(self):
        report = self.noise(self.frames, camera={'model': 'unknown'})
        self.assertFalse(any('subpixel_rms_px' in f for f in [report['overall'], *report['by_distance']]))

    def test_fill_rate_counts_measurements(self):
        self.frames[np.random.default_rng(3).random(self.frames.shape) < 0.2] = 0
        self.assertAlmostEqual(self.noise(self.frames)['fill_rate'], np.mean(self.frames > 0))

    def test_white_noise_is_rejected_at_the_rate_alpha(self):
        frames = noisy(CAMERA.plane(15000), FRAMES, SIGMA_UNITS, seed=8)
        for alpha in (0.01, 0.2):
            with self.subTest(alpha):
                welch = self.noise(frames, '--alpha', alpha, '--overwrite')['welch']
                pixels = frames[0].size
                self.assertEqual((welch['frames'], welch['alpha'], welch['tested_px']),
                                 (WELCH_FRAMES, alpha, pixels))
                five_deviations = 5 * math.sqrt(alpha * (1 - alpha) / pixels)
                self.assertAlmostEqual(welch['rejected'], alpha, delta=five_deviations)

    def test_welch_agrees_pixel_for_pixel(self):
        frames = noisy(CAMERA.plane(15000), FRAMES, SIGMA_UNITS, seed=9)
        drift = np.linspace(0, SIGMA_UNITS, FRAMES)
        frames = np.rint(frames + drift[:, None, None]).astype(np.uint16)
        for n in (WELCH_FRAMES, 4):
            with self.subTest(frames=n):
                welch = self.noise(frames, '--welch-frames', n, '--overwrite')['welch']
                p = welch_p_values(frames[:n], frames[-n:])
                decided = abs(p - 0.01) > 1e-5
                self.assertGreater(decided.mean(), 0.99)
                picture = read_image(self.out / 'drift.png').ravel()
                np.testing.assert_array_equal(picture[decided], np.where(p < 0.01, WHITE, BLACK)[decided])
                self.assertAlmostEqual(welch['rejected'], np.mean(picture == WHITE))
                self.assertTrue(0.01 < welch['rejected'] < 0.99)

    def test_step_is_rejected_nearly_everywhere(self):
        self.frames[FRAMES // 2:][self.frames[FRAMES // 2:] > 0] += int(5 * SIGMA_UNITS)
        self.assertGreater(self.noise(self.frames)['welch']['rejected'], 0.99)

    def test_drift_picture_is_white_black_and_grey(self):
        frames = noisy(CAMERA.plane(15000), FRAMES, 0, seed=0)
        frames[FRAMES // 2:, 10:20, 10:20] += 1  # drifts
        frames[1:WELCH_FRAMES, 30:40] = 0  # measured once in the first frames
        expected = np.full(frames[0].shape, BLACK)
        expected[10:20, 10:20] = WHITE
        expected[30:40] = GREY
        welch = self.noise(frames)['welch']
        picture = read_image(self.out / 'drift.png')
        self.assertEqual(picture.dtype, np.uint8)
        np.testing.assert_array_equal(picture, expected)
        self.assertEqual(welch['tested_px'], np.count_nonzero(expected != GREY))
        self.assertAlmostEqual(welch['rejected'], 100 / welch['tested_px'])

    def test_deviation_picture_is_colour_with_a_scale_beside_it(self):
        self.frames[:, :, :20] = scene()[:, :20]  # no noise there
        self.noise(self.frames)
        picture = read_image(self.out / 'std.png')
        self.assertEqual((picture.dtype, picture.ndim), (np.uint8, 3))
        self.assertGreaterEqual(picture.shape[0], CAMERA.height)
        self.assertGreater(picture.shape[1], CAMERA.width)
        self.assertFalse(picture[:6, :5].any(), 'black where nothing was measured')
        quiet, loud = picture[20:30, 8:18].reshape(-1, 3), picture[20:30, 30:60].reshape(-1, 3)
        self.assertTrue((quiet[:, 2] > 0).all() and not quiet[:, 0].any(), 'the low end of jet is blue')
        self.assertTrue((loud.astype(int).sum(1) > quiet.astype(int).sum(1).max()).all())

    def test_frames_uses_only_the_first(self):
        report = self.noise(self.frames, '--frames', 12)
        self.assertEqual((report['frames'], report['welch']['frames']), (12, 6))
        _, _, deviation = population(self.frames[:12])
        self.check_figures(report['overall'], deviation[scene() > 0])

    def test_four_frames_are_enough_and_three_are_not(self):
        self.assertEqual(self.noise(self.frames[:4])['welch']['frames'], 2)
        few = write_capture(self.folder / 'few', self.frames[:3])
        self.check_fails('noise', few, '--out', self.folder / 'none', names=['3 frame'])
        self.check_fails('noise', self.folder / 'capture', '--frames', 3, '--out', self.folder / 'none',
                         names=['3 frame'])

    def test_nothing_measured_is_no_error(self):
        report = self.noise(np.zeros((4, CAMERA.height, CAMERA.width), np.uint16))
        self.assertEqual((report['fill_rate'], report['overall']['pixels']), (0, 0))
        self.assertEqual(report['by_distance'], [])
        self.assertEqual(report['welch']['tested_px'], 0)
        for unknown in ('median_std_mm', 'p95_std_mm', 'rejected'):
            self.assertNotIn(unknown, {**report['overall'], **report['welch']})
        self.assertTrue((read_image(self.out / 'drift.png') == GREY).all())

    def test_json_prints_the_file(self):
        capture = write_capture(self.folder / 'capture', self.frames)
        done = self.succeed('noise', capture, '--out', self.out, '--json')
        self.assertEqual(done.stdout.encode(), (self.out / 'noise.json').read_bytes())
        self.assertEqual(done.stderr, '')
        self.assertEqual(sorted(path.name for path in self.out.iterdir()),
                         ['drift.png', 'noise.json', 'std.png'])

    def test_table_leaves_out_distances_of_a_few_pixels_that_the_file_has(self):
        self.frames[:, 20:22, 8:12] += 60000 - 15000  # eight pixels at 6 m
        capture = write_capture(self.folder / 'capture', self.frames, unit_m=UNIT_M)
        table = self.succeed('noise', capture, '--out', self.out).stdout
        for distance, printed in (('1.50', True), ('2.00', True), ('6.00', False), ('5.75', False)):
            self.assertEqual(f' {distance}-' in table, printed, table)
        self.assertIn('more distance(s) with fewer than 100 pixels each are in noise.json', table)
        far = [entry for entry in json.loads((self.out / 'noise.json').read_text())['by_distance'] if entry['from_m'] > 5]
        self.assertEqual(sum(entry['pixels'] for entry in far), 8)

    def test_overwrite_replaces_a_noise_result_only(self):
        capture = write_capture(self.folder / 'capture', self.frames)
        other = write_capture(self.folder / 'before', self.frames[::-1])
        self.succeed('detect', other, capture, '--out', self.out)
        for options in ([], ['--overwrite']):
            self.check_fails('noise', capture, '--out', self.out, *options, names=[self.out])
        other = self.folder / 'other'
        self.succeed('noise', capture, '--out', other)
        self.succeed('noise', capture, '--out', other, '--overwrite', '--frames', 20)
        self.assertEqual(json.loads((other / 'noise.json').read_text())['frames'], 20)


if __name__ == '__main__':
    program.main()
