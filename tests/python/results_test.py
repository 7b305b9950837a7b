"""Python gives what the program gives, to the byte."""
import inspect
import json
import re
import subprocess
import sys

import scenes

import rva

MILLISECONDS = re.compile(rb'("(?:load|statistics|detect|regions|total)": )[0-9.e+-]+')


def without_times(files):
    return {name: MILLISECONDS.sub(rb'\1', content) for name, content in files.items()}


class Results(scenes.Captured):
    def check_same(self, name, arguments, flags):
        with self.subTest(name):
            by_program, by_python = self.folder / f'{name}-program', self.folder / f'{name}-python'
            self.succeed('detect', self.before, self.after, '--out', by_program, *flags)
            result = rva.detect(self.before, str(self.after), out=by_python, **arguments)
            expected = without_times(scenes.contents(by_program))
            self.assertIn('detections.json', expected)
            self.assertEqual(without_times(scenes.contents(by_python)), expected)
            self.assertEqual(result.json.encode(), (by_python / 'detections.json').read_bytes())
            return result

    def test_detections_are_those_of_the_program(self):
        result = self.check_same('calibrated', {}, ())
        self.assertGreaterEqual(len(result), 3)
        self.check_same('constant', {'method': 'constant', 'threshold': 0.02, 'min_blob': 40},
                        ('--method', 'constant', '--threshold', '0.02', '--min-blob', '40'))
        named = self.check_same('named', {'classify': True, 'within': [(0, 0, 848, 480)], 'frames': 3},
                                ('--classify', '--within', '0,0,848,480', '--frames', 3))
        self.assertTrue(any(finding.class_name for finding in named))

    def test_open_captures_and_several_a_side(self):
        opened = rva.detect(rva.open(self.before), [rva.open(self.after)])
        self.assertEqual(opened.as_dict()['detections'], rva.detect(self.before, self.after).as_dict()['detections'])

    def test_a_result_is_saved_later(self):
        saved, at_once = self.folder / 'saved', self.folder / 'at-once'
        result = rva.detect(self.before, self.after, out=at_once)
        self.assertEqual(result.save(saved), [])
        self.assertEqual(scenes.contents(saved), scenes.contents(at_once))
        with self.assertRaisesRegex(rva.Error, 'already exists.* with overwrite=True$'):
            result.save(saved)
        result.save(saved, overwrite=True)

    def test_attributes_are_what_the_json_has(self):
        result = rva.detect(self.before, self.after)
        self.assertEqual(len(result.findings), len(result))
        for finding, entry in zip(result, result.as_dict()['detections'], strict=True):
            self.assertEqual((finding.id, finding.kind, list(finding.box), finding.area_px),
                             (entry['id'], entry['kind'], entry['bbox'], entry['area_px']))
            for name in ('score', 'p_value', 'height_mm', 'moved_from', 'top_above_surroundings_mm'):
                self.assertEqual(getattr(finding, name), entry.get(name), name)
            for name in ('position_m', 'size_mm'):
                self.assertEqual(list(getattr(finding, name) or ()), entry.get(name, []), name)

    def test_a_result_is_printed_in_words(self):
        result = rva.detect(self.before, self.after)
        lines = str(result).splitlines()
        self.assertEqual(lines[0], f'{len(result)} finding(s), method calibrated, {scenes.FRAMES} + {scenes.FRAMES} frames')
        for finding, line in zip(result, lines[1:]):
            self.assertEqual(line.strip(), str(finding))
            self.assertRegex(line, rf'^  {finding.id} {finding.kind}, [0-9.]+ x [0-9.]+ mm, ')
        self.assertRegex(str(result), r'compared [0-9.]+ % of the view')
        self.assertRegex(repr(result), r'^<rva.Detection: \d+ finding')

    def test_the_example_prints_the_findings(self):
        example = scenes.ROOT / 'examples' / 'detect.py'
        done = subprocess.run([sys.executable, example, self.before, self.after], capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        *findings, last = done.stdout.splitlines()
        self.assertEqual(len(findings), len(rva.detect(self.before, self.after)))
        self.assertRegex(last, r'^\d+\.\d\d % of the pixels changed$')
        refused = subprocess.run([sys.executable, example, self.before, '/none'], capture_output=True, text=True, timeout=120)
        self.assertEqual((refused.returncode, refused.stdout), (1, ''))
        self.assertRegex(refused.stderr, r'^detect: /none: .*; .*\n$')

    def test_simulated_captures_are_those_of_the_program(self):
        out = self.folder / 'simulated'
        capture = rva.simulate(scenes.SCENE, out, frames=scenes.FRAMES, seed=2, supersampling=scenes.SUPERSAMPLING)
        self.assertEqual(scenes.contents(out), scenes.contents(self.after))
        self.assertEqual(len(capture), scenes.FRAMES)

    def test_a_camera_model_keeps_what_is_given(self):
        by_program, by_python = self.folder / 'model-program', self.folder / 'model-python'
        self.succeed('simulate', scenes.SCENE, '--out', by_program, '--frames', 1, '--camera-model', 'correlation-5',
                     '--supersampling', 1, '--pan', 3, '--position', '0,0.12,0')
        rva.simulate(scenes.SCENE, by_python, frames=1, camera_model='correlation-5', supersampling=1, pan=3,
                     position=(0, 0.12, 0))
        self.assertEqual(scenes.contents(by_python), scenes.contents(by_program))

    def test_info_and_noise_are_those_of_the_program(self):
        self.assertEqual(rva.info(self.before), json.loads(self.succeed('info', self.before, '--json')))
        by_program, by_python = self.folder / 'noise-program', self.folder / 'noise-python'
        self.succeed('noise', self.before, '--out', by_program, '--bin', 0.5)
        measured = rva.noise(rva.open(self.before), out=by_python, bin=0.5)
        self.assertEqual(scenes.contents(by_python), scenes.contents(by_program))
        self.assertEqual(measured.as_dict(), json.loads((by_program / 'noise.json').read_text()))

    def test_exports_are_those_of_the_program(self):
        for form in ('ply', 'pcd', 'mcap', 'open3d'):
            with self.subTest(form):
                by_program, by_python = self.folder / f'program.{form}', self.folder / f'python.{form}'
                self.succeed('export', self.before, '--to', form, '--out', by_program)
                self.assertEqual(rva.export(self.before, form, by_python), [])
                if form == 'open3d':
                    self.assertEqual(scenes.contents(by_python), scenes.contents(by_program))
                else:
                    self.assertEqual(by_python.read_bytes(), by_program.read_bytes())
                with self.assertRaisesRegex(rva.Error, 'already exists.* with overwrite=True$'):
                    rva.export(rva.open(self.before), form, by_python)
                rva.export(rva.open(self.before), form, by_python, overwrite=True)

    def test_each_option_of_the_program_is_a_keyword_with_its_default(self):
        printed = self.succeed('options')
        for command, function in (('detect', rva.detect), ('noise', rva.noise), ('simulate', rva.simulate),
                                  ('calibrate', rva.calibrate)):
            section = printed.partition(f'\n## `rva {command}`\n')[2].partition('\n## ')[0]
            rows = re.findall(r'^\| `--([a-z0-9-]+)` \| (\S+)', section, re.MULTILINE)
            self.assertGreaterEqual(len(rows), 3)
            keywords = inspect.signature(function).parameters
            for option, default in rows:
                if command == 'noise' and option not in ('frames', 'welch-frames', 'alpha', 'bin'):
                    continue  # of rva noise --camera, which checks a camera
                value = keywords[option.replace('-', '_')].default
                self.assertAlmostEqual(float(value), float({'true': 1, 'false': 0}.get(default, default)))
                self.assertIn(f'  {option.replace("-", "_")}: ', function.__doc__)

    def test_version(self):
        self.assertEqual(rva.__version__ + '\n', self.succeed('--version'))


if __name__ == '__main__':
    scenes.main()
