"""The computations with which the model of the robot is checked, on shapes whose answer is known; the wiring plan and
the list of dimensions. Needs no OpenSCAD.

usage: computation_test.py REPOSITORY
"""
import pathlib
import sys
import unittest

import numpy as np

ROOT = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(ROOT / 'hardware' / 'model'))

import bill  # noqa: E402
import collision  # noqa: E402
import passage  # noqa: E402
import printing  # noqa: E402
import robot as model  # noqa: E402
from mesh import Mesh, box  # noqa: E402
from wiring import Plan  # noqa: E402


def joined(*meshes):
    return Mesh(np.concatenate([mesh.corners for mesh in meshes]))


def extruded(outline, depth, triangles=None):
    """A solid from an outline (x, z), counterclockwise, from y = 0 to depth; without triangles it is convex."""
    triangles = triangles or [(0, i, i + 1) for i in range(1, len(outline) - 1)]
    points = np.array(outline, float)
    front = np.stack([points[:, 0], np.zeros(len(points)), points[:, 1]], axis=1)
    back = front + [0, depth, 0]
    corners = [[front[a], front[b], front[c]] for a, b, c in triangles]
    corners += [[back[a], back[c], back[b]] for a, b, c in triangles]
    for i in range(len(points)):
        j = (i + 1) % len(points)
        corners += [[front[i], back[i], back[j]], [front[i], back[j], front[j]]]
    return Mesh(corners)


class Meshes(unittest.TestCase):
    def test_a_box(self):
        mesh = box([0, 0, 0], [10, 20, 30])
        self.assertEqual(mesh.faults(), [])
        self.assertAlmostEqual(mesh.volume, 6000)
        np.testing.assert_allclose(mesh.centroid, [5, 10, 15])
        np.testing.assert_allclose(np.diag(mesh.second_moment), 6000 * np.array([100, 400, 900]) / 3)

    def test_broken_meshes_are_refused(self):
        mesh = box([0, 0, 0], [10, 20, 30])
        hole, turned, inside_out = mesh.corners[1:], mesh.corners.copy(), mesh.corners[:, ::-1]
        turned[0] = turned[0][::-1]
        for corners in (hole, turned, inside_out, np.concatenate([mesh.corners, mesh.corners[:1]]), np.empty((0, 3, 3))):
            self.assertNotEqual(Mesh(corners).faults(), [])

    def test_points_inside(self):
        mesh = box([0, 0, 0], [10, 20, 30])
        points = np.random.default_rng(1).uniform(-10, 40, (5000, 3))
        np.testing.assert_array_equal(mesh.contains(points), ((points > 0) & (points < [10, 20, 30])).all(axis=1))


class Printing(unittest.TestCase):
    def test_thin_walls_are_found(self):
        for thickness in (1.5, 2.5):
            found, _ = printing.thinnest(box([0, 0, 0], [40, 30, thickness]), 5.0)
            self.assertAlmostEqual(found, thickness, 2)

    def test_overhangs(self):
        table = joined(box([0, 0, 0], [10, 20, 20]), box([0, 0, 20], [30, 20, 25]))
        self.assertNotEqual(printing.overhangs(table, 45, 10), [])
        leaning = {angle: extruded([(0, 0), (20, 0), (20 + 20 * np.tan(np.radians(angle)), 20), (0, 20)], 10) for angle in (40, 55)}
        self.assertEqual(leaning[40].faults(), [])
        self.assertEqual(printing.overhangs(leaning[40], 45, 10), [])
        self.assertNotEqual(printing.overhangs(leaning[55], 45, 10), [])

    def test_bridges_up_to_their_length(self):
        for gap, allowed in ((8, True), (14, False)):
            outline = [(0, 0), (5, 0), (5, 5), (5 + gap, 5), (5 + gap, 0), (10 + gap, 0), (10 + gap, 10), (0, 10)]
            bridge = extruded(outline, 30, [(0, 1, 2), (0, 2, 7), (2, 3, 7), (3, 6, 7), (3, 4, 5), (3, 5, 6)])
            self.assertEqual(bridge.faults(), [])
            self.assertEqual(printing.overhangs(bridge, 45, 10) == [], allowed, gap)

    def test_turn_is_that_of_openscad(self):
        np.testing.assert_allclose(printing.turned([90, 0, 0]) @ [0, 1, 0], [0, 0, 1], atol=1e-12)
        np.testing.assert_allclose(printing.turned([0, 0, 90]) @ [1, 0, 0], [0, 1, 0], atol=1e-12)


