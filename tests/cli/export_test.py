"""`rva export`: captures as other programs read them, and inspections (those with captures: api_schema_test.py and
same_findings_test.py).

usage: export_test.py RVA
"""
import contextlib
import json
import sqlite3

import numpy as np

import program
from bags import write_bag
from captures import CAMERA, IDENTITY, noisy, plain_color, read_image, write_capture
from simulations import contents

FRAMES = 4
RED = plain_color(CAMERA.width, CAMERA.height, (200, 30, 40))
SHIFTED = [*IDENTITY[:3], 0.015, *IDENTITY[4:]]


class Export(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.floor = CAMERA.plane(1000, per_column=2)
        self.floor[:, -4:] = 0
        self.frames = noisy(self.floor, FRAMES, 0.0, seed=1)

    def capture(self, **keys):
        keys = {'color': CAMERA.fields(), 'color_from_depth': IDENTITY} | keys
        return write_capture(self.folder / 'capture', self.frames, pictures=[RED],
                             **{key: value for key, value in keys.items() if value is not None})

    def export(self, capture, to, *options):
        done = self.succeed('export', capture, '--to', to, '--out', self.out, *options)
        self.assertEqual(done.stdout, f'{self.out}\n')
        return self.out

    def expected_points(self):
        v, u = np.nonzero(self.floor)
        return CAMERA.deproject(u, v, self.floor[v, u] / 1000)

    def test_ply(self):
        raw = self.export(self.capture(), 'ply').read_bytes()
        header, body = raw.split(b'end_header\n', 1)
        self.assertIn(b'format binary_little_endian', header)
        kinds = {b'float': '<f4', b'uchar': 'u1', b'ushort': '<u2'}
        fields = [line.split()[1:] for line in header.splitlines() if line.startswith(b'property')]
        points = np.frombuffer(body, np.dtype([(name.decode(), kinds[kind]) for kind, name in fields]))
        np.testing.assert_allclose(np.stack([points[axis] for axis in 'xyz'], axis=1), self.expected_points(), atol=1e-6)
        self.assertEqual({tuple(int(point[channel]) for channel in ('red', 'green', 'blue')) for point in points}, {(200, 30, 40)})

    def test_pcd(self):
        header = self.export(self.capture(), 'pcd').read_bytes().split(b'DATA')[0]
        self.assertIn(b'POINTS %d\n' % len(self.expected_points()), header)

    def test_mcap_is_read_back_and_compared_the_same(self):
        self.frames = noisy(self.floor, FRAMES, 2.0, seed=2)
        capture = self.capture(camera={'model': 'D435', 'serial': '7'}, pose={'pan_deg': 3.0})
        self.out = self.folder / 'capture.mcap'
        self.export(capture, 'mcap')
        read, written = self.info(self.out), self.info(capture)
        for key in ('depth', 'color', 'color_from_depth', 'depth_frames', 'color_frames', 'camera', 'pose'):
            self.assertEqual(read.get(key), written.get(key), key)
        self.check_fails('export', capture, '--to', 'mcap', '--out', self.out, names=['already exists'])
        self.export(capture, 'mcap', '--overwrite')
        before = write_capture(self.folder / 'before', noisy(self.floor, FRAMES, 2.0, seed=9),
                               camera={'model': 'D435', 'serial': '7'}, pose={'pan_deg': 3.0})
        results = {}
        for name in (capture, self.out):
            self.succeed('detect', before, name, '--out', self.folder / 'result', '--overwrite')
            results[name] = json.loads((self.folder / 'result' / 'detections.json').read_text())['detections']
        self.assertEqual(results[capture], results[self.out])

    def test_without_colour_points_are_grey_and_frames_are_refused(self):
        capture = write_capture(self.folder / 'grey', self.frames)
        self.assertIn(b'\x80\x80\x80', self.export(capture, 'ply').read_bytes())
        self.check_fails('export', capture, '--to', 'open3d', '--out', self.folder / 'frames', names=['colour', 'ply'])
        capture = self.capture(color={**CAMERA.fields(), 'distortion_model': 'brown_conrady', 'distortion': [0.1, 0, 0, 0, 0]})
        self.check_fails('export', capture, '--to', 'open3d', '--out', self.folder / 'frames', names=['lens'])

    def test_open3d_where_both_cameras_are_one(self):
        self.export(self.capture(camera={'model': 'D435', 'serial': '7'}), 'open3d')
        matrix = json.loads((self.out / 'intrinsic.json').read_text())
        self.assertEqual(matrix['intrinsic_matrix'], [CAMERA.fx, 0, 0, 0, CAMERA.fy, 0, CAMERA.cx, CAMERA.cy, 1])
        self.assertEqual(matrix['depth_scale'], 1000)
        said = self.info(self.out)
        self.assertEqual((said['format'], said['depth_frames'], said['color_frames'], said['camera']['serial']),
                         ('open3d', FRAMES, FRAMES, '7'))
        inside = (slice(1, -1), slice(1, -5))
        for i in range(FRAMES):
            aligned = read_image(self.out / 'depth' / f'{i:05d}.png')
            # A pixel's corners reach into its neighbours, of which the nearer shows.
            self.assertLessEqual(np.abs(aligned[inside].astype(int) - self.frames[i][inside]).max(), 2)
        self.assertLess(np.abs(read_image(self.out / 'color' / '00000.jpg').astype(int) - RED).max(), 12)

    def test_open3d_beside_each_other(self):
        wall = np.full_like(self.frames[0], 1000)
        wall[20:30, 20:30] = 500
        self.frames = [wall]
        self.export(self.capture(color_from_depth=SHIFTED), 'open3d')
        aligned = read_image(self.out / 'depth' / '00000.png')
        shift_px = round(CAMERA.fx * 0.015 / 0.5)
        self.assertEqual(aligned[25, 25 + shift_px], 500)
        self.assertEqual(aligned[25, 20 + shift_px - 2], 1000)

    def test_a_bag(self):
        bag = write_bag(self.folder / 'a.bag', self.frames, pictures=[(0, RED)])
        self.export(bag, 'open3d')
        self.assertEqual(self.info(self.out)['depth_frames'], FRAMES)

    def test_what_is_there_is_kept_or_replaced(self):
        capture = self.capture()
        self.export(capture, 'ply')
        kept = self.out.read_bytes()
        self.check_fails('export', capture, '--to', 'pcd', '--out', self.out, names=['--overwrite'])
        self.assertEqual(self.out.read_bytes(), kept)
        self.export(capture, 'pcd', '--overwrite')
        self.assertTrue(self.out.read_bytes().startswith(b'#'))
        self.check_fails('export', capture, '--to', 'open3d', '--out', capture, '--overwrite', names=[capture])
        self.assertTrue(contents(capture))

    def test_damaged_and_wrong(self):
        capture = self.capture()
        (capture / 'depth' / '000002.png').write_bytes(b'no image')
        for to in ('ply', 'pcd', 'open3d', 'mcap'):
            self.check_fails('export', capture, '--to', to, '--out', self.out, names=['000002.png'])
        self.check_fails('export', self.capture(), '--to', 'ply', '--out', self.folder / 'none' / 'x.ply', names=['x.ply'])
        for arguments in ((), (capture,), (capture, '--to', 'stl', '--out', self.out), (capture, '--to', 'ply')):
            self.assertEqual(self.rva('export', *arguments).returncode, 2)


class ExportOfInspections(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.data = self.folder / 'data'
        self.succeed('account', 'list', '--data', self.data)  # creates the tables
        self.change("insert into inspection (id, aircraft, zone, work_order, person, created_at, dither) "
                    "values (3, 'N1', 'bay', 'W1', 'Ann', '2026-01-01T00:00:00.000Z', 2)")
        self.change('insert into view values (3, 0, 1.5, -20)')

    def change(self, statement):
        with contextlib.closing(sqlite3.connect(self.data / 'rva.db')) as database, database:
            database.execute(statement)

    def export(self, *options):
        return 'export', '--data', self.data, '--inspection', 3, '--out', self.out, *options

    def test_one_that_was_only_begun(self):
        self.succeed(*self.export())
        record = json.loads((self.out / 'inspection.json').read_text())
        self.assertEqual((record['format'], record['provenance']['program']), ('rva-inspection', 'rva'))
        self.assertEqual(record['inspection']['views'], [{'pan_deg': 1.5, 'tilt_deg': -20.0}])
        self.assertEqual((record['captured'], record['rounds'], record['decisions']), ([], [], []))
        self.check_fails(*self.export(), names=['--overwrite'])
        self.change("update inspection set aircraft = 'N2'")
        self.succeed(*self.export('--overwrite'))
        self.assertEqual(json.loads((self.out / 'inspection.json').read_text())['inspection']['aircraft'], 'N2')

    def test_captures_that_are_lost_are_named(self):
        self.change("insert into side values (3, 'initial', 1, '2026-01-01T00:00:00.000Z', 'Ann', 'b')")
        self.check_fails(*self.export(), names=['000003/initial/000', 'backup'])

    def test_what_does_not_exist_or_is_unclear(self):
        self.check_fails('export', '--data', self.data, '--inspection', 4, '--out', self.out, names=['inspection 4'])
        self.check_fails('export', '--data', self.folder / 'none', '--inspection', 3, '--out', self.out, names=['rva.db'])
        for arguments in (('--inspection', 3), ('--data', self.data), ('--data', self.data, '--inspection', 0),
                          (self.folder, '--to', 'ply', '--data', self.data, '--inspection', 3),
                          ('--data', self.data, '--inspection', 3, '--to', 'ply')):
            self.assertEqual(self.rva('export', *arguments, '--out', self.out).returncode, 2, arguments)


if __name__ == '__main__':
    program.main()
