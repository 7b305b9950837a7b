"""The comments of the headers fit the code: Doxygen reports nothing; each type and folder has a description.

usage: reference_test.py REPOSITORY
Exits with status 77 where Doxygen is missing.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv[1])
SKIPPED = 77
# Folders of src/ in whose headers every member has a description.
COMPLETE = ('audit', 'camera', 'capture', 'cli', 'core', 'depth', 'doctor', 'evaluate', 'geometry', 'infrared', 'map', 'measure', 'plan',
            'robot', 'scene', 'sim', 'stereo', 'views')


def warnings(*settings):
    """What Doxygen reports with the settings of docs/Doxyfile and these."""
    with tempfile.TemporaryDirectory() as folder:
        configuration = [(ROOT / 'docs' / 'Doxyfile').read_text(), *settings, f'OUTPUT_DIRECTORY = "{folder}"']
        run = subprocess.run(['doxygen', '-'], cwd=ROOT, input='\n'.join(configuration), capture_output=True,
                             text=True, timeout=300)
    if run.returncode:
        raise RuntimeError(f'doxygen ended with status {run.returncode}: {run.stderr}')
    return run.stderr.splitlines()


class Reference(unittest.TestCase):
    def test_comments_fit_the_code(self):
        self.assertEqual(warnings(), [])

    def test_each_type_has_a_description(self):
        missing = re.compile(r'(Compound|\((typedef|enumeration)\)).* is not documented')
        found = warnings('WARN_IF_UNDOCUMENTED = YES')
        self.assertEqual([line for line in found if missing.search(line)], [])

    def test_each_member_of_complete_folders_has_a_description(self):
        complete = re.compile(rf'src/({"|".join(COMPLETE)})/.* is not documented')
        found = warnings('WARN_IF_UNDOCUMENTED = YES')
        self.assertEqual([line for line in found if complete.search(line)], [])

    def test_wrong_comments_are_reported(self):
        with tempfile.TemporaryDirectory() as folder:
            header = pathlib.Path(folder) / 'wrong.hpp'
            header.write_text('// A file.\n#pragma once\n\n'
                              '/// Doubles.\n/// @param number a number\nint twice(int x);\n')
            found = '\n'.join(warnings(f'INPUT = "{folder}"'))
        self.assertRegex(found, "wrong.hpp:.*argument 'number' of command @param")

    def test_each_folder_has_a_description(self):
        pages, sources = (ROOT / 'docs' / 'reference.dox').read_text(), ROOT / 'src'
        described = re.findall(r'^/\*\* @dir (\S+)$', pages, re.MULTILINE)
        folders = {path.parent.relative_to(sources).as_posix() for path in sources.rglob('*.hpp')}
        self.assertEqual(sorted(described), sorted(folders))


if __name__ == '__main__':
    if not shutil.which('doxygen'):
        print('reference_test: Doxygen is missing; script/bootstrap --all installs it')
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1], verbosity=2)
