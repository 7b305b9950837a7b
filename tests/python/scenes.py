"""Simulated captures for the tests of this folder; the program and the repository that they were given.

usage of each test: TEST RVA REPOSITORY, with the module on PYTHONPATH
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM, ROOT = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
SCENE = ROOT / 'data' / 'scenes' / 'three-tools.yaml'
FRAMES, SUPERSAMPLING = 4, 1  # as few as the calibrated method needs, at the least cost
# What results state about their making is repeatable with it.
os.environ['SOURCE_DATE_EPOCH'] = '1700000000'


def program(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], stdin=subprocess.DEVNULL, capture_output=True,
                          encoding='utf-8', timeout=120)


def contents(folder):
    """Every file of a folder, by its path inside."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob('*') if path.is_file()}


class Captured(unittest.TestCase):
    """Has a bay before and after the work."""

    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix='rva-test-')
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name).resolve()
        cls.before, cls.after = cls.folder / 'before', cls.folder / 'after'
        for seed, out, more in ((1, cls.before, ('--debris', 'none')), (2, cls.after, ())):
            done = program('simulate', SCENE, '--out', out, '--frames', FRAMES, '--seed', seed, '--supersampling',
                           SUPERSAMPLING, *more)
            if done.returncode:
                raise AssertionError(done.stderr)

    def succeed(self, *arguments):
        done = program(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def fail_with(self, *arguments):
        """What the program prints as it refuses, without its name."""
        done = program(*arguments)
        self.assertIn(done.returncode, (1, 2), done.stdout)
        self.assertTrue(done.stderr.startswith('rva: '), done.stderr)
        return done.stderr.removeprefix('rva: ').removesuffix('\n')


def main():
    unittest.main(argv=sys.argv[:1], verbosity=2)
