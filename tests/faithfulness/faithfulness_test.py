"""The simulated camera behaves like the real one, as far as that was measured (docs/simulator.md has the sources).

usage: faithfulness_test.py RVA SCENES
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import experiments
import measures
from simulation import FOCAL_PX, Capture, simulate, wall_scene

RVA, SCENES = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()


class Simulated(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix='rva-faithfulness-')
        cls.addClassCleanup(temporary.cleanup)
        cls.work = pathlib.Path(temporary.name)

    @classmethod
    def wall(cls, distance_m, *options, frames=8, seed=1, **scene):
        return simulate(RVA, wall_scene(cls.work, distance_m, **scene), cls.work / 'wall', *options, frames=frames,
                        seed=seed)


class Walls(Simulated):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.noise = [measures.wall_noise(cls.wall(distance)) for distance in (0.5, 1.0, 2.0)]

    def test_subpixel_rms_is_the_real_cameras(self):
        for noise in self.noise:
            self.assertGreater(noise['plane_rms_px'], 0.05, noise)
            self.assertLess(noise['plane_rms_px'], 0.10, noise)

    def test_one_pixel_varies_less_over_time_than_a_plane_does_over_space(self):
        for noise in self.noise:
            self.assertGreater(noise['over_time_median_px'], 0.01, noise)
            self.assertLess(noise['over_time_median_px'], noise['plane_rms_px'], noise)

    def test_most_of_the_error_stays_however_many_frames(self):
        for noise in self.noise:
            self.assertGreater(noise['fixed_px'], 0.7 * noise['plane_rms_px'], noise)

    def test_depth_noise_grows_with_the_square_of_distance(self):
        over_space = [noise['plane_rms_mm'] for noise in self.noise]
        over_time = [noise['over_time_median_px'] * noise['distance_m'] ** 2 for noise in self.noise]
        logs = np.log([noise['distance_m'] for noise in self.noise])
        for deviation in (over_space, over_time):
            self.assertAlmostEqual(np.polyfit(logs, np.log(deviation), 1)[0], 2.0, delta=0.2)

    def test_paint_is_measured_everywhere(self):
        for noise in self.noise:
            self.assertGreater(noise['fill'], 0.99, noise)
            self.assertLess(noise['wrong'], 0.002, noise)


class Limits(Simulated):
    def test_nearest_distance_is_the_search_ranges(self):
        for distance, visible in ((0.160, False), (0.175, True)):  # f B / 126 px is 0.169 m
            capture = self.wall(distance, frames=1)
            right = np.abs(capture.disparity_px - capture.true_disparity_px) < measures.WRONG_PX
            self.assertEqual(right[(slice(None), *measures.MIDDLE)].mean() > 0.9, visible, distance)

    def test_depth_comes_in_steps_of_a_32nd_pixel(self):
        capture = self.wall(1.0, frames=1)
        disparity = capture.disparity_px
        steps = 32 * disparity[np.abs(disparity - capture.true_disparity_px) < measures.WRONG_PX]
        self.assertLess(np.abs(steps - np.round(steps)).max(), 0.05)  # what rounding to 0.1 mm leaves
        self.assertGreater(len(np.unique(np.round(steps))), 5)

    def test_bare_metal_is_harder_than_paint(self):
        fill = {material: np.isfinite(self.wall(0.7, frames=2, material=material, turn_deg=30)
                                      .depth_m[(slice(None), *measures.MIDDLE)]).mean()
                for material in ('green-primer', 'bare-aluminium')}
        self.assertLess(fill['bare-aluminium'], fill['green-primer'] - 0.05)

    def test_dots_are_as_far_apart_as_the_projectors(self):
        image = self.wall(1.0, '--infrared', frames=1).infrared('left')[measures.MIDDLE]
        spacing_mm = measures.dot_spacing_px(image) / FOCAL_PX * 1000
        self.assertGreater(spacing_mm, 19)
        self.assertLess(spacing_mm, 22)


class Patterns(Simulated):
    def test_the_fixed_error_comes_back_with_the_pose_and_only_with_it(self):
        first, again = (measures.fixed_pattern(self.wall(1.0, seed=seed)) for seed in (1, 2))
        turned = measures.fixed_pattern(self.wall(1.0, pan_deg=0.325))  # one step of the servo
        self.assertGreater(measures.correlation(first, again), 0.6)
        self.assertLess(abs(measures.correlation(first, turned)), 0.2)

    def test_neighbours_share_their_error_as_far_as_the_window_reaches(self):
        near, far = measures.neighbour_correlation(self.wall(1.0, frames=1), (3, 14))
        self.assertGreater(near, 0.4)
        self.assertLess(abs(far), 0.15)

    def test_noise_is_not_white_in_time_and_is_when_all_that_is_switched_off(self):
        rejected = {}
        for name, options in (('hard', ()), ('white', ('--wander', 0, '--levels', 0, '--flicker', 0))):
            self.wall(1.0, *options, frames=60)
            out = subprocess.run([RVA, 'noise', self.work / 'wall', '--out', self.work / f'noise-{name}', '--json',
                                  '--overwrite'], check=True, capture_output=True, text=True)
            rejected[name] = json.loads(out.stdout)['welch']['rejected']
        self.assertGreater(rejected['hard'], 0.10)  # alpha is 0.01
        self.assertLess(rejected['white'], 0.03)


class Wing(Simulated):
    """The thesis' three tools: what its methods did, they do here."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for name, seed, options in (('initial', 11, ('--debris', 'none')), ('final', 12, ())):
            simulate(RVA, SCENES / 'three-tools.yaml', cls.work / name, *options, frames=60, seed=seed)

    def detect(self, *options):
        return experiments.detect(RVA, self.work / 'initial', self.work / 'final', self.work / 'result', *options)

    def constant(self, threshold_m):
        return self.detect('--method', 'constant', '--threshold', threshold_m)

    def test_noise_is_several_times_larger_along_edges(self):
        near, far = measures.noise_by_edge_distance(Capture(self.work / 'initial'), (0, 3, 20, 60))[::2]
        self.assertGreater(near['over_time_rms_px'], 3 * far['over_time_rms_px'])
        self.assertGreater(near['wrong'], 10 * far['wrong'])

    def test_a_constant_threshold_trades_false_positives_for_the_key(self):
        low, high = self.constant(0.01), self.constant(0.05)
        self.assertTrue(low.found['flashlight'] and low.found['screwdriver'])
        self.assertFalse(high.found['key'])
        self.assertGreater(low.false_findings, 1.3 * high.false_findings)

    def test_gaussian_finds_all_three_and_loses_its_false_positives_with_frames(self):
        few, many = (self.detect('--method', 'gaussian', '--frames', frames) for frames in (10, 60))
        self.assertEqual(many.found, {'flashlight': True, 'screwdriver': True, 'key': True})
        self.assertLess(many.false_findings, 0.5 * few.false_findings)
        self.assertLessEqual(np.median(many.false_sizes_px or [0]), 3)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1], verbosity=2, warnings='ignore')
