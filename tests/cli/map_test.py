"""`rva map` and `rva calibrate` from end to end: simulated, and with the built firmware on a simulated board.

usage: map_test.py RVA ROBOT_IN_THE_LOOP
"""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import unittest

import numpy as np

import program
from captures import write_capture
from simulations import TOOLS

ROBOT = None
MAP_FOLDER = []
GRID = '-20,20,3,-32,-14,2'
DATA = pathlib.Path(__file__).resolve().parents[2] / 'data'


def points_of(ply):
    data = ply.read_bytes()
    header, body = data.split(b'end_header\n', 1)
    count = next(int(line.split()[-1]) for line in header.split(b'\n') if line.startswith(b'element vertex'))
    points = np.frombuffer(body, dtype=[('at', '<f4', 3), ('color', 'u1', 3)])
    assert len(points) == count, header
    return points


def poses_of(ply):
    return json.loads(ply.with_suffix('.json').read_text())


def matrix(numbers):
    return np.array(numbers).reshape(4, 4)


def turn_deg(a, b):
    cosine = (np.trace(a[:3, :3].T @ b[:3, :3]) - 1) / 2
    return np.degrees(np.arccos(np.clip(cosine, -1, 1)))


class MapTest(program.ProgramTest):
    """Views take seconds: all classes share those of one map, which is left alone."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        if MAP_FOLDER:
            return
        temporary = tempfile.TemporaryDirectory(prefix='rva-test-')
        unittest.addModuleCleanup(temporary.cleanup)
        MAP_FOLDER.append(pathlib.Path(temporary.name).resolve())
        made = subprocess.run([program.PROGRAM, *cls.arguments(MAP_FOLDER[0] / 'map.ply')], capture_output=True,
                              encoding='utf-8', stdin=subprocess.DEVNULL, timeout=4 * program.TIMEOUT_S, check=False)
        assert made.returncode == 0, made.stderr
        (MAP_FOLDER[0] / 'said.txt').write_text(made.stdout)

    def setUp(self):
        super().setUp()
        self.shared = MAP_FOLDER[0]
        self.map = self.shared / 'map.ply'

    @staticmethod
    def arguments(out, *options, camera=f'sim:{TOOLS}', robot='sim', where=('--grid=' + GRID,)):
        return ['map', '--camera', camera, '--robot', robot, *where, '--frames', '2', '--out', out, *options]

    def copy(self):
        """The map, in the test's own folder."""
        shutil.copytree(self.shared, self.folder / 'copy')
        return self.folder / 'copy' / 'map.ply'

    def check_refused(self, *arguments, names=(), status=1):
        before = self.names()
        done = self.rva(*arguments)
        self.assertEqual(done.returncode, status, done.stderr)
        self.check_line(done.stderr, names)
        self.assertEqual(done.stdout, '')
        self.assertEqual(self.names(), before)


