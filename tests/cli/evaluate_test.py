"""`rva evaluate` from end to end.

usage: evaluate_test.py RVA
"""
import json
import os

import program
from simulations import TOOLS


class EvaluateTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        # Evaluations are compared as a whole, with the time that they state.
        os.environ['SOURCE_DATE_EPOCH'] = '1767225600'
        self.addCleanup(os.environ.pop, 'SOURCE_DATE_EPOCH')

    def evaluate(self, *options):
        done = self.succeed('evaluate', '--out', self.out, '--inspections', 1, '--frames', '2,3', *options)
        return done, json.loads((self.out / 'evaluation.json').read_text())

    def test_a_scene_of_ones_own(self):
        done, report = self.evaluate('--scene', TOOLS, '--first-seed', 5)
        self.assertEqual((report['format'], report['version']), ('rva-evaluation', 1))
        (inspection,) = report['inspections']
        self.assertEqual(inspection['seed'], 5)
        self.assertEqual(sorted(target['kind'] for target in inspection['targets']),
                         ['flashlight', 'key', 'screwdriver'])
        made = report['provenance']
        self.assertEqual((made['program'], made['created_at'], made['input']),
                         ('rva', '2026-01-01T00:00:00.000Z', str(TOOLS)))
        self.assertEqual({tally['frames'] for tally in report['tallies']}, {2, 3})
        self.assertEqual({tally['method'] for tally in report['tallies']}, {'constant', 'gaussian', 'calibrated'})
        for tally in report['tallies']:
            low, high = tally['found_share_95']
            self.assertLessEqual(low, tally['found'] / tally['targets'])
            self.assertLessEqual(tally['found'] / tally['targets'], high)
        best = [tally for tally in report['tallies'] if tally['method'] == 'calibrated' and tally['setting'] == 0.05]
        self.assertTrue(all(tally['found'] >= 2 for tally in best), 'a flashlight and a screwdriver are plain')
        rows = [line for line in done.stdout.splitlines() if line.startswith(('2  ', '3  '))]
        self.assertEqual(len(rows), 3 * len(report['tallies']), 'three tables, since all columns are too many for one')
        self.assertLessEqual(max(map(len, done.stdout.splitlines()[:-1])), 100)

    def test_same_seeds_same_figures_also_where_it_was_interrupted(self):
        def run(inspections, *options):
            self.succeed('evaluate', '--out', self.out, '--inspections', inspections, '--frames', '2', '--scene',
                         TOOLS, *options)
            return json.loads((self.out / 'evaluation.json').read_text())
        whole = run(2)
        run(1, '--overwrite')
        self.assertEqual(run(2, '--resume'), whole)
        others = ['evaluate', '--out', self.out, '--inspections', 3, '--resume']
        for options in (['--frames', '3', '--scene', TOOLS], ['--frames', '2', '--scene', TOOLS, '--first-seed', 9],
                        ['--frames', '2'], ['--frames', '2', '--scene', TOOLS, '--overwrite']):
            with self.subTest(options):
                done = self.rva(*others, *options)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.check_line(done.stderr, ['--resume'])
        self.assertEqual(json.loads((self.out / 'evaluation.json').read_text()), whole)

    def test_a_robot_that_was_put_back_elsewhere(self):
        done = self.succeed('evaluate', '--moved', '--captures', '1,2', '--allowed', '0.05,0.5', '--inspections', 1,
                            '--first-seed', 7, '--out', self.out)
        report = json.loads((self.out / 'evaluation.json').read_text())
        self.assertEqual((report['format'], report['version']), ('rva-evaluation-moved', 2))
        (inspection,) = report['inspections']
        self.assertTrue(0.1 < inspection['move_m'] < 0.45)
        self.assertLess(inspection['turn_deg'], 16)
        self.assertEqual([(entry['captures'], entry['setting']) for entry in inspection['results']],
                         [(captures, allowed) for captures in (1, 2) for allowed in (0.05, 0.5)])
        for entry in inspection['registrations']:
            self.assertTrue(entry['doubt'] or entry['error_mm'] < 10, entry)
        for entry in inspection['results']:
            self.assertEqual(len(entry['found']), len(inspection['targets']))
        self.assertIn('registration: median', done.stdout)

    def test_a_camera_that_came_back_to_its_pose(self):
        done = self.succeed('evaluate', '--moved', '--return', 'exact', '--captures', 1, '--inspections', 1,
                            '--first-seed', 7, '--out', self.out)
        report = json.loads((self.out / 'evaluation.json').read_text())
        (inspection,) = report['inspections']
        self.assertLess(max(inspection['move_m'], inspection['turn_deg']), 1e-9)
        self.assertNotIn('registrations', inspection)
        self.assertNotIn('registration', done.stdout)
        usual = report['tallies'][0]
        self.assertEqual((usual['method'], usual['captures'], usual['setting']), ('auto', 1, 0.05))
        self.assertGreater(usual['big_found'], usual['big'] / 2)
        self.assertEqual(usual['false_when_clean'], inspection['results'][0]['false_when_clean'])

    def test_the_robots_own_path_goes_on_where_it_was_ended(self):
        path = ['evaluate', '--moved', '--return', 'rest', '--captures', 1, '--first-seed', 7, '--out', self.out]
        self.succeed(*path, '--inspections', 2)
        at_a_time = json.loads((self.out / 'evaluation.json').read_text())
        self.succeed(*path, '--inspections', 1, '--overwrite')
        done = self.succeed(*path, '--inspections', 2, '--resume')
        report = json.loads((self.out / 'evaluation.json').read_text())
        self.assertEqual(report, at_a_time)
        self.assertEqual([entry['seed'] for entry in report['inspections']], [7, 8])
        for inspection in report['inspections']:
            self.assertEqual([(entry['method'], entry['setting']) for entry in inspection['results']],
                             [('auto', 0.05)])
            self.assertTrue(0.0 < inspection['turn_deg'] < 0.5, 'each side rests somewhere else')
        self.assertIn('big, light', done.stdout)
        for other in (['--first-seed', 8], ['--first-seed', 7, '--allowed', '0.5']):
            done = self.rva(*path[:-4], *other, '--out', self.out, '--inspections', 2, '--resume')
            self.assertEqual(done.returncode, 2)
            self.check_line(done.stderr, ['--resume'])

    def test_harder_bays_and_other_cameras(self):
        done = self.succeed('evaluate', '--moved', '--return', 'rest', '--captures', 1, '--first-seed', 7, '--out', self.out,
                            '--inspections', 1, '--bay', 'all', '--cameras', 'random:3')
        moved = json.loads((self.out / 'evaluation.json').read_text())
        self.assertIn('bay all', moved['arguments'])
        self.assertGreaterEqual(moved['tallies'][0]['work_findings'], 0)
        static = ['evaluate', '--out', self.out, '--inspections', 1, '--frames', 2, '--first-seed', 7, '--bay',
                  'dirt,cables', '--cameras', 'correlation-9']
        done = self.succeed(*static, '--overwrite')
        report = json.loads((self.out / 'evaluation.json').read_text())
        self.assertEqual((report['cameras'], report['bay']), ('correlation-9', 'dirt,cables'))
        self.succeed(*static, '--resume')
        for other in (['--cameras', 'd435'], ['--bay', 'dirt']):
            with self.subTest(other):
                done = self.rva(*static[:-4], *other, '--resume')
                self.assertEqual(done.returncode, 2)
                self.check_line(done.stderr, ['--resume'])

    def test_bad_input(self):
        for options in (['--moved', '--frames', '10'], ['--moved', '--captures', '4,1'], ['--moved', '--captures', '17'],
                        ['--captures', '2'], ['--recorded', '.', '--moved'], ['--recorded', '.', '--frames', '2'],
                        ['--return', 'near'], ['--with-octree'], ['--bay', 'gold'], ['--cameras', 'gold'],
                        ['--bay', 'dirt', '--scene', 'x.yaml'], ['--planned', '--moved'], ['--planned', '--bay', 'dirt'],
                        ['--planned', '--cameras', 'gold'], ['--planned', '--recorded', '.'],
                        ['--shake', 'some'], ['--shake', 'loose', '--planned'], ['--shake', 'loose', '--frames', '2'],
                        ['--moved', '--return', 'home']):
            with self.subTest(options):
                done = self.rva('evaluate', *options, '--out', self.out)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.check_line(done.stderr, ['--'])
                self.assertFalse(self.out.exists())
        out = ['--out', self.out]
        for options, names in ((['--frames', '10,5'], ['--frames']), (['--frames', '1'], ['--frames']),
                               (['--inspections', 0], ['--inspections']), (['--cameras', 'gold'], ['--cameras', 'd435'])):
            with self.subTest(options):
                done = self.rva('evaluate', *out, *options)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.check_line(done.stderr, names)
                self.assertFalse(self.out.exists())
        self.check_fails('evaluate', *out, '--scene', self.folder / 'none.yaml', names=['none.yaml'])


if __name__ == '__main__':
    program.main()