class Collisions(unittest.TestCase):
    def test_boxes_that_touch_and_that_overlap(self):
        one = box([0, 0, 0], [10, 10, 10])
        for other, overlap in ((box([10, 0, 0], [20, 10, 10]), False), (box([9, 2, 2], [20, 8, 8]), True),
                               (box([2, 2, -5], [3, 3, 15]), True), (box([-5, -5, -5], [15, 15, 15]), True)):
            found = collision.overlap(one, other, collision.Samples(one), collision.Samples(other))
            self.assertEqual(found is not None, overlap)

    def test_a_pose_moves_the_first(self):
        one = box([-1, -1, -1], [1, 1, 1])
        other = box([9, -1, -1], [11, 1, 1])
        samples = collision.Samples(one), collision.Samples(other)
        self.assertIsNone(collision.overlap(one, other, *samples))
        self.assertIsNotNone(collision.overlap(one, other, *samples, pose=(np.eye(3), np.array([9.0, 0, 0]))))

    def test_a_triangle_without_area_adds_no_points(self):
        plain = box([0, 0, 0], [10, 10, 10])
        line = [[[1, 4, 10], [5, 4, 10], [9, 4, 10]]]
        found = collision.Samples(Mesh(np.concatenate([plain.corners, line])))
        np.testing.assert_array_equal(found.points, collision.Samples(plain).points)
        self.assertGreater(len(found.points), 20)

    def test_screws_through_a_plate_without_a_hole_and_blocked_drivers(self):
        plate = model.Part('plate', 'fixed', 'printed', [0, 0, 0])
        plate.mesh = box([-10, -10, -5], [10, 10, 0])
        screw = model.Screw('screw', 3, 8, False, [0, 0, 0], [0, 0, 1])
        self.assertEqual(collision.screw_fits(screw, [plate])[0], ['plate'])
        self.assertEqual(collision.blocked_driver(screw, [plate], 7, 90), [])
        plate.mesh = box([-10, -10, 50], [10, 10, 55])
        self.assertEqual(collision.blocked_driver(screw, [plate], 7, 90), ['plate'])


class Passage(unittest.TestCase):
    def test_squares_in_holes(self):
        square = passage.hull([[0, 0], [100, 0], [100, 100], [0, 100], [50, 50]])
        self.assertEqual(len(square), 4)
        self.assertAlmostEqual(passage.clearance(square, 160, 160), 80 - 50 * np.sqrt(2), 1)
        self.assertLess(passage.clearance(square, 140, 140), 0)

    def test_a_long_outline_is_turned_into_an_ellipse(self):
        outline = passage.hull([[0, 0], [300, 0], [300, 60], [0, 60]])
        self.assertGreater(passage.clearance(outline, 254, 457), 20)
        self.assertLess(passage.clearance(outline, 230, 230), 0)


class Documents(unittest.TestCase):
    def test_each_dimension_has_a_source(self):
        self.assertGreater(len(model.dimensions()), 80)
        for line in ('wall = 3;', 'wall = 3; //', 'wall 3; // chosen'):
            self.assertIsNone(model.DIMENSION.match(line), line)

    def test_no_dimension_stands_elsewhere_as_a_second_definition(self):
        for name in ('layout.scad', 'parts.scad', 'bought.scad'):
            text = (ROOT / 'hardware' / name).read_text()
            for dimension in model.dimensions():
                self.assertNotRegex(text, rf'(?m)^{dimension} = ', name)

    def test_bill_of_materials(self):
        rows = bill.rows()
        self.assertGreater(len(rows), 15)
        for row in rows:
            self.assertTrue(row['part'] and row['maker'], row)
            self.assertGreater(row['quantity'] * row['price_usd'], 0, row)
        self.assertAlmostEqual(bill.price_usd([{'quantity': 2, 'price_usd': 3.5}, {'quantity': 1, 'price_usd': 1}]), 8)

    def test_wiring_plan(self):
        plan = Plan((ROOT / 'hardware' / 'wiring.txt').read_text())
        self.assertEqual((ROOT / 'hardware' / 'wiring.svg').read_text(), plan.svg())

    def test_wiring_mistakes_are_refused(self):
        good = 'column: a | b\ncolumn: c | d\nnode 1 one: One\n> x\nnode 2 two: Two\n< y\nwire one.x -> two.y: red\n'
        Plan(good)
        for bad in (good.replace('one.x', 'one.z'), good.replace(': red', ': pink'), good + 'nonsense\n',
                    good.replace('wire one.x -> two.y: red\n', ''), good.replace('node 2', 'node 1')):
            with self.assertRaises(ValueError):
                Plan(bad)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1], verbosity=2)