class Mapping(MapTest):
    def test_points_are_those_of_the_bay(self):
        points = points_of(self.map)
        self.assertEqual((self.shared / 'said.txt').read_text(), f'{self.map}: {len(points)} points of 6 views\n')
        self.assertGreater(len(points), 100000)
        # The skin that the robot stands on; and what is red is the screwdriver, 0.646 m ahead of it.
        right, ahead, up = points['at'].T
        skin = up[(abs(right) < 0.3) & (ahead > 0.2) & (ahead < 0.9) & (abs(up) < 0.01)]
        self.assertGreater(len(skin), 10000)
        self.assertAlmostEqual(float(np.median(skin)), 0.0, delta=0.002)
        red = points['at'][(points['color'][:, 0] > 150) & (points['color'][:, 1] < 60)]
        self.assertGreater(len(red), 100)
        self.assertAlmostEqual(float(np.median(red[:, 1])), 0.646, delta=0.03)

    def test_a_map_without_a_point_names_the_options_of_distance(self):
        kept = (copy := self.copy()).read_bytes()
        self.check_refused(*self.arguments(copy, '--resume', '--overwrite', '--near', 90, '--far', 100),
                           names=[copy, 'no point', '--near and --far'])
        self.assertEqual(copy.read_bytes(), kept)

    def test_poses_stand_beside(self):
        poses = poses_of(self.map)
        self.assertEqual((poses['format'], poses['base'], poses['refined']), ('rva-map', 'b1-foot', True))
        self.assertEqual(len(poses['views']), 6)
        for view in poses['views']:
            turned = turn_deg(matrix(view['foot_from_camera']), matrix(view['foot_from_camera_by_joints']))
            self.assertLess(turned, 0.4)
            self.assertGreater(turned, 0.0)
            self.assertGreater(view['agreeing'], 0.7)
            capture = self.info(self.shared / view['capture'])
            self.assertEqual(capture['depth_frames'], 2)
            self.assertEqual(capture['pose']['pan_deg'], view['pan_deg'])

    def test_without_refinement_the_joints_decide(self):
        ply = self.copy()
        self.succeed(*self.arguments(ply, '--resume', '--overwrite', '--no-refine'))
        poses = poses_of(ply)
        self.assertFalse(poses['refined'])
        for view in poses['views']:
            self.assertEqual(view['foot_from_camera'], view['foot_from_camera_by_joints'])

    def test_the_same_views_give_the_same_bytes(self):
        ply = self.copy()
        self.succeed(*self.arguments(ply, '--resume', '--overwrite'))
        for suffix in ('.ply', '.pcd', '.json'):
            self.assertEqual(ply.with_suffix(suffix).read_bytes(), self.map.with_suffix(suffix).read_bytes())

    def test_larger_cubes_make_fewer_points(self):
        ply = self.copy()
        said = json.loads(self.succeed(*self.arguments(ply, '--resume', '--overwrite', '--voxel', 12, '--json')).stdout)
        self.assertEqual(said['points'], len(points_of(ply)))
        self.assertLess(said['points'], len(points_of(self.map)) / 4)

    def test_only_missing_views_are_taken(self):
        ply = self.copy()
        views = ply.with_suffix('.views')
        kept = (views / '001' / 'capture.json').stat().st_mtime_ns
        shutil.rmtree(views / '004')
        self.succeed(*self.arguments(ply, '--resume', '--overwrite'))
        self.assertEqual((views / '001' / 'capture.json').stat().st_mtime_ns, kept)
        self.assertEqual(self.info(views / '004')['depth_frames'], 2)

    def test_an_interrupted_map_goes_on(self):
        ply = self.folder / 'map.ply'
        with subprocess.Popen(self.command(*self.arguments(ply)), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              stdin=subprocess.DEVNULL, encoding='utf-8') as process:
            self.wait_for(lambda: (self.folder / 'map.views' / '000').exists())
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.communicate(timeout=program.TIMEOUT_S), ('', ''))
        self.assertEqual(process.returncode, 130)
        taken = sorted(path.name for path in (self.folder / 'map.views').iterdir())
        self.assertLess(len(taken), 6)
        self.assertEqual(taken, [f'{i:03}' for i in range(len(taken))], 'half a view was left')
        self.check_refused(*self.arguments(ply), names=['map.views', 'resume'])
        self.succeed(*self.arguments(ply, '--resume'))
        self.assertEqual(len(poses_of(ply)['views']), 6)

    def test_an_earlier_map_is_not_replaced_unasked(self):
        ply = self.copy()
        self.check_refused(*self.arguments(ply), names=[ply, 'overwrite'])

    def test_what_is_no_map_is_not_replaced(self):
        ply = self.copy()
        mine = ply.with_suffix('.views') / 'notes.txt'
        mine.write_text('mine')
        self.check_refused(*self.arguments(ply, '--overwrite'), names=['notes.txt', 'not part of an earlier result'])
        shutil.rmtree(ply.with_suffix('.views'))
        ply.with_suffix('.views').symlink_to(self.folder)
        self.check_refused(*self.arguments(ply, '--overwrite'), names=['map.views', 'not replaced'])
        other = self.folder / 'robot.ply'
        other.with_suffix('.json').write_text('{}')
        self.check_refused(*self.arguments(other), names=['robot.json', 'already exists'])
        self.check_refused(*self.arguments(other, '--overwrite'), names=['robot.json', 'not belong to an earlier map'])

    def test_earlier_views_come_back_when_no_new_one_is_taken(self):
        ply = self.copy()
        self.check_refused(*self.arguments(ply, '--overwrite', camera=f'sim:{TOOLS},joints={self.folder}/none'),
                           names=['none', 'no such file'])

    def test_what_a_killed_program_left_is_removed(self):
        ply = self.copy()
        views = ply.with_suffix('.views')
        (views / '005').rename(views / '005.partial-1-0')
        self.succeed(*self.arguments(ply, '--resume', '--overwrite'))
        self.assertEqual(sorted(path.name for path in views.iterdir()), [f'{i:03}' for i in range(6)])

    def test_views_that_cannot_belong_to_the_map(self):
        ply = self.copy()
        views = ply.with_suffix('.views')
        shutil.copytree(views / '005', views / '006')
        self.check_refused(*self.arguments(ply, '--resume', '--overwrite'), names=['006', 'more than the 6 views'])
        shutil.rmtree(views / '006')
        description = views / '003' / 'capture.json'
        said = json.loads(description.read_text())
        said['camera']['serial'] = 'another'
        description.write_text(json.dumps(said))
        self.check_refused(*self.arguments(ply, '--resume', '--overwrite'), names=['003', 'another camera'])
        description.unlink()
        self.check_refused(*self.arguments(ply, '--resume', '--overwrite'), names=['003', 'taken again'])

    def test_views_of_other_waypoints_are_not_mixed_in(self):
        ply = self.copy()
        self.check_refused(*self.arguments(ply, '--resume', '--overwrite', where=('--grid=-25,20,3,-32,-14,2',)),
                           names=['map.views/000', 'same waypoints'])

    def test_a_person_sees_how_far_it_is(self):
        ply = self.copy()
        shutil.rmtree(ply.with_suffix('.views') / '005')
        self.assertIn('views 5/6', self.on_a_terminal(*self.arguments(ply, '--resume', '--overwrite')))

    def wait_for(self, happened):
        deadline = time.monotonic() + program.TIMEOUT_S
        while not happened():
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)


