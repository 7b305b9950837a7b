"""The installed package, in a folder that it was moved to, and the sources embedded in another project.

usage: install_test.py CMAKE COMPILER BUILD REPOSITORY
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

CMAKE, COMPILER = sys.argv[1:3]
BUILD, ROOT = map(pathlib.Path, sys.argv[3:5])
HERE = ROOT / 'tests' / 'install'
CAPTURES = [ROOT / 'data' / 'bin-tools' / side for side in ('initial', 'final')]
TIMEOUT_S = 300
CONSOLE = BUILD / 'console' / 'index.html'  # script/console builds it
WITHOUT_OPENCV = ('-DCMAKE_DISABLE_FIND_PACKAGE_OpenCV=ON',)


def run(*command):
    return subprocess.run([*map(str, command)], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          timeout=TIMEOUT_S)


class InstallTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix='rva-test-')
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name).resolve()
        done = run(CMAKE, '--install', BUILD, '--prefix', cls.folder / 'first')
        if done.returncode:
            raise AssertionError(done.stderr)
        cls.prefix = (cls.folder / 'first').rename(cls.folder / 'moved')

    def setUp(self):
        self.project = self.folder / self.id()
        self.project.mkdir()

    def succeed(self, *command):
        done = run(*command)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def configure(self, sources, *options):
        return run(CMAKE, '-S', sources, '-B', self.project / 'build', '-G', 'Ninja', '-DCMAKE_BUILD_TYPE=Release',
                   f'-DCMAKE_CXX_COMPILER={COMPILER}', f'-DCMAKE_PREFIX_PATH={self.prefix}', *options)

    def find(self, arguments, *options):
        """Configures a project that only finds the package. @return its messages, with single spaces"""
        lines = ('cmake_minimum_required(VERSION 3.25)', 'project(finds LANGUAGES CXX)', f'find_package(rva {arguments})',
                 'message(STATUS "found ${rva_FOUND}, detect ${rva_detect_FOUND}, version ${rva_VERSION}")')
        (self.project / 'CMakeLists.txt').write_text('\n'.join(lines))
        done = self.configure(self.project, *options)
        return done.returncode, ' '.join((done.stdout + done.stderr).split())

    def test_what_is_installed(self):
        self.assertEqual(self.succeed(self.prefix / 'bin' / 'rva', '--version'), '0.1.0\n')
        self.assertIn('Apache License', (self.prefix / 'share' / 'doc' / 'rva' / 'LICENSE').read_text())
        self.assertEqual((self.prefix / 'share' / 'rva' / 'console' / 'index.html').exists(), CONSOLE.exists())
        headers = self.prefix / 'include' / 'rva'
        sources = ROOT / 'src'
        self.assertEqual({path.relative_to(headers) for path in headers.rglob('*.*')},
                         {path.relative_to(sources) for path in sources.rglob('*.hpp')
                          if 'cli' not in path.relative_to(sources).parts})

    def test_no_file_names_a_folder_of_the_build(self):
        folders = [str(folder).encode() for folder in (ROOT, BUILD, self.folder)]
        files = [path for path in self.prefix.rglob('*') if path.is_file()]
        self.assertGreater(len(files), 100)
        for path in files:
            content = path.read_bytes()
            for folder in folders:
                self.assertNotIn(folder, content, path.name)

    def test_a_program_finds_what_rva_finds(self):
        done = self.configure(HERE / 'consumer')
        self.assertEqual(done.returncode, 0, done.stderr)
        self.succeed(CMAKE, '--build', self.project / 'build')
        printed = self.succeed(self.project / 'build' / 'consumer', *CAPTURES)
        result = self.succeed(self.prefix / 'bin' / 'rva', 'detect', *CAPTURES, '--json', '--out', self.project / 'out')
        expected = [[entry['kind'], entry['area_px'], *entry['bbox']] for entry in json.loads(result)['detections']]
        self.assertGreaterEqual(len(expected), 3)
        self.assertEqual([line.split() for line in printed.splitlines()],
                         [[str(value) for value in entry] for entry in expected])

    def test_all_components_are_found(self):
        self.assertRegex(self.find('REQUIRED')[1], 'found 1, detect TRUE, version 0.1.0')

    def test_an_unknown_component_is_refused(self):
        status, messages = self.find('REQUIRED COMPONENTS detect wings')
        self.assertEqual(status, 1)
        self.assertRegex(messages, r'There is no component wings\. The components are core, [a-z, ]*detect, [a-z, ]*store\.')

    def test_other_versions_are_refused(self):
        for version in ('9', '0.2'):
            with self.subTest(version):
                status, messages = self.find(f'{version} REQUIRED COMPONENTS core')
                self.assertEqual(status, 1)
                self.assertIn(f'compatible with requested version "{version}"', messages)
                self.assertIn('rvaConfig.cmake, version: 0.1.0', messages)

    def test_a_component_needs_only_what_it_links_to(self):
        status, messages = self.find('REQUIRED COMPONENTS core', *WITHOUT_OPENCV)
        self.assertEqual(status, 0, messages)

    def test_a_missing_package_is_stated(self):
        status, messages = self.find('REQUIRED COMPONENTS detect', *WITHOUT_OPENCV)
        self.assertEqual(status, 1)
        self.assertIn('Component detect links to opencv_core, opencv_imgproc: not found.', messages)

    def test_an_optional_component_may_be_missing(self):
        status, messages = self.find('COMPONENTS core OPTIONAL_COMPONENTS detect', *WITHOUT_OPENCV)
        self.assertEqual(status, 0, messages)
        self.assertIn('found 1, detect FALSE', messages)

    def test_sources_embedded_in_another_project(self):
        done = self.configure(HERE / 'embedding', f'-DRVA_SOURCES={ROOT}', '-DCMAKE_CXX_FLAGS_RELEASE=-O1')
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("flags: '-O1' '' ''\n", done.stdout)
        self.assertIn('options: OFF OFF OFF\n', done.stdout)
        commands = self.succeed('ninja', '-C', self.project / 'build', '-t', 'commands', 'all')
        self.assertNotIn('-Werror', commands)
        self.assertIn('/src/detect/detect.cpp', commands)
        self.assertNotIn('/src/cli/', commands)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1], verbosity=2, warnings='ignore')
