"""The program under test, run as a person runs it. Each test file gets its path as the first argument."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = None
TIMEOUT_S = 60


def main():
    global PROGRAM
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()


def is_sanitized():
    return b'__asan_init' in pathlib.Path(PROGRAM).read_bytes()


class ProgramTest(unittest.TestCase):
    """Gives each test a folder of its own."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix='rva-test-')
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name).resolve()
        self.out = self.folder / 'out'

    def command(self, *arguments):
        return [PROGRAM, *(a if isinstance(a, bytes) else str(a) for a in arguments)]

    def rva(self, *arguments, timeout=TIMEOUT_S, stdout=subprocess.PIPE, preexec=None):
        return subprocess.run(self.command(*arguments), stdin=subprocess.DEVNULL, stdout=stdout,
                              stderr=subprocess.PIPE, encoding='utf-8', timeout=timeout, preexec_fn=preexec,
                              cwd=self.folder)

    def succeed(self, *arguments, status=0):
        done = self.rva(*arguments)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def names(self):
        """Every file and folder in the test's folder."""
        return sorted(os.fsencode(path) for path in self.folder.rglob('*'))

    def check_fails(self, *arguments, names=(), **run):
        """Runs what must fail as the contract states: status 1, one clear line, nothing left behind."""
        before = self.names()
        done = self.rva(*arguments, **run)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.check_line(done.stderr, names)
        self.assertFalse(done.stdout, 'a failure prints no result')
        self.assertEqual(self.names(), before, 'something was left behind, or taken away')
        return done

    def check_line(self, stderr, names=()):
        """One line: where, what is wrong, what to do."""
        self.assertRegex(stderr, r'\Arva: [^\n]+: [^\n]+; [^\n]+\n\Z')
        self.assertNotIn('internal error', stderr)
        for name in names:
            self.assertIn(str(name), stderr)

    def detect(self, initial, final, *options, status=0, out=None):
        """A detection that works; gives what detections.json holds."""
        out = out or self.out
        self.succeed('detect', initial, final, '--out', out, *options, status=status)
        return json.loads((out / 'detections.json').read_text())

    def info(self, capture, *options):
        return json.loads(self.succeed('info', capture, '--json', *options).stdout)

    def on_a_terminal(self, *arguments):
        """What a person sees on stderr when that is a terminal; stdout is not."""
        ours, theirs = os.openpty()
        with subprocess.Popen(self.command(*arguments), stdout=subprocess.DEVNULL, stderr=theirs,
                              stdin=subprocess.DEVNULL, cwd=self.folder) as process:
            os.close(theirs)
            seen = b''.join(iter(lambda: read_terminal(ours), b''))
            self.assertEqual(process.wait(TIMEOUT_S), 0, seen)
        os.close(ours)
        return seen.decode()


def read_terminal(terminal):
    try:
        return os.read(terminal, 1 << 16)
    except OSError:  # the other end is closed
        return b''