class MapBadInput(MapTest):
    def refused(self, *options, names, status=1, **how):
        self.check_refused(*self.arguments(self.folder / 'new.ply', *options, **how), names=names, status=status)

    def written(self, name, value):
        path = self.folder / name
        path.write_text(value if isinstance(value, str) else json.dumps(value))
        return path

    def test_waypoints_out_of_limits(self):
        for grid, axis in (('-20,95,2,-30,-30,1', 'pan'), ('0,0,1,-30,15,2', 'tilt')):
            self.refused(names=['waypoint 2', axis, 'give'], status=2, where=('--grid=' + grid,))

    def test_waypoint_files(self):
        for value, named in (('[', 'line 1'), ({}, 'not a list'), ({'format': 'rva-waypoints', 'version': 1, 'waypoints': []}, 'contains 0')):
            path = self.written('waypoints.json', value)
            self.refused(names=[path, named], where=('--waypoints', path))
        self.refused(names=['no such file'], where=('--waypoints', self.folder / 'none.json'))
        for file in sorted((DATA / 'waypoints').iterdir()):
            self.refused(names=['no such file'], where=('--waypoints', file), camera='sim:none.yaml')

    def test_grids(self):
        for grid in ('0,0,0,0,0,1', '0,0,1.5,0,0,1', '0,0,1,0,9,1001', '0,9,40,0,9,40', '0,5,1,0,0,1'):
            self.refused(names=['--grid'], status=2, where=('--grid=' + grid,))
        self.assertEqual(self.rva(*self.arguments(self.folder / 'new.ply', where=())).returncode, 2)

    def test_robots(self):
        self.refused(names=['no such device'], robot='serial:/dev/ttyNONE')
        self.refused(names=['/dev/null', 'serial'], robot='serial:/dev/null')
        self.refused(names=['none'], robot='none', status=2)
        for uri in ('serial:', 'spare', ''):
            self.refused(names=['sim or serial:DEVICE'], robot=uri, status=2)

    def test_geometries(self):
        good = poses_of(self.map)['geometry']
        for where, value, named in ((('camera', 'right'), [-1, 0, 0], 'left-handed'),
                                    (('bracket', 'axis'), [1, 1, 0], 'length 1'),
                                    (('servo1', 'axis'), [0, 0, -1], 'point up')):
            bad = json.loads(json.dumps(good))
            bad[where[0]][where[1]] = value
            path = self.written('robot.json', bad)
            self.refused('--geometry', path, names=[path, named])

    def test_cameras(self):
        for uri in ('sim:', 'replay:' + str(self.shared / 'map.views' / '000'), ''):
            self.refused(names=['sim:SCENE'], camera=uri, status=2)

    def test_joint_files(self):
        path = self.written('joints', 'left a bit')
        done = self.rva(*self.arguments(self.folder / 'new.ply', camera=f'sim:{TOOLS},joints={path}'))
        self.assertEqual(done.returncode, 1)
        self.check_line(done.stderr, [path, 'two angles'])

    def test_names(self):
        self.check_refused(*self.arguments(self.folder / 'map.pcd'), names=['.ply'], status=2)
        self.written('file', 'x')
        self.check_refused(*self.arguments(self.folder / 'file' / 'map.ply'), names=['map.views', 'another location'])

    def test_options(self):
        self.refused('--voxel', 0.1, names=['--voxel'], status=2)
        self.refused('--servo-error', 'nan', names=['--servo-error'], status=2)
        self.refused('--near', 2, '--far', 1, names=['--near', 'far limit'], status=2)
        for base in ('', b'a\xff'):
            self.refused('--base', base, names=['--base'], status=2)
        self.refused('--waypoints', '', names=['no such file'], where=())
        self.refused('--geometry', '', names=['no such file'])
        self.refused(names=['a file of joint angles'], camera=f'sim:{TOOLS},joints=', status=2)


