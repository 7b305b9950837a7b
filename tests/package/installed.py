"""Packages that are installed, upgraded, removed and purged, and the service between."""
import re
import socket
import tempfile
import unittest

from copied_root import CopiedRoot, why_not_mounted
from packages import NAMES
from processes import output_of

DATA = 'var/lib/rva'
CONFIGURATION = 'etc/rva/serve.conf'
UNIT = 'lib/systemd/system/rva-server.service'
# Written by Debian's own tools, whatever is installed.
BY_OTHERS = re.compile(r'(dev/null|etc/(\.pwd\.lock|g?shadow-?|(passwd|group)-?)|var/(cache|log)/.*|var/lib/dpkg/.*)$')
SIMULATED = 'camera = sim:/usr/share/rva/scenes/three-tools.yaml\n'


class Installed(unittest.TestCase):
    packages = None  # set by package_test.py
    root = None
    names = ('rva', 'rva-server')

    @classmethod
    def setUpClass(cls):
        reason = why_not_mounted()
        if reason:
            raise unittest.SkipTest(reason)
        folder = tempfile.TemporaryDirectory(prefix='rva-test-')
        cls.addClassCleanup(folder.cleanup)
        output_of('mount', '-t', 'tmpfs', 'none', folder.name)
        cls.addClassCleanup(output_of, 'umount', '--recursive', folder.name)
        cls.root = CopiedRoot(folder.name)
        # Without it, installing does not renew the index of all manual pages of this machine.
        (cls.root.path / 'var/lib/man-db/auto-update').unlink(missing_ok=True)
        cls.install(*(cls.packages.files[name] for name in cls.names))

    @classmethod
    def install(cls, *files):
        """Lets dpkg check all dependencies against the packages of this machine."""
        return cls.root.output_of('dpkg', '--install', '--force-confdef', '--force-confold', *files)

    def left(self):
        return {name for name in self.root.files() if not BY_OTHERS.match(name)}

    def configuration(self):
        return (self.root.path / CONFIGURATION).read_text()

    def configure(self, text):
        (self.root.path / CONFIGURATION).write_text(text)


class Life(Installed):
    names = NAMES

    def test_from_installation_to_purge(self):
        self.root.output_of('rva', 'account', 'add', 'ann', '--role', 'inspector', '--data', f'/{DATA}', user='rva',
                            input='a long password of ann\n')
        self.configure(self.configuration() + '# edited\n')

        def change(folder):
            (folder / CONFIGURATION).write_text('# another default\n')
        self.install(self.packages.next_revision('rva'), self.packages.next_revision('rva-server', change))
        self.assertEqual(self.root.output_of('dpkg-query', '--show', '--showformat=${Version}', 'rva-server'),
                         f'{self.packages.version}-2')
        self.assertIn('# edited\n', self.configuration())
        self.assertIn('ann', self.root.output_of('rva', 'account', 'list', '--data', f'/{DATA}', user='rva'))

        self.root.output_of('dpkg', '--remove', *NAMES)
        self.assertFalse((self.root.path / 'usr/bin/rva').exists())
        self.assertIn('# edited\n', self.configuration())

        printed = self.root.output_of('dpkg', '--purge', *NAMES)
        self.assertIn(f'the records of inspections remain in /{DATA}', printed)
        self.assertIn(f'{DATA}/rva.db', self.left())
        self.assertEqual([name for name in self.left() if not name.startswith(DATA)], [])


class LifeWithoutRecords(Installed):
    def test_purge_leaves_nothing(self):
        self.assertTrue((self.root.path / DATA).is_dir())
        printed = self.root.output_of('dpkg', '--purge', *self.names)
        self.assertNotIn('remain', printed)
        self.assertFalse((self.root.path / DATA).exists())
        self.assertEqual(self.left(), set())


class PythonModule(Installed):
    names = ('rva', 'python3-rva')

    def test_a_first_finding_in_three_lines(self):
        for name, debris in (('before', "debris='none', "), ('after', 'seed=2, ')):
            self.root.output_of('/usr/bin/python3', '-c', f"""
import rva
rva.simulate('/usr/share/rva/scenes/three-tools.yaml', '/tmp/{name}', {debris}frames=4, supersampling=1)
""")
        printed = self.root.output_of('/usr/bin/python3', '-c', """
import rva
result = rva.detect('/tmp/before', '/tmp/after')
print(result)
""")
        self.assertRegex(printed, r'(?m)^\d finding\(s\), method calibrated, 4 \+ 4 frames\n  1 added, [0-9.]+ x [0-9.]+ mm')


class Service(Installed):
    def serve(self, configuration):
        """Starts what the service starts, as its user, with a configuration with which it cannot run."""
        before = self.configuration()
        self.configure(configuration)
        self.addCleanup(self.configure, before)
        command = re.search(r'^ExecStart=(.*)$', (self.root.path / UNIT).read_text(), re.MULTILINE)[1].split()
        return self.root.run('timeout', '20', *command, user='rva')

    def test_who_may_read_the_records(self):
        self.assertEqual(self.root.output_of('stat', '--format=%U %G %a', f'/{DATA}').strip(), 'rva rva 750')
        groups = self.root.output_of('id', '--name', '--groups', 'rva').split()
        self.assertLessEqual({'dialout', 'plugdev'}, set(groups))

    def test_the_unit_is_valid(self):
        self.assertEqual(self.root.output_of('systemd-analyze', 'verify', '--man=no', f'/{UNIT}'), '')
        # From 0, not exposed at all, to 100; a unit without hardening has 96.
        self.root.output_of('systemd-analyze', 'security', '--offline=yes', '--threshold=20', f'/{UNIT}')

    def test_without_a_camera(self):
        done = self.serve(self.configuration())
        self.assertEqual((done.returncode, done.stderr),
                         (2, 'rva: --camera: is missing; give sim:SCENE, replay:PATH or realsense[:SERIAL]\n'))

    def test_a_misspelt_option(self):
        done = self.serve(self.configuration() + SIMULATED + 'prot = 8080\n')
        self.assertEqual(done.returncode, 2, 'the unit does not try again')
        self.assertIn('prot is not an option of serve', done.stderr)

    def test_a_port_in_use(self):
        with socket.socket() as other:
            other.bind(('127.0.0.1', 0))
            other.listen()
            port = other.getsockname()[1]
            done = self.serve(self.configuration().replace('port = 8080', f'port = {port}') + SIMULATED)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, rf'{port}.*in use.*;')

    def test_any_locale(self):
        for locale in ({}, {'LC_ALL': 'xx_XX.UTF-8'}, {'LC_ALL': 'de_DE.UTF-8', 'LANG': ''}):
            done = self.root.run('rva', 'info', '/tmp/bäy', env={'PATH': '/usr/bin:/usr/sbin'} | locale)
            self.assertEqual(done.returncode, 1, locale)
            self.assertIn('/tmp/bäy', done.stderr)
