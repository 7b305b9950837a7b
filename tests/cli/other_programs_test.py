"""What RVA writes, opened by other programs. Those that are not installed are named, and their tests skipped.

usage: other_programs_test.py RVA READER MODULES TEST     exits with 77 where the other program is missing
    READER   tests/capture/mcap/other_reader.mjs
    MODULES  a folder with npm's @mcap/core and fzstd (`npm install --prefix FOLDER @mcap/core fzstd`)
"""
import os
import shutil
import subprocess
import sys
import unittest

import numpy as np

import program
from captures import CAMERA, IDENTITY, noisy, plain_color, write_capture

FRAMES = 4
RED = plain_color(CAMERA.width, CAMERA.height, (200, 30, 40))


def module(name):
    try:
        return __import__(name)
    except ImportError:
        return None


class OtherPrograms(program.ProgramTest):
    reader = modules = None

    def setUp(self):
        super().setUp()
        self.floor = CAMERA.plane(1000, per_column=2)
        self.floor[:, -4:] = 0
        self.capture = write_capture(self.folder / 'capture', noisy(self.floor, FRAMES, 0.0, seed=1), pictures=[RED],
                                     color=CAMERA.fields(), color_from_depth=IDENTITY)
        v, u = np.nonzero(self.floor)
        self.points = CAMERA.deproject(u, v, self.floor[v, u] / 1000)

    def export(self, to):
        file = self.folder / f'out.{to}'
        self.succeed('export', self.capture, '--to', to, '--out', file)
        return file

    def check_cloud(self, points, colors=None):
        """`points` in any order, with what ASCII files round."""
        self.assertEqual(len(points), len(self.points))
        np.testing.assert_allclose(np.sort(points, axis=0), np.sort(self.points, axis=0), atol=1e-5)
        if colors is not None:
            np.testing.assert_allclose(np.asarray(colors), np.tile((200, 30, 40), (len(points), 1)), atol=1)

    def test_open3d_opens_clouds(self):
        open3d = module('open3d')
        if open3d is None:
            self.skipTest('open3d is not installed (pip install open3d)')
        for to in ('ply', 'pcd'):
            cloud = open3d.io.read_point_cloud(str(self.export(to)))
            self.check_cloud(np.asarray(cloud.points), 255 * np.asarray(cloud.colors))

    def test_meshlab_opens_clouds(self):
        pymeshlab = module('pymeshlab')
        if pymeshlab is None:
            self.skipTest('pymeshlab is not installed (pip install pymeshlab)')
        meshes = pymeshlab.MeshSet()
        meshes.load_new_mesh(str(self.export('ply')))
        mesh = meshes.current_mesh()
        self.check_cloud(mesh.vertex_matrix(), 255 * mesh.vertex_color_matrix()[:, :3])

    def test_cloudcompare_opens_clouds(self):
        cloudcompare = shutil.which('CloudCompare') or shutil.which('cloudcompare.CloudCompare')
        if cloudcompare is None:
            self.skipTest('CloudCompare is not installed (apt install cloudcompare)')
        # PLY alone: Debian's CloudCompare has no plugin for PCD.
        file, text = self.export('ply'), self.folder / 'ply.txt'
        done = subprocess.run([cloudcompare, '-SILENT', '-AUTO_SAVE', 'OFF', '-O', file, '-C_EXPORT_FMT', 'ASC', '-PREC', '8', '-SEP', 'SPACE',
                               '-SAVE_CLOUDS', 'FILE', text], capture_output=True, text=True, timeout=120,
                              env={**os.environ, 'QT_QPA_PLATFORM': 'offscreen'})
        self.assertTrue(text.exists(), done.stdout + done.stderr)
        values = np.loadtxt(text)
        self.check_cloud(values[:, :3], values[:, 3:6])

    def test_a_public_reader_opens_mcap(self):
        file = self.export('mcap')
        done = subprocess.run(['node', self.reader, file, str(FRAMES), self.modules], capture_output=True, text=True, timeout=60)
        if done.returncode == 77:
            self.skipTest(done.stdout.strip())
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


def main():
    program.PROGRAM = os.path.abspath(sys.argv[1])
    OtherPrograms.reader, OtherPrograms.modules, test = sys.argv[2:]
    result = unittest.TextTestRunner().run(OtherPrograms(test))
    for _, why in result.skipped:
        print('SKIPPED:', why)
    if not result.wasSuccessful():
        return 1
    return 77 if result.skipped else 0


if __name__ == '__main__':
    sys.exit(main())