class Calibrating(MapTest):
    def setUp(self):
        super().setUp()
        self.views = sorted((self.shared / 'map.views').iterdir())
        self.robot = self.folder / 'robot.json'
        self.given = self.folder / 'given.json'
        geometry = poses_of(self.map)['geometry']
        geometry['camera']['at_m'][2] += 0.004
        self.given.write_text(json.dumps(geometry))

    def test_a_camera_that_was_measured_too_high_is_found(self):
        done = self.succeed('calibrate', *self.views, '--geometry', self.given, '--out', self.robot, '--json')
        said = json.loads(done.stdout)
        up = next(number for number in said['numbers'] if number['name'] == 'camera, up')
        self.assertAlmostEqual(up['change'], -4.0, delta=2.5)
        self.assertGreater(said['after']['agreeing'], said['before']['agreeing'])
        self.assertEqual(len(said['views']), 6)
        ply = self.copy()
        self.succeed(*self.arguments(ply, '--resume', '--overwrite', '--geometry', self.robot))
        used, found = poses_of(ply)['geometry'], json.loads(self.robot.read_text())
        np.testing.assert_allclose(used['camera']['at_m'], found['camera']['at_m'], atol=1e-9)

    def test_a_person_reads_a_table(self):
        done = self.succeed('calibrate', *self.views, '--out', self.robot)
        self.assertRegex(done.stdout, r'camera, forward +[+-]\d+\.\d\d mm')
        self.assertRegex(done.stdout, r'On the same surfaces: \d+ % before, \d+ % after\.')

    def test_an_earlier_geometry_is_not_replaced_unasked(self):
        self.robot.write_text('mine')
        self.check_refused('calibrate', *self.views, '--out', self.robot, names=[self.robot, '--overwrite'])
        self.check_refused('calibrate', *self.views, '--out', self.robot, '--overwrite', names=["is not a robot's geometry"])
        shutil.copy(self.given, self.robot)
        self.succeed('calibrate', *self.views, '--out', self.robot, '--overwrite')
        self.assertNotEqual(self.robot.read_text(), self.given.read_text())

    def test_views_that_say_too_little(self):
        self.check_refused('calibrate', *self.views[:2], '--out', self.robot, names=['too few'])
        self.check_refused('calibrate', *self.views[:3], '--out', self.robot, names=['tilt turns by less'])

    def test_views_that_do_not_belong_together(self):
        other = self.folder / 'other'
        shutil.copytree(self.views[0], other)
        said = json.loads((other / 'capture.json').read_text())
        said['pose']['base'] = 'elsewhere'
        (other / 'capture.json').write_text(json.dumps(said))
        self.check_refused('calibrate', *self.views, other, '--out', self.robot, names=[other, 'same position'])
        said['pose']['base'] = 'b1-foot'
        said['camera']['baseline_m'] = 0.06
        (other / 'capture.json').write_text(json.dumps(said))
        self.check_refused('calibrate', *self.views, other, '--out', self.robot, names=[other, 'same camera'])
        self.check_refused('calibrate', *self.views, self.views[2], '--out', self.robot, names=['given twice'])
        write_capture(self.folder / 'plain', [np.full((4, 4), 1000, np.uint16)])
        self.check_refused('calibrate', self.folder / 'plain', '--out', self.robot, names=['plain'])

    def test_a_view_whose_angle_is_wrong(self):
        views = self.folder / 'views'
        shutil.copytree(self.shared / 'map.views', views)
        description = views / '002' / 'capture.json'
        said = json.loads(description.read_text())
        said['pose']['pan_deg'] -= 15
        description.write_text(json.dumps(said))
        self.check_refused('calibrate', *sorted(views.iterdir()), '--out', self.robot, names=['same surfaces'])

    def test_a_path_that_cannot_be_written(self):
        self.check_refused('calibrate', *self.views, '--out', self.folder / 'none' / 'robot.json', names=['none/robot.json'])


