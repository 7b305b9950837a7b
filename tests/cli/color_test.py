"""Colour images as evidence where there is light, from captures to findings.

usage: color_test.py RVA
"""
import json
import pathlib
import shutil
import subprocess
import tempfile

import cv2
import numpy as np
import program
from simulations import write_bays

DITHER, FRAMES = 3, 4


class ColorTest(program.ProgramTest):
    """A robot that came back, without infrared images."""

    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix='rva-test-')
        cls.addClassCleanup(temporary.cleanup)
        cls.recorded = pathlib.Path(temporary.name)
        for seed, (side, scene) in enumerate(write_bays(cls.recorded, '{ ambient: 0.02 }').items()):
            take = [program.PROGRAM, 'record', '--camera', f'sim:{scene}', '--frames', str(FRAMES), '--seed', str(seed), '--out']
            subprocess.run([*take, cls.recorded / side, '--dither', str(DITHER)], check=True, capture_output=True)
            subprocess.run([*take, cls.recorded / 'still' / side], check=True, capture_output=True)
        for infrared in cls.recorded.rglob('infrared*'):
            shutil.rmtree(infrared)

    def setUp(self):
        super().setUp()
        self.before, self.unchanged, self.after = (self.own_copy(side) for side in ('before', 'unchanged', 'after'))

    def own_copy(self, side):
        shutil.copytree(self.recorded / side, self.folder / side)
        return sorted((self.folder / side).iterdir())

    def compare(self, initial, final):
        done = self.succeed('detect', '--initial', *initial, '--final', *final, '--out', self.out, '--overwrite')
        return json.loads((self.out / 'detections.json').read_text()), done.stderr

    def images(self, captures):
        return sorted(file for capture in captures for file in (capture / 'color').iterdir())

    def by_color(self, result):
        return [finding for finding in result['detections'] if 'appearance' in finding.get('evidence', [])]

    def test_they_show_what_depth_does_not(self):
        result, said = self.compare(self.before, self.after)
        self.assertGreaterEqual(len(self.by_color(result)), 4, 'of five collars')
        self.assertGreater(result['coverage']['appearance'], 0.3)
        self.assertNotIn('compared', said)
        for file in self.images(self.before + self.after):
            file.unlink()
        by_depth, _ = self.compare(self.before, self.after)
        self.assertNotIn('appearance', by_depth['coverage'])
        self.assertLess(len(by_depth['detections']), len(result['detections']))

    def test_where_nothing_changed_they_show_nothing(self):
        result, _ = self.compare(self.before, self.unchanged)
        self.assertEqual(self.by_color(result), [])

    def test_a_camera_that_stood_still_is_compared_with_one_capture_a_side(self):
        before, unchanged, after = ([self.recorded / 'still' / side] for side in ('before', 'unchanged', 'after'))
        result, _ = self.compare(before, after)
        self.assertGreaterEqual(len(self.by_color(result)), 4, 'of five collars')
        self.assertEqual(self.by_color(self.compare(before, unchanged)[0]), [])

    def test_another_exposure_is_no_change_and_hides_none(self):
        for file in self.images(self.unchanged + self.after):
            linear = (cv2.imread(str(file)) / 255.0) ** 2.2
            cv2.imwrite(str(file), (255 * (0.7 * linear) ** (1 / 2.2)).round().astype('uint8'))
        self.assertEqual(self.by_color(self.compare(self.before, self.unchanged)[0]), [])
        self.assertGreaterEqual(len(self.by_color(self.compare(self.before, self.after)[0])), 4, 'of five collars')

    def test_images_of_a_dark_bay_are_not_compared(self):
        for file in self.images(self.before + self.after):
            cv2.imwrite(str(file), cv2.imread(str(file)) // 40)
        result, said = self.compare(self.before, self.after)
        self.assertNotIn('appearance', result['coverage'])
        self.assertNotIn('compared', said)

    def test_an_image_that_cannot_be_read_is_named_and_depth_is_compared(self):
        damaged = self.images(self.after)[-1]
        damaged.write_bytes(damaged.read_bytes()[:500])
        result, said = self.compare(self.before, self.after)
        self.assertIn('the colour images were not compared', said)
        self.assertIn(damaged.name, said)
        self.assertNotIn('appearance', result['coverage'])

    def test_captures_without_them_leave_depth(self):
        shutil.rmtree(self.after[1] / 'color')
        result, _ = self.compare(self.before, self.after)
        self.assertNotIn('appearance', result['coverage'])

    def test_light_that_changed_is_named(self):
        after = self.folder / 'shaded'
        shutil.copytree(self.recorded / 'still' / 'after', after)
        for file in self.images([after]):
            image = cv2.imread(str(file)).astype(float)
            image[:, image.shape[1] * 2 // 3:] *= 0.7
            cv2.imwrite(str(file), image.astype('uint8'))
        result, said = self.compare([self.recorded / 'still' / 'before'], [after])
        self.assertIn('as when the lighting changed', said)
        self.assertNotIn('appearance', result['coverage'])


if __name__ == '__main__':
    program.main()
