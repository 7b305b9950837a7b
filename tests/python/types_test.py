"""The stubs fit the module, and type checkers accept a program that uses it. Skipped where mypy is missing."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv[2]).resolve()
PACKAGE = pathlib.Path(os.environ['PYTHONPATH'])
SKIPPED = 77
WRONG = '''import rva
finding = rva.detect('before', 'after', min_blob='large').findings[0]
finding.height = 3
'''


class Types(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix='rva-test-')
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)  # with mypy's cache: reading numpy takes most of its time

    def check(self, *command, **environment):
        return subprocess.run([*map(str, command)], capture_output=True, text=True, timeout=250, cwd=self.folder,
                              env={**os.environ, **environment})

    def mypy(self, file):
        return self.check('/usr/bin/mypy', '--strict', '--cache-dir', self.folder / 'cache', file, MYPYPATH=str(PACKAGE))

    def stubtest(self, package):
        return self.check('/usr/bin/stubtest', 'rva', '--allowlist', ROOT / 'tests' / 'python' / 'stubtest_allowlist.txt',
                          MYPYPATH=str(package), PYTHONPATH=str(package))

    def test_stubs_describe_the_module(self):
        done = self.stubtest(PACKAGE)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_stubs_that_lack_something_are_refused(self):
        stubs = self.folder / 'stubs' / 'rva'
        shutil.copytree(PACKAGE / 'rva', stubs)
        text = (stubs / '__init__.pyi').read_text()
        self.assertIn('    min_blob: int = ...,\n', text)
        (stubs / '__init__.pyi').write_text(text.replace('    min_blob: int = ...,\n', ''))
        done = self.stubtest(stubs.parent)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn('min_blob', done.stdout)

    def test_an_example_is_accepted(self):
        done = self.mypy(ROOT / 'examples' / 'detect.py')
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_wrong_programs_are_refused(self):
        program = self.folder / 'wrong.py'
        program.write_text(WRONG)
        done = self.mypy(program)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn('min_blob', done.stdout)
        self.assertIn('"Finding" has no attribute "height"', done.stdout)


if __name__ == '__main__':
    if not shutil.which('/usr/bin/stubtest'):
        print('skipped: mypy is missing; script/bootstrap --all installs it')
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1], verbosity=2)
