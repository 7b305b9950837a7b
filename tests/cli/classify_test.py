"""`rva detect --model` and `--classify`: what findings may be, by detectors in the layouts of YOLO and SSD, by the
classifier that comes with the program, and by one of a user's own.

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

    def test_the_classifier_of_the_program_hides_nothing(self):
        plain, _ = self.findings()
        classified, done = self.findings('--classify')
        stated = classified['classification']
        self.assertEqual((stated['model'], stated['picture']), ('findings.onnx', 'color'))
        for finding in classified['detections']:
            self.assertIn(f'finding {finding["id"]} may be: {finding["class"]}', done.stdout)
            probability = finding.pop('probability')
            self.assertEqual(finding.pop('class') == 'unknown', probability < stated['class_certainty'])
        self.assertEqual(classified['detections'], plain['detections'])

    def test_the_classifier_of_the_program_needs_no_picture(self):
        result, done = self.findings('--classify', final=self.write_final('blind'))
        self.assertEqual(result['classification']['picture'], 'none')
        self.assertTrue(all('class' in finding for finding in result['detections']))
        self.assertNotIn('neither colour nor infrared', done.stderr)

    def test_a_removed_object_gets_no_class(self):
        self.succeed('detect', self.final, self.initial, '--method', 'calibrated', '--classify', '--out', self.out)
        result = json.loads((self.out / 'detections.json').read_text())
        self.assertEqual({finding['kind'] for finding in result['detections']}, {'removed'})
        self.assertFalse(any('class' in finding for finding in result['detections']))

    def write_card(self, weights, **changes):
        """A classifier whose outputs are weighted means of planes: 0 is red, 1 green."""
        model = onnx_models.classifier(weights)
        (self.folder / 'own.onnx').write_bytes(model)
        card = {'format': 'rva-finding-model', 'version': 1, 'model': 'own.onnx',
                'sha256': hashlib.sha256(model).hexdigest(), 'planes': 14, 'plane_px': 48, 'labels': ['red', 'green'],
                'temperature': 1.0, 'least_probability': 0.5} | changes
        (self.folder / 'own.json').write_text(json.dumps({key: value for key, value in card.items() if value is not None}))
        return self.folder / 'own.json'

    def test_a_classifier_of_ones_own(self):
        weights = [{0: 30.0, 1: -30.0}, {0: -30.0, 1: 30.0}, {3: 2.0}]
        result, _ = self.findings('--classifier', self.write_card(weights))
        found = self.by_place(result)
        for ((x, y, _, _), rgb) in THINGS[:3]:
            expected = {RED: 'red', GREEN: 'green', GREY: 'unknown'}[rgb]
            self.assertEqual(found[x, y]['class'], expected, found[x, y])
        self.assertEqual(result['classification']['sha256'], hashlib.sha256((self.folder / 'own.onnx').read_bytes()).hexdigest())
        sharp = found[30, 20]['probability']
        result, _ = self.findings('--classifier', self.write_card(weights, temperature=10.0))
        self.assertLess(self.by_place(result)[30, 20]['probability'], sharp)
        result, _ = self.findings('--classifier', self.write_card(weights, least_probability=1.0))
        self.assertEqual({finding['class'] for finding in result['detections']}, {'unknown'})

    def test_a_card_that_does_not_fit_is_refused(self):
        weights = [{0: 1.0}, {1: 1.0}, {2: 1.0}]
        for changes, names in (({'format': 'other'}, ['format']), ({'version': 2}, ['version']),
                               ({'planes': 13}, ['planes']), ({'labels': ['red', 'red']}, ['labels', 'twice']),
                               ({'labels': []}, ['labels']), ({'labels': ['red']}, ['own.onnx', '3 outputs']),
                               ({'labels': ['red', 'green', 'blue']}, ['own.onnx', '3 outputs']),
                               ({'temperature': 0}, ['temperature']), ({'least_probability': 1.5}, ['least_probability']),
                               ({'sha256': '0' * 64}, ['sha256', 'own.onnx']), ({'model': '../own.onnx'}, ['model']),
                               ({'model': 'missing.onnx'}, ['missing.onnx']), ({'temperature': None}, ['temperature'])):
            with self.subTest(changes):
                self.check_fails(*self.detect('--classifier', self.write_card(weights, **changes)), names=names)
        self.check_fails(*self.detect('--classifier', self.folder / 'none.json'), names=['none.json'])
        endless = self.write_card([{0: float('inf')}, {1: 1.0}, {2: 1.0}])
        self.check_fails(*self.detect('--classifier', endless), names=['own.onnx', 'no numbers'])
        card = self.write_card(weights)
        model = onnx_models.classifier(weights, planes=3)
        (self.folder / 'own.onnx').write_bytes(model)
        card.write_text(json.dumps(json.loads(card.read_text()) | {'sha256': hashlib.sha256(model).hexdigest()}))
        self.check_fails(*self.detect('--classifier', card), names=['own.onnx', '14 planes'])

    def test_only_one_model_is_taken(self):
        for options in (['--classify', *self.options()], ['--classify', '--classifier', self.model],
                        ['--classifier', self.model, *self.options()]):
            done = self.rva(*self.detect(*options))
            self.assertEqual(done.returncode, 2, options)


if __name__ == '__main__':
    program.main()
