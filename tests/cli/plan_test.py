"""`rva detect --plan` from end to end, on the shipped scene and plan, and with plans that are wrong.

usage: plan_test.py RVA
"""
import json

import program
from simulations import SCENES, SimulationTest

SCENE = SCENES / 'planned-collars.yaml'
PLAN = SCENES.parent / 'plans' / 'collars.yaml'
LOST = (546, 348)  # the middle of the collar that was lost, px
PART = '  - { name: nuts, count: 1, height_mm: [4, 6], areas: [[[0, 0], [40, 0], [40, 40]]] }\n'


def is_around(box, pixel):
    x, y, width, height = box
    return x <= pixel[0] < x + width and y <= pixel[1] < y + height


class Plan(SimulationTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.before = cls.make('before', SCENE, '--debris', 'none', '--frames', 20)
        cls.after = cls.make('after', SCENE, '--frames', 20, '--seed', 2)

    def test_the_shipped_plan_groups_the_shipped_scene(self):
        done = self.succeed('detect', self.before, self.after, '--plan', PLAN, '--out', self.out)
        lines = [line for line in done.stdout.splitlines()
                 if line.partition(':')[0] in ('unplanned', 'planned', 'missing', 'not inspected', 'surplus')]
        self.assertRegex(lines[0], '^unplanned: finding ')
        self.assertEqual(lines[1:3], ['planned: 11 of 12 collars in row 2', 'planned: 24 of 24 collars in row 3'])
        self.assertRegex(lines[3], '^missing: collars in row 2, place 5, at pixel ')
        self.assertEqual(len(lines), 4)
        match = json.loads((self.out / 'plan.json').read_text())
        self.assertEqual([is_around(piece['bbox'], LOST) for piece in match['unplanned']], [True])
        self.assertEqual(match['order'][0], match['unplanned'][0]['finding'])
        self.assertEqual([part['place'] for part in match['groups'][0]['missing']], [5])

    def test_a_plan_adds_to_the_findings_and_removes_none(self):
        plain = self.detect(self.before, self.after, out=self.folder / 'plain')
        planned = self.detect(self.before, self.after, '--plan', PLAN, out=self.folder / 'planned')
        self.assertEqual([group['name'] for group in planned.pop('plan')], ['collars in row 2', 'collars in row 3'])
        states = [(finding.pop('planned'), finding.pop('planned_item', None)) for finding in planned['detections']]
        self.assertIn(('unplanned', None), states)
        self.assertIn(('planned', 'collars in row 3'), states)
        self.assertEqual(planned['detections'], plain['detections'])
        self.assertFalse((self.folder / 'plain' / 'plan.json').exists())

    def test_a_result_with_a_plan_is_replaced_as_a_whole(self):
        self.detect(self.before, self.after, '--plan', PLAN)
        self.detect(self.before, self.after, '--overwrite')
        self.assertFalse((self.out / 'plan.json').exists())

    def test_json_contains_the_groups(self):
        done = self.succeed('detect', self.before, self.after, '--plan', PLAN, '--json', '--out', self.out)
        groups = json.loads(done.stdout)['plan']
        self.assertEqual([(group['found'], group['planned']) for group in groups], [(11, 12), (24, 24)])

    def test_wrong_plans_are_refused(self):
        head = 'format: rva-plan\nversion: 1\nparts:\n'
        wrong = {'kind': (head + PART.replace('count', 'kind: collar, count'), 'unknown kind "collar"; use one of'),
                 'overlap': (head + PART + PART.replace('nuts', 'bolts'), 'overlaps an area of nuts'),
                 'yaml': (head + '  - { name: [', 'not YAML')}
        for name, (text, fault) in wrong.items():
            file = self.folder / f'{name}.yaml'
            file.write_text(text)
            done = self.check_fails('detect', self.before, self.after, '--plan', file, '--out', self.out,
                                    names=[f'{name}.yaml:', fault])
            self.assertRegex(done.stderr, rf'{name}\.yaml:\d+: ')

    def test_options_of_plans_require_one(self):
        done = self.succeed('detect', self.before, self.after, '--height-error', 3, '--out', self.out, status=2)
        self.assertIn('--plan', done.stderr)

    def test_a_shake_test_has_no_plan_and_shows_both_sides_of_a_motion(self):
        for options, named in ((['--shake', '--plan', PLAN], '--plan'), (['--loose-reach', 20], '--shake'),
                               (['--shake', '--loose-reach', -1], '--loose-reach'),
                               (['--shake', '--method', 'constant'], '--shake'),
                               (['--shake', '--method', 'octree'], '--shake')):
            with self.subTest(options):
                done = self.succeed('detect', self.before, self.after, *options, '--out', self.out, status=2)
                self.assertIn(named, done.stderr)
                self.assertFalse(self.out.exists())

    def test_a_shake_test_adds_to_the_findings_and_removes_none(self):
        plain = self.detect(self.before, self.after, out=self.folder / 'still')
        shaken = self.detect(self.before, self.after, '--shake', out=self.folder / 'shaken')
        ids = {part[kind] for part in shaken.pop('loose_parts') for kind in ('added', 'removed')}
        self.assertEqual({finding['id'] for finding in shaken['detections'] if finding.pop('loose_part', None)}, ids)
        self.assertEqual(shaken['detections'], plain['detections'])


if __name__ == '__main__':
    program.main()
