"""What the packages contain, state and depend on."""
import itertools
import pathlib
import re
import shutil
import sys
import unittest

from packages import NAMES, owners_of
from processes import output_of, run

BASH_COMPLETION = '/usr/share/bash-completion/bash_completion'
# Only Debian's own archive asks for the bug that a first version closes, and for the shop of its desktops.
NOT_FOR_THIS_ARCHIVE = 'initial-upload-closes-no-bugs,appstream-metadata-missing-modalias-provide'


def commands_of(help_text):
    return re.findall(r'^  ([a-z-]+) ', help_text.partition('\nSubcommands:\n')[2], re.MULTILINE)


def options_of(help_text):
    return re.findall(r'^ {2,4}(?:-h,)?(--[a-z-]+)', help_text, re.MULTILINE)


class Contents(unittest.TestCase):
    packages = None  # set by package_test.py

    def setUp(self):
        self.program = self.packages.unpacked('rva') / 'usr' / 'bin' / 'rva'

    def all_commands(self):
        """Each command with the words after rva, and its help."""
        waiting = [()]
        while waiting:
            command = waiting.pop()
            text = output_of(self.program, *command, '--help')
            yield command, text
            waiting += [(*command, name) for name in commands_of(text)]

    def completed(self, line):
        """What the completion offers at the end of a line."""
        script = self.packages.unpacked('rva') / 'usr' / 'share' / 'bash-completion' / 'completions' / 'rva'
        done = output_of('bash', '-c', f'. {BASH_COMPLETION}; . {script}; COMP_LINE=$1; COMP_POINT=${{#1}}; '
                         'mapfile -t -d " " COMP_WORDS < <(printf %s "$1"); COMP_WORDS=("${COMP_WORDS[@]% }"); '
                         '[[ $1 == *" " ]] && COMP_WORDS+=(""); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _rva; '
                         'printf "%s\\n" "${COMPREPLY[@]}"', 'bash', line,
                         env={'PATH': f'{self.program.parent}:/usr/bin:/bin'})
        return done.split()

    def test_fields(self):
        self.assertEqual(set(self.packages.files), set(NAMES))
        for name, architecture in zip(NAMES, ('amd64', 'amd64', 'amd64', 'all')):
            self.assertEqual(self.packages.field(name, 'Version'), f'{self.packages.version}-1')
            self.assertEqual(self.packages.field(name, 'Architecture'), architecture)
            self.assertRegex(self.packages.field(name, 'Maintainer'), r'^RVA .* <.*@.*>$')

    def test_the_program_depends_on_what_it_links_to(self):
        needed = re.findall(r'\(NEEDED\).*\[(.+)\]', output_of('readelf', '--dynamic', self.program))
        paths = dict(re.findall(r'(\S+) => (\S+)', output_of('ldd', self.program)))
        libraries = set(owners_of([paths[library] for library in needed if library in paths]))
        self.assertGreater(len(libraries), 10)
        self.assertLessEqual(libraries, self.packages.depends('rva'))

    def test_the_libraries_depend_on_what_their_users_build_with(self):
        self.assertLessEqual({'libeigen3-dev', 'libfmt-dev', 'libopencv-dev', 'libsqlitecpp-dev', 'libtiff-dev', 'libssl-dev',
                              'nlohmann-json3-dev'}, self.packages.depends('librva-dev'))
        self.assertNotIn('libgtest-dev', self.packages.depends('librva-dev'))

    def test_the_module_depends_on_the_python_that_it_was_built_for(self):
        module = self.packages.unpacked('python3-rva') / 'usr' / 'lib' / 'python3' / 'dist-packages' / 'rva'
        self.assertEqual({re.sub(r'cpython-\d+', 'cpython', path.name) for path in module.iterdir()},
                         {'__init__.cpython-x86_64-linux-gnu.so', '__init__.pyi', 'py.typed'})
        major, minor = sys.version_info[:2]
        self.assertTrue(next(module.glob('*.so')).name.startswith(f'__init__.cpython-{major}{minor}-'))
        depends = self.packages.field('python3-rva', 'Depends')
        self.assertIn(f'python3 (>= {major}.{minor}), python3 (<< {major}.{minor + 1})', depends)
        self.assertLessEqual({'libc6', 'libembree3-3', 'libfmt9'}, self.packages.depends('python3-rva'))
        self.assertEqual(self.packages.field('python3-rva', 'Recommends'), 'python3-numpy')

    def test_the_service_runs_with_its_own_program(self):
        self.assertIn(f'rva (= {self.packages.version}-1)', self.packages.field('rva-server', 'Depends'))

    def test_no_file_names_a_folder_of_the_build(self):
        folders = [str(folder).encode() for folder in (self.packages.root, self.packages.folder)]
        files = [path for name in NAMES for path in self.packages.unpacked(name).rglob('*') if path.is_file()]
        self.assertGreater(len(files), 200)
        for path, folder in itertools.product(files, folders):
            self.assertNotIn(folder, path.read_bytes(), path)

    def test_no_file_is_in_two_packages(self):
        files = [{path.relative_to(folder) for path in folder.rglob('*') if path.is_file() and 'DEBIAN' not in path.parts}
                 for folder in map(self.packages.unpacked, NAMES)]
        for one, other in itertools.combinations(files, 2):
            self.assertFalse(one & other)

    def test_each_command_has_a_page_with_its_options(self):
        pages = self.packages.unpacked('rva') / 'usr' / 'share' / 'man' / 'man1'
        names = set()
        for command, text in self.all_commands():
            name = '-'.join(('rva', *command))
            names.add(f'{name}.1.gz')
            page = output_of('zcat', pages / f'{name}.1.gz').replace('\\-', '-')
            self.assertRegex(page, rf'(?m)^\.SH NAME\n{name} - ..')
            for option in options_of(text) + commands_of(text):
                self.assertIn(option, page, name)
        self.assertGreater(len(names), 20)
        self.assertEqual({path.name for path in pages.iterdir()}, names)

    @unittest.skipUnless(pathlib.Path(BASH_COMPLETION).exists(), 'bash-completion is not installed')
    def test_completion(self):
        for command, text in self.all_commands():
            line = ' '.join(('rva', *command, ''))
            self.assertEqual(set(self.completed(line + '--')), set(options_of(text)), line)
            if commands_of(text):
                self.assertEqual(set(self.completed(line)), set(commands_of(text)), line)
        self.assertEqual(self.completed('rva insp'), ['inspection'])
        self.assertEqual(self.completed('rva inspection re'), ['report', 'rerun'])
        self.assertEqual(self.completed('rva detect --method c'), ['constant', 'calibrated'])

    def test_lintian_finds_no_error(self):
        # librva-dev would take half a minute; script/package has no part that concerns it alone.
        done = run('lintian', '--fail-on', 'error,warning', '--suppress-tags', NOT_FOR_THIS_ARCHIVE,
                   self.packages.files['rva'], self.packages.files['rva-server'], self.packages.files['python3-rva'])
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


class BadInput(unittest.TestCase):
    packages = None

    def check_refused(self, script, *arguments, message):
        done = run(script, *arguments)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(message, done.stderr)

    def test_packages_before_a_build(self):
        script = self.packages.folder / 'unbuilt' / 'script' / 'package'
        script.parent.mkdir(parents=True)
        shutil.copy(self.packages.root / 'script' / 'package', script)
        self.check_refused(script, message='package: build/rva is missing; run script/build first\n')

    def test_a_revision_that_is_none(self):
        for revision in ('0', '-1', '1.5', '--help', '1\n2'):
            self.check_refused(self.packages.root / 'script' / 'package', revision, message='give a number from 1')

    def test_a_folder_that_cannot_be_written(self):
        self.check_refused(self.packages.root / 'script' / 'package', '1', '/proc/packages', message='cannot be written')
