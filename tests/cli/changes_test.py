"""`rva detect` on what people compare: things that were exchanged or moved, other tools' values for no depth, regions
that do not matter, the wrong baseline.

usage: changes_test.py RVA
"""
import json

import numpy as np

import program
from captures import Camera, noisy, with_box, write_capture, write_image

CAMERA = Camera(160, 120, 150.0, 150.0, 79.5, 59.5)
FRAMES = 6
GONE, COME = (60, 40, 24, 30), (84, 44, 20, 24)
METHODS = ('auto', 'constant', 'gaussian')


def bench():
    """A table that is a little tilted, at 0.9 m."""
    return CAMERA.plane(900, per_column=0.3)


class ChangesTest(program.ProgramTest):
    def write(self, name, surface, seed=1, replace=None, **keys):
        frames = noisy(surface, FRAMES, 1.0, seed)
        if replace is not None:
            frames[frames == 0] = replace
        depth_fields = {**CAMERA.fields(), 'unit_m': 0.001, **keys.pop('depth', {})}
        return write_capture(self.folder / name, frames, depth=depth_fields, **keys)

    def kinds_and_boxes(self, result):
        return {(f['kind'], tuple(f['bbox'])) for f in result['detections']}


class Exchanged(ChangesTest):
    def setUp(self):
        super().setUp()
        self.before = self.write('before', with_box(bench(), GONE, 25), 1)
        self.after = self.write('after', with_box(bench(), COME, 40), 2)

    def test_what_came_nearer_and_what_went_farther_are_two_findings(self):
        for join in (0, 30, 1000):
            with self.subTest(join=join):
                result = self.detect(self.before, self.after, '--join', join, out=self.folder / f'join{join}')
                self.assertEqual(self.kinds_and_boxes(result), {('removed', GONE), ('added', COME)})
                heights = {f['kind']: f['height_mm'] for f in result['detections']}
                self.assertAlmostEqual(heights['removed'], -25, delta=2)
                self.assertAlmostEqual(heights['added'], 40, delta=2)
                self.assertFalse(any('moved_from' in f for f in result['detections']), 'of another size')

    def test_the_other_way_round_too(self):
        result = self.detect(self.after, self.before)
        self.assertEqual(self.kinds_and_boxes(result), {('removed', COME), ('added', GONE)})

    def test_the_methods_of_the_thesis_report_what_came_nearer(self):
        for method in ('constant', 'gaussian'):
            result = self.detect(self.before, self.after, '--method', method, '--threshold', 0.02, out=self.folder / method)
            self.assertEqual(self.kinds_and_boxes(result), {('added', COME)})


class Moved(ChangesTest):
    def test_an_object_that_was_moved_is_recognised_by_its_size(self):
        for number, there in enumerate([(80, 40, 20, 14), (100, 70, 20, 14), (100, 70, 14, 20)]):
            before = self.write(f'before{number}', with_box(bench(), (60, 40, 20, 14), 30), 3)
            after = self.write(f'after{number}', with_box(bench(), there, 30), 4)
            done = self.succeed('detect', before, after, '--out', self.folder / f'out{number}')
            found = json.loads((self.folder / f'out{number}' / 'detections.json').read_text())['detections']
            by_kind = {f['kind']: f for f in found}
            self.assertEqual(len(found), 2)
            self.assertEqual(by_kind['added']['moved_from'], by_kind['removed']['id'])
            self.assertNotIn('moved_from', by_kind['removed'])
            self.assertIn('may be the same object, moved', done.stdout)


class NoDepth(ChangesTest):
    """Values that other tools write where nothing was measured; nothing changed."""

    def pair(self, value, **keys):
        before, after = bench(), bench()
        before[20:40, 40:70] = 0
        after[70:95, 90:120] = 0
        return (self.write(f'before{value}', before, 5, value, **keys), self.write(f'after{value}', after, 6, value, **keys))

    def check_nothing(self, result):
        self.assertEqual(result['detections'], [])
        self.assertAlmostEqual(result['coverage']['invalid'], 750 / 19200)
        self.assertAlmostEqual(result['coverage']['unseen'], 600 / 19200)

    def test_usual_ones_are_recognised_and_noted(self):
        for value in (65535, 10000, 8191, 32768):
            pair = self.pair(value)
            for method in METHODS:
                out = self.folder / f'{value}{method}'
                done = self.succeed('detect', *pair, '--method', method, '--clip', 100, '--out', out)
                self.check_nothing(json.loads((out / 'detections.json').read_text()))
                self.assertIn(f'initial capture: depth {value} stands for no measurement (3.1 %', done.stderr)
            self.assertIn(f'depth {value} stands for no measurement', str(self.info(pair[0])['notes']))

    def test_others_can_be_stated(self):
        pair = self.pair(4321)
        self.succeed('detect', '--no-depth', 4321, *pair, '--out', self.out)
        self.check_nothing(json.loads((self.out / 'detections.json').read_text()))
        stated = self.pair(4322, depth={'no_depth': [4322]})
        self.check_nothing(self.detect(*stated, out=self.folder / 'stated'))
        self.assertNotEqual(self.detect(*pair, out=self.folder / 'unstated')['detections'], [])

    def test_what_states_them_is_checked(self):
        for value in ('7', [-1], [65536], [1.5], ['1'], list(range(17))):
            capture = self.write('bad', bench(), depth={'no_depth': value})
            self.check_fails('info', capture, names=['depth.no_depth'])
        self.assertEqual(self.rva('info', capture, '--no-depth', '65536').returncode, 2)


