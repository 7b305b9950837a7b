"""`rva detect` where the robot was lifted out and put back elsewhere: the thesis' figure 3.14, simulated.

usage: moved_camera_test.py RVA
"""
import json

import numpy as np

import program
from captures import read_image, record_again
from simulations import SCENES, WALL, SimulationTest, description, truth

MOVED = ('moved-robot-initial.yaml', 'moved-robot.yaml')


def matrix(numbers):
    return np.array(numbers).reshape(4, 4)


class MovedCameraTest(SimulationTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.initial, cls.final = (cls.make(name, SCENES / scene, '--frames', 6, '--seed', seed)
                                  for seed, (name, scene) in enumerate(zip(('initial', 'final'), MOVED), 1))
        cls.initial_again, cls.final_again = (cls.make(f'again-{seed}', SCENES / scene, '--frames', 6, '--seed', seed)
                                              for seed, scene in enumerate(MOVED, 3))

    def objects_found(self, found):
        """Names of debris that a finding's changed pixels touch, and how many findings touch none."""
        labels = read_image(self.final / 'truth' / 'labels.png')
        names = {entry['label']: entry['name'] for entry in truth(self.final)['objects']
                 if entry['role'] == 'debris'}
        changed = read_image(self.out / 'changes.png') > 0
        touched, false = set(), 0
        for finding in found['detections']:
            x, y, w, h = finding['bbox']
            box = np.s_[y:y + h, x:x + w]
            here = set(labels[box][changed[box]].tolist()) & set(names)
            touched |= {names[label] for label in here}
            false += not here
        return touched, false

    def test_finds_both_torches_and_the_screwdriver_on_the_stringer(self):
        found = self.detect(self.initial, self.final)
        self.assertEqual(found['method'], 'spatial', 'the captures name two bases')
        touched, false = self.objects_found(found)
        self.assertEqual(len(touched), 3, touched)
        self.assertLessEqual(false, 1)
        world_from_initial, world_from_final = (matrix(description(capture)['pose']['world_from_camera'])
                                                for capture in (self.initial, self.final))
        real = np.linalg.inv(world_from_final) @ world_from_initial
        off = np.linalg.inv(real) @ matrix(found['final_from_initial'])
        self.assertLess(np.linalg.norm(off[:3, 3]), 0.003)
        self.assertGreater(found['coverage']['unseen'], 0.1, 'the other rib comes into view')
        registration = json.loads((self.out / 'registration.json').read_text())
        self.assertEqual(registration['format'], 'rva-registration')
        np.testing.assert_allclose(matrix(registration['initial_from_final']) @ matrix(found['final_from_initial']),
                                   np.eye(4), atol=1e-9)

    def test_newly_visible_area_is_no_change(self):
        clean = self.folder / 'clean.yaml'
        text = (SCENES / MOVED[1]).read_text()
        clean.write_text(text[:text.index('debris:')])
        final = self.make('clean', clean, '--frames', 6, '--seed', 9)
        self.assertLessEqual(len(self.detect(self.initial, final)['detections']), 1)

    def test_several_captures_a_side(self):
        self.succeed('detect', '--initial', self.initial, self.initial_again, '--final', self.final,
                     self.final_again, '--out', self.out)
        found = json.loads((self.out / 'detections.json').read_text())
        self.assertEqual(found['method'], 'spatial')
        self.assertEqual(found['frames'], {'initial': 12, 'final': 12})
        self.assertEqual(len(self.objects_found(found)[0]), 3)

    def test_static_methods_take_an_exact_return(self):
        sides = ('--initial', self.initial, self.final_again, '--final', self.final, '--out', self.out)
        done = self.succeed('detect', *sides, '--method', 'calibrated')
        self.assertIn('0 finding(s)', done.stdout)
        self.assertIn('the others were not used', done.stderr)
        self.check_fails('detect', '--initial', self.initial, self.initial_again, '--final', self.final, '--out',
                         self.folder / 'other', '--method', 'constant', names=['spatial'])

    def test_octree_is_the_thesis_pipeline(self):
        # One step and half a metre: the whole takes a minute.
        same = record_again(self.final, self.folder / 'same')
        found = self.detect(self.final, same, '--method', 'octree', '--icp-iterations', 1, '--octree-far', 0.5)
        self.assertEqual((found['method'], found['frames']), ('octree', {'initial': 1, 'final': 1}))
        self.assertEqual(found['parameters']['octree_cell_m'], 0.05)
        self.assertEqual(found['detections'], [])
        self.assertGreater(found['coverage']['compared'], 0.1)
        points = read_image(self.out / 'changed_points.png')
        self.assertEqual(points.shape, (480, 848, 3))
        self.assertEqual(np.ptp(points.astype(int), axis=2).max(), 0, 'nothing changed, so all is grey')
        self.check_fails('detect', self.initial, self.final, '--method', 'octree', '--octree-far', 0.06, '--out',
                         self.folder / 'other', names=['crop less'])

    def test_says_which_captures_are_missing(self):
        for sides in ((), (self.initial,), ('--initial', self.initial), ('--final', self.final),
                      (self.initial, self.final, '--initial', self.initial, '--final', self.final)):
            with self.subTest(sides):
                done = self.rva('detect', *sides, '--out', self.out)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.check_line(done.stderr, ['--initial'])
                self.assertFalse(self.out.exists())

    def test_refuses_what_it_cannot_register(self):
        wall = self.make('wall', WALL, '--frames', 2)
        self.check_fails('detect', self.initial, wall, '--method', 'spatial', '--out', self.out,
                         names=['could not be registered'])


if __name__ == '__main__':
    program.main()
