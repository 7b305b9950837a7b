"""`rva detect --model`: what findings may be, by detectors in the layouts of YOLO and SSD.

usage: classify_test.py RVA
"""
import hashlib
import json

import numpy as np

import onnx_models
import program
from captures import Camera, IDENTITY, depth_fields, noisy, plain_color, with_box, write_capture, write_image

RED, GREEN, GREY = (230, 20, 20), (30, 240, 30), (120, 120, 120)
CAMERA = Camera(width=240, height=180, fx=220.0, fy=220.0, cx=120.0, cy=90.0)
# Columns and rows, and the colour after the work; the last touches the border.
THINGS = [((30, 20, 21, 21), RED), ((140, 30, 21, 21), GREEN), ((80, 120, 21, 21), GREY), ((219, 159, 21, 21), RED)]


class ClassifyTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        depth, picture = CAMERA.plane(1000), plain_color(CAMERA.width, CAMERA.height, (90, 90, 90))
        self.initial = write_capture(self.folder / 'before', noisy(depth, 10, 1, 1), depth=depth_fields(CAMERA))
        for (x, y, w, h), rgb in THINGS:
            depth = with_box(depth, (x, y, w, h), 60)
            picture[y:y + h, x:x + w] = rgb
        self.depth, self.picture = depth, picture
        self.final = self.write_final('after', pictures=[picture])
        self.labels = self.folder / 'labels.txt'
        self.labels.write_text('\n'.join(onnx_models.LABELS) + '\n')
        self.model = self.folder / 'detector.onnx'
        self.model.write_bytes(onnx_models.detector('yolo_columns'))

    def write_final(self, name, **keys):
        color = {'color': CAMERA.fields(), 'color_from_depth': IDENTITY} if keys.get('pictures') else {}
        return write_capture(self.folder / name, noisy(self.depth, 10, 1, 2), depth=depth_fields(CAMERA), **color, **keys)

    def detect(self, *more, final=None):
        return ['detect', self.initial, final or self.final, '--method', 'gaussian', '--out', self.out, '--overwrite', *more]

    def options(self, size=onnx_models.SIZE):
        return ['--model', self.model, '--labels', self.labels, '--model-width', size, '--model-height', size]

    def findings(self, *more, final=None):
        done = self.succeed(*self.detect(*more, final=final))
        return json.loads((self.out / 'detections.json').read_text()), done

    def by_place(self, result):
        return {tuple(finding['bbox'][:2]): finding for finding in result['detections']}

    def test_classes_of_all_layouts(self):
        for layout in ('yolo_rows', 'yolo_columns', 'ssd'):
            with self.subTest(layout):
                self.model.write_bytes(onnx_models.detector(layout))
                result, done = self.findings(*self.options())
                found = self.by_place(result)
                self.assertEqual(len(found), len(THINGS))
                for ((x, y, _, _), rgb) in THINGS:
                    expected = {RED: 'red', GREEN: 'green', GREY: 'unknown'}[rgb]
                    self.assertEqual(found[x, y]['class'], expected, found[x, y])
                    self.assertIn(f'finding {found[x, y]["id"]} may be: {expected}', done.stdout)
                # The cell in the middle of the surroundings is of the thing's colour alone.
                self.assertAlmostEqual(found[30, 20]['probability'], (RED[0] - RED[1]) / 255, delta=0.1)
                stated = result['classification']
                self.assertEqual((stated['model'], stated['classes'], stated['picture']), ('detector.onnx', 2, 'color'))
                self.assertEqual(stated['sha256'], hashlib.sha256(self.model.read_bytes()).hexdigest())

    def test_a_class_hides_no_finding_and_changes_nothing_else(self):
        plain, _ = self.findings()
        classified, _ = self.findings(*self.options())
        for finding in classified['detections']:
            finding.pop('class'), finding.pop('probability', None)
        self.assertEqual(classified['detections'], plain['detections'])

    def test_less_probable_classes_are_unknown(self):
        result, _ = self.findings(*self.options(), '--class-certainty', 0.9)
        found = self.by_place(result)
        self.assertEqual(found[30, 20]['class'], 'unknown')
        self.assertLess(found[30, 20]['probability'], 0.9)
        result, _ = self.findings(*self.options(), '--class-certainty', 0.6)
        self.assertEqual(self.by_place(result)[30, 20]['class'], 'red')

    def test_without_color_the_infrared_images_are_shown(self):
        final = self.write_final('dark', infrared={'scale': 256, 'frames': 1})
        file = final / 'infrared' / '000000.png'
        write_image(file, np.full((CAMERA.height, CAMERA.width), 100 * 256, np.uint16))
        result, _ = self.findings(*self.options(), final=final)
        self.assertEqual(result['classification']['picture'], 'infrared')
        self.assertEqual({finding['class'] for finding in result['detections']}, {'unknown'}, 'grey is neither')

    def test_without_any_image_there_are_no_classes_but_a_warning(self):
        result, done = self.findings(*self.options(), final=self.write_final('blind'))
        self.assertEqual(len(result['detections']), len(THINGS))
        self.assertNotIn('classification', result)
        self.assertNotIn('class', result['detections'][0])
        self.assertIn('neither colour nor infrared images', done.stderr)

    def test_what_is_no_model_or_another_one_is_refused(self):
        whole = self.model.read_bytes()
        for damaged in (b'', b'none', whole[:len(whole) // 2], b'\x00' * 500):
            self.model.write_bytes(damaged)
            self.check_fails(*self.detect(*self.options()), names=['detector.onnx', 'ONNX'])
        self.model.write_bytes(whole)
        self.check_fails(*self.detect(*self.options(size=96)), names=['detector.onnx', '96x96'])
        for count in (1, 3):
            self.labels.write_text('\n'.join(f'class {i}' for i in range(count)))
            self.check_fails(*self.detect(*self.options()), names=['detector.onnx', f'{count} classes', '1x6x16'])
        self.labels.write_text('red\nred\n')
        self.check_fails(*self.detect(*self.options()), names=['labels.txt', 'line 2'])
        self.model.unlink()
        self.labels.write_text('red\ngreen\n')
        self.check_fails(*self.detect(*self.options()), names=['detector.onnx'])

    def test_model_and_labels_belong_together(self):
        for options in (['--model', self.model], ['--labels', self.labels], ['--class-certainty', 0.5],
                        [*self.options(), '--class-certainty', 2]):
            done = self.rva(*self.detect(*options))
            self.assertEqual(done.returncode, 2, options)
            self.check_line(done.stderr, ['--'])


if __name__ == '__main__':
    program.main()
