"""Signed packages for tests, and both verifiers on them: `rva inspection verify`, and script/verify-record, which contains
none of our code. Each test file sets VERIFIER to the path of the latter."""
import contextlib
import shutil
import sqlite3
import subprocess
import sys

import program

VERIFIER = None
CAPTURE = 'inspections/000003/initial/000'


def flip_bit(path, at=0.5):
    data = bytearray(path.read_bytes())
    data[int(at * (len(data) - 1))] ^= 1
    path.write_bytes(data)


def cover(package):
    """Writes the tag manifest again, so that it fits a changed package: an attacker's way to hide the change."""
    files = [path.relative_to(package).as_posix() for path in package.rglob('*') if path.is_file()]
    tags = sorted(file for file in files if not file.startswith('data/') and file != 'tagmanifest-sha256.txt')
    listed = subprocess.run(['sha256sum', *tags], cwd=package, capture_output=True, check=True).stdout
    (package / 'tagmanifest-sha256.txt').write_bytes(listed)


class SignedPackageTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.data, self.package = self.folder / 'data', self.folder / 'package'
        self.succeed('account', 'list', '--data', self.data)  # creates the tables
        with contextlib.closing(sqlite3.connect(self.data / 'rva.db')) as database, database:
            database.execute("insert into inspection (id, aircraft, zone, work_order, person, created_at, dither) "
                             "values (3, 'N1 \u2713', 'bay', 'W1', 'Ann', '2026-01-01T00:00:00.000Z', 1)")
            database.execute('insert into view values (3, 0, 1.5, -20)')
            database.execute("insert into side values (3, 'initial', 1, '2026-01-01T00:00:00.000Z', 'Ann', 'b')")
        for name, text in (('capture.json', '{}'), ('depth/000000.png', 'pixels'), ('depth/000001.png', 'more pixels')):
            (self.data / CAPTURE / name).parent.mkdir(parents=True, exist_ok=True)
            (self.data / CAPTURE / name).write_text(text)
        self.keys = [self.key(name) for name in ('ann', 'bob', 'log')]

    def key(self, name, folder=''):
        file = self.folder / folder / f'{name}.key'
        file.parent.mkdir(exist_ok=True)
        self.succeed('key', 'create', f'example.com/{name}', '--out', file, '--no-password')
        return file

    def sign(self, out, keys=None, log=None):
        ann, bob, log_key = keys or self.keys
        self.succeed('inspection', 'export', '--data', self.data, '--inspection', 3, '--key', ann, '--key', bob,
                     '--log-key', log_key, '--out', out, *(['--log', log] if log else []))
        return out

    def trusted(self):
        return [argument for key in self.keys for argument in ('--key', f'{key}.pub')]

    def verdicts(self, package, *options):
        """The exit statuses of both verifiers, and what ours reports."""
        ours = self.rva('inspection', 'verify', package, *options)
        theirs = subprocess.run([sys.executable, '-B', VERIFIER, package, *map(str, options)], capture_output=True, text=True,
                                check=False)
        self.assertNotIn('Traceback', theirs.stderr)
        if ours.returncode:
            self.check_line(ours.stderr)
        return ours.returncode, theirs.returncode, ours.stdout + ours.stderr + theirs.stderr

    def check_accepted(self, *arguments):
        ours, theirs, text = self.verdicts(*arguments)
        self.assertEqual((ours, theirs), (0, 0), text)
        return text

    def check_refused(self, *arguments, names=''):
        ours, theirs, text = self.verdicts(*arguments)
        self.assertEqual((ours, theirs), (1, 1), text)
        self.assertIn(names, text)

    def damaged(self, change):
        copy = self.folder / 'copy'
        shutil.rmtree(copy, ignore_errors=True)
        shutil.copytree(self.package, copy)
        change(copy)
        return copy
