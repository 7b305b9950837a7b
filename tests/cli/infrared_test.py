"""Infrared images as evidence, from captures to findings.

usage: infrared_test.py RVA
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

DITHER, FRAMES = 8, 3
FEWEST = 4  # captures of a side whose infrared images are compared


class InfraredTest(program.ProgramTest):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix='rva-test-')
        cls.addClassCleanup(temporary.cleanup)
        cls.recorded = pathlib.Path(temporary.name)
        for seed, (side, scene) in enumerate(write_bays(cls.recorded, '{ ambient: 0.02, visible: 0 }').items()):
            captures = FEWEST if side == 'unchanged' else DITHER
            subprocess.run([program.PROGRAM, 'record', '--camera', f'sim:{scene}', '--frames', str(FRAMES), '--dither',
                            str(captures), '--seed', str(seed), '--out', cls.recorded / side], check=True, capture_output=True)

    def setUp(self):
        super().setUp()
        self.before, self.unchanged, self.after = (self.own_copy(side) for side in ('before', 'unchanged', 'after'))

    def own_copy(self, side):
        shutil.copytree(self.recorded / side, self.folder / side)
        return sorted((self.folder / side).iterdir())

    def take_fewest(self):
        """For tests of what is compared, not of what is found."""
        self.before, self.after = self.before[:FEWEST], self.after[:FEWEST]

    def compare(self, initial, final):
        done = self.succeed('detect', '--initial', *initial, '--final', *final, '--out', self.out, '--overwrite')
        return json.loads((self.out / 'detections.json').read_text()), done.stderr

    def test_both_imagers_show_that_the_surface_moved(self):
        result, _ = self.compare(self.before, self.after)
        findings = result['detections']
        self.assertGreaterEqual(len(findings), 4, 'of five collars')
        moved = [finding for finding in findings if 'depth' in finding['evidence']]
        self.assertGreaterEqual(len(moved), 4)
        for finding in moved:
            self.assertIn(finding['kind'], ('added', 'removed'), finding)
        self.assertGreater(sum(finding['kind'] == 'added' for finding in moved), len(moved) / 2)

    def test_they_show_what_depth_does_not(self):
        for capture in self.before + self.after:
            shutil.rmtree(capture / 'infrared_right')
        result, _ = self.compare(self.before, self.after)
        self.assertGreater(result['coverage']['appearance'], 0.3)
        findings = result['detections']
        self.assertGreaterEqual(len(findings), 3, 'of five collars')
        for finding in findings:
            self.assertEqual(finding['kind'] == 'appearance', finding['evidence'] == ['appearance'], finding)
        alone = [finding['kind'] == 'appearance' for finding in findings]
        self.assertEqual(alone, sorted(alone), 'findings of appearance alone come last')
        self.assertIn(True, alone)
        self.assertEqual([finding['id'] for finding in findings], list(range(1, len(findings) + 1)))
        changes = cv2.imread(str(self.out / 'changes.png'), cv2.IMREAD_UNCHANGED)
        for finding in findings:
            x, y, width, height = finding['bbox']
            self.assertEqual(changes[y:y + height, x:x + width].max(), 255)
        for capture in self.before + self.after:
            shutil.rmtree(capture / 'infrared')
        by_depth, _ = self.compare(self.before, self.after)
        self.assertNotIn('appearance', by_depth['coverage'])
        self.assertLess(len(by_depth['detections']), len(findings))
        self.assertNotIn('evidence', json.dumps(by_depth))

    def test_where_nothing_changed_they_show_nothing(self):
        result, _ = self.compare(self.before[:FEWEST], self.unchanged)
        self.assertEqual([finding for finding in result['detections'] if finding['kind'] == 'appearance'], [])

    def test_a_side_without_them_is_compared_by_depth_with_a_warning(self):
        self.take_fewest()
        shutil.rmtree(self.after[2] / 'infrared')
        result, said = self.compare(self.before, self.after)
        self.assertIn('not every capture has infrared images: depth alone was compared', said)
        self.assertNotIn('appearance', result['coverage'])

    def test_fewer_than_four_captures_leave_too_much_under_dots(self):
        result, said = self.compare(self.before[:FEWEST - 1], self.after[:FEWEST - 1])
        self.assertNotIn('appearance', result['coverage'])
        self.assertNotIn('infrared', said)

    def test_single_frames_of_8_bits_count_like_their_mean(self):
        random = np.random.default_rng(1)
        for capture in self.before + self.after:
            file = capture / 'infrared' / '000000.png'
            mean = cv2.imread(str(file), cv2.IMREAD_UNCHANGED) / 256
            for frame in range(FRAMES):
                noisy = np.floor(mean + random.uniform(size=mean.shape))
                cv2.imwrite(str(file.with_stem(f'{frame:06}')), noisy.clip(0, 255).astype('uint8'))
            self.describe(capture, infrared=None)
        result, _ = self.compare(self.before, self.after)
        self.assertGreaterEqual(len(result['detections']), 3)

    def test_images_that_show_no_dots_or_are_saturated_are_named_and_not_compared(self):
        self.take_fewest()
        file = self.after[2] / 'infrared' / '000000.png'
        dots = cv2.imread(str(file), cv2.IMREAD_UNCHANGED)
        without = cv2.GaussianBlur(cv2.erode(dots, np.ones((15, 15))), (0, 0), 5)
        grain = np.random.default_rng(1).normal(0, 40, dots.shape)
        for pixels, problem in ((without + grain, 'was the projector on?'), (np.zeros(dots.shape), 'was the projector on?'),
                                (np.full(dots.shape, 65280.0), 'lower the exposure')):
            cv2.imwrite(str(file), pixels.clip(0, 65535).astype('uint16'))
            result, said = self.compare(self.before, self.after)
            self.assertIn('infrared image of final capture 3', said)
            self.assertIn(problem, said)
            self.assertNotIn('appearance', result['coverage'])

    def test_another_exposure_is_no_change_and_hides_none(self):
        def exposed(captures, factor):
            for capture in captures:
                for file in capture.glob('infrared*/*.png'):
                    image = cv2.imread(str(file), cv2.IMREAD_UNCHANGED)
                    cv2.imwrite(str(file), (image * factor).astype('uint16'))
        exposed(self.unchanged + self.after, 0.4)
        self.assertEqual(self.compare(self.before[:FEWEST], self.unchanged)[0]['detections'], [])
        self.assertGreaterEqual(len(self.compare(self.before, self.after)[0]['detections']), 4, 'of five collars')

    def test_one_imager_alone_is_compared_or_the_reason_is_stated(self):
        self.take_fewest()
        for capture in self.before + self.after:
            shutil.move(capture / 'infrared_right', capture / 'kept')
        result, said = self.compare(self.before, self.after)
        self.assertIn('appearance', result['coverage'])
        self.assertNotIn('imager', said)
        for capture in self.before + self.after:
            shutil.rmtree(capture / 'infrared')
            shutil.move(capture / 'kept', capture / 'infrared_right')
        result, said = self.compare(self.before, self.after)
        self.assertNotIn('appearance', result['coverage'])
        self.assertIn('right imager alone', said)

    def test_bursts_of_other_lengths_are_compared(self):
        for capture in self.after:
            for file in sorted((capture / 'depth').iterdir())[2:]:
                file.unlink()
        result, _ = self.compare(self.before, self.after)
        self.assertIn('appearance', result['coverage'])
        self.assertGreaterEqual(len(result['detections']), 4, 'of five collars')

    def test_images_of_another_size_are_refused(self):
        file = self.after[1] / 'infrared_right' / '000000.png'
        cv2.imwrite(str(file), cv2.imread(str(file), cv2.IMREAD_UNCHANGED)[::2, ::2])
        self.check_fails('detect', '--initial', *self.before, '--final', *self.after, '--out', self.out,
                         names=['infrared_right', '424x240'])

    def test_a_lens_that_bends_rays_is_compared_by_depth_with_a_warning(self):
        self.take_fewest()
        for capture in self.before + self.after:
            depth = json.loads((capture / 'capture.json').read_text())['depth']
            self.describe(capture, depth={**depth, 'distortion_model': 'brown_conrady', 'distortion': [0.05, -0.02, 0, 0, 0]})
        result, said = self.compare(self.before, self.after)
        self.assertNotIn('appearance', result['coverage'])
        self.assertIn('lens distortion is not supported', said)

    def test_a_scale_that_cannot_be_is_refused(self):
        for bad in ({'scale': 0}, {'scale': 256, 'frames': 1e300}, {'scale': 256, 'frames': 0}):
            for light in ('infrared', 'lamp'):
                self.describe(self.after[-1], **{'infrared': {'scale': 256, 'frames': FRAMES}, light: bad})
                self.check_fails('info', self.after[-1], names=[f'{light}.{list(bad)[-1]}'])

    def describe(self, capture, **changes):
        file = capture / 'capture.json'
        description = {**json.loads(file.read_text()), **changes}
        file.write_text(json.dumps({key: value for key, value in description.items() if value is not None}))


class LampTest(program.ProgramTest):
    """Three of the smallest collars between rivets, which show neither in depth nor between the projector's dots."""
    SCENE = pathlib.Path(__file__).parents[2] / 'data' / 'scenes' / 'three-smallest-collars.yaml'
    CAPTURES = 2

    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix='rva-test-')
        cls.addClassCleanup(temporary.cleanup)
        cls.recorded = pathlib.Path(temporary.name)
        clean = cls.recorded / 'clean.yaml'
        clean.write_text(cls.SCENE.read_text().split('debris:')[0])
        for seed, (side, scene) in enumerate({'before': clean, 'after': cls.SCENE}.items()):
            subprocess.run([program.PROGRAM, 'record', '--camera', f'sim:{scene}', '--frames', '5', '--dither', str(cls.CAPTURES),
                            '--seed', str(seed), '--lamp', '--out', cls.recorded / side], check=True, capture_output=True)

    def setUp(self):
        super().setUp()
        shutil.copytree(self.recorded, self.folder, dirs_exist_ok=True)
        self.before, self.after = (sorted((self.folder / side).iterdir()) for side in ('before', 'after'))
        for capture in self.before + self.after:
            shutil.rmtree(capture / 'color')

    def compare(self):
        done = self.succeed('detect', '--initial', *self.before, '--final', *self.after, '--out', self.out, '--overwrite')
        return json.loads((self.out / 'detections.json').read_text())['detections'], done.stderr

    def test_it_shows_three_of_the_smallest_collars(self):
        findings, said = self.compare()
        self.assertEqual(len(findings), 3)
        self.assertNotIn('lamp', said)
        for capture in self.before + self.after:
            shutil.rmtree(capture / 'lamp')
        self.assertLess(len(self.compare()[0]), 3)

    def test_a_lamp_that_did_not_switch_is_named(self):
        lamp = self.after[1] / 'lamp' / 'infrared' / '000000.png'
        light = cv2.imread(str(lamp), cv2.IMREAD_UNCHANGED)
        for pixels, problem in ((light // 200, 'dark'), (np.full_like(light, 65280), 'saturated'),
                                (cv2.imread(str(self.after[1] / 'infrared' / '000000.png'), cv2.IMREAD_UNCHANGED), 'dots')):
            cv2.imwrite(str(lamp), pixels)
            findings, said = self.compare()
            self.assertIn(problem, said)
            self.assertIn('final capture 2', said)
            self.assertLess(len(findings), 3)

    def test_a_side_without_it_is_compared_by_depth_with_a_warning(self):
        shutil.rmtree(self.before[0] / 'lamp')
        self.assertIn('not every capture has images under the lamp', self.compare()[1])

    def test_a_replayed_burst_is_the_same(self):
        again = self.folder / 'again'
        self.succeed('record', '--camera', f'replay:{self.after[0]}', '--frames', 5, '--lamp', '--out', again)
        for image in ('lamp/infrared/000000.png', 'lamp/infrared_right/000000.png', 'infrared_right/000000.png'):
            self.assertEqual((again / image).read_bytes(), (self.after[0] / image).read_bytes(), image)

    def test_a_camera_without_a_lamp_is_refused(self):
        shutil.rmtree(self.after[0] / 'lamp')
        refused = self.rva('record', '--camera', f'replay:{self.after[0]}', '--lamp', '--out', self.out)
        self.assertEqual(refused.returncode, 2, refused.stderr)
        self.assertIn('has no lamp', refused.stderr)


if __name__ == '__main__':
    program.main()