class InTheLoop(MapTest):
    """From a command to a map, with nothing left out but wood and glass: the built firmware on a simulated board,
    its servos in simulation, and the simulated camera where these really are."""

    def setUp(self):
        super().setUp()
        self.link = self.folder / 'robot'
        self.joints = self.folder / 'joints'
        self.board = subprocess.Popen([ROBOT, self.link, self.joints, '--faults'], stdin=subprocess.PIPE,
                                      stdout=subprocess.PIPE, encoding='utf-8')
        self.addCleanup(self.put_away)
        for line in self.board.stdout:  # simavr prints what it loads
            if line == 'ready\n':
                return
        if self.board.wait() == 77:
            self.skipTest('the firmware was not built (gcc-avr, arduino-core-avr, libsimavr-dev)')
        self.fail('the board did not come up')

    def put_away(self):
        self.board.stdin.close()
        self.board.wait(program.TIMEOUT_S)
        self.board.stdout.close()

    def camera(self):
        return f'sim:{TOOLS},joints={self.joints}'

    def test_a_map(self):
        ply = self.folder / 'map.ply'
        self.succeed(*self.arguments(ply, camera=self.camera(), robot=f'serial:{self.link}',
                                     where=('--grid=-20,20,3,-30,-30,1',)))
        views = poses_of(ply)['views']
        for view, pan_deg in zip(views, (-20, 0, 20)):
            self.assertAlmostEqual(view['pan_deg'], pan_deg, delta=0.5)
            self.assertAlmostEqual(view['tilt_deg'], -30, delta=0.5)
            # Only where the camera was where the joints said do the views lie on each other.
            self.assertGreater(view['agreeing'], 0.7)
            self.assertLess(view['turned_deg'], 0.3)
        pan_deg, tilt_deg = (float(angle) for angle in self.joints.read_text().split())
        self.assertAlmostEqual(pan_deg, views[-1]['pan_deg'], delta=0.2)
        self.assertAlmostEqual(tilt_deg, views[-1]['tilt_deg'], delta=0.2)

    def test_a_camera_that_follows_what_the_robot_reports(self):
        ply = self.folder / 'map.ply'
        self.succeed(*self.arguments(ply, robot=f'serial:{self.link}', where=('--grid=-5,5,2,-20,-20,1',)))
        self.assertGreater(poses_of(ply)['views'][1]['agreeing'], 0.7)

    @unittest.skipUnless(os.getuid() == 0, 'only root can become somebody who may not')
    def test_a_person_who_may_not_open_the_robot(self):
        self.folder.chmod(0o755)
        mine = [shutil.copy(program.PROGRAM, self.folder), *self.command(*self.arguments(
            self.folder / 'map.ply', camera=f'sim:{shutil.copy(TOOLS, self.folder)}', robot=f'serial:{self.link}'))[1:]]
        done = subprocess.run(mine, capture_output=True, encoding='utf-8', timeout=program.TIMEOUT_S, check=False,
                              user=65534, group=65534, extra_groups=[])
        self.assertEqual((done.returncode, done.stdout), (1, ''), done.stderr)
        self.check_line(done.stderr, [self.link, 'usermod -aG ' + self.link.group()])

    def test_a_robot_that_is_unplugged_on_the_way(self):
        ply = self.folder / 'map.ply'
        with subprocess.Popen(self.command(*self.arguments(ply, camera=self.camera(), robot=f'serial:{self.link}')),
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL,
                              encoding='utf-8') as process:
            while not (self.folder / 'map.views' / '001').exists():
                self.assertIsNone(process.poll(), 'it ended early')
                time.sleep(0.01)
            self.put_away()
            stdout, stderr = process.communicate(timeout=program.TIMEOUT_S)
        self.assertEqual((process.returncode, stdout), (1, ''))
        self.check_line(stderr, [self.link])
        self.assertTrue((self.folder / 'map.views' / '001').exists(), 'what was taken is kept')
        self.assertFalse(ply.exists())


if __name__ == '__main__':
    ROBOT = os.path.abspath(sys.argv.pop(2))
    program.main()