class LeftOut(ChangesTest):
    def setUp(self):
        super().setUp()
        self.before = self.write('before', bench(), 7)
        self.after = self.write('after', with_box(with_box(bench(), (30, 30, 14, 12), 30), (110, 70, 14, 12), 30), 8)
        self.mask = np.zeros((CAMERA.height, CAMERA.width), np.uint8)
        self.mask[20:50, 20:60] = 255

    def check_one_is_left(self, result, share):
        self.assertEqual(self.kinds_and_boxes(result), {('added', (110, 70, 14, 12))})
        coverage = result['coverage']
        self.assertAlmostEqual(coverage['left_out'], share)
        self.assertAlmostEqual(sum(coverage.values()), 1, places=12)

    def test_by_a_mask_a_rectangle_or_polygons(self):
        write_image(self.folder / 'mask.png', self.mask)
        write_image(self.folder / 'colour.png', np.dstack([self.mask, 0 * self.mask, self.mask]))
        polygon = [[19.5, 19.5], [59.5, 19.5], [59.5, 49.5], [19.5, 49.5]]
        (self.folder / 'regions.json').write_text(
            json.dumps({'format': 'rva-regions', 'version': 1, 'ignore': [polygon]}))
        for number, options in enumerate([['--ignore', 'mask.png'], ['--ignore', 'colour.png'],
                                          ['--ignore', 'regions.json'],
                                          ['--ignore', 'mask.png', '--ignore', 'regions.json']]):
            for method in METHODS:
                out = self.folder / f'{method}{number}'
                with self.subTest(options=options, method=method):
                    self.check_one_is_left(self.detect(self.before, self.after, *options, '--method', method,
                                                       '--threshold', 0.02, '--min-blob', 20, out=out),
                                           1200 / 19200)

    def test_a_small_part_alone_is_judged_as_within_the_whole(self):
        done = self.succeed('detect', '--within', '105,65,24,22', self.before, self.after, '--out', self.out)
        self.check_one_is_left(json.loads((self.out / 'detections.json').read_text()), 1 - 24 * 22 / 19200)
        self.assertIn('left out as asked 97.2 %', done.stdout)
        both = self.detect(self.before, self.after, '--within', '105,65,24,22', '--within', '25,25,24,22',
                           out=self.folder / 'both')
        self.assertEqual(len(both['detections']), 2)

    def test_what_cannot_be_left_out_is_refused(self):
        write_image(self.folder / 'small.png', self.mask[:60])
        (self.folder / 'regions.json').write_text('{"format": "rva-regions", "version": 1, "ignore": [[[1, 2]]]}')
        (self.folder / 'text').write_text('no picture')
        for name in ('small.png', 'regions.json', 'text', 'none.png'):
            self.check_fails('detect', self.before, self.after, '--ignore', self.folder / name, '--out', self.out,
                             names=[name])
        for box in ('1,2,3', '1,2,0,4', '500,2,3,4', 'a,b,c,d', '1,2,3,4,5', '1,2,3,4,', '1;2;3;4', '1,2,3,2147483647000'):
            self.assertEqual(self.rva('detect', self.before, self.after, '--within', box, '--out', self.out).returncode, 2,
                             box)


class WrongBaseline(ChangesTest):
    def test_another_camera(self):
        pair = [self.write(serial, bench(), int(serial), camera={'serial': serial, 'baseline_m': 0.05}) for serial in ('123', '456')]
        self.check_fails('detect', *pair, '--out', self.out, names=['different cameras', '123', '456'])

    def test_another_bay(self):
        other = CAMERA.plane(500, per_column=2.5)
        other[:, 80:] += 300
        pair = self.write('before', bench(), 10), self.write('after', other, 11)
        self.check_fails('detect', *pair, '--out', self.out, names=['do not show the same view'])
        done = self.succeed('detect', *pair, '--method', 'calibrated', '--out', self.out)
        self.assertIn('do not show the same view', done.stderr)


if __name__ == '__main__':
    program.main()
