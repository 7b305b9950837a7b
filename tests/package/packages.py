"""The Debian packages of the build: made once, in a temporary folder, and read."""
import os
import pathlib
import re
import shutil
import tempfile

from processes import output_of, run

NAMES = ('librva-dev', 'python3-rva', 'rva', 'rva-server')
FAST_NOT_SMALL = {'DPKG_DEB_COMPRESSOR_TYPE': 'gzip', 'DPKG_DEB_COMPRESSOR_LEVEL': '1'}
FAST = os.environ | FAST_NOT_SMALL
TOOLS = ('dh', 'dpkg-shlibdeps', 'help2man', 'lintian')  # with all of them, script/package downloads nothing


def why_not_made(root):
    """Why packages cannot be made here, or nothing."""
    missing = [tool for tool in TOOLS if not shutil.which(tool)]
    if missing:
        return f'{", ".join(missing)} missing; script/bootstrap --package installs them'
    if not (root / 'build' / 'console' / 'index.html').exists():
        return 'the console is not built; script/console builds it'
    return ''


class Packages:
    """What script/package makes of the build of a repository; paths by name in `files`."""

    def __init__(self, root):
        self.root = root
        self.temporary = tempfile.TemporaryDirectory(prefix='rva-test-')
        self.folder = pathlib.Path(self.temporary.name)
        printed = output_of(root / 'script' / 'package', '1', self.folder, env=FAST)
        self.files = {pathlib.Path(line).name.partition('_')[0]: pathlib.Path(line) for line in printed.splitlines()}
        self.version = re.search(r'project\(rva VERSION (\S+)', (root / 'CMakeLists.txt').read_text())[1]

    def field(self, name, field):
        return output_of('dpkg-deb', '--field', self.files[name], field).strip()

    def depends(self, name):
        """The packages that it depends on, without versions and alternatives."""
        return {re.match(r'[a-z0-9.+-]+', entry)[0] for entry in self.field(name, 'Depends').split(', ')}

    def unpacked(self, name):
        """A folder with the files of the package and, in DEBIAN/, its control files."""
        folder = self.folder / 'unpacked' / name
        if not folder.exists():
            folder.parent.mkdir(exist_ok=True)
            output_of('dpkg-deb', '--raw-extract', self.files[name], folder)
        return folder

    def next_revision(self, name, change=None):
        """The package with revision 2, after change(folder of its files). @return its path"""
        folder = self.folder / 'next' / name
        shutil.copytree(self.unpacked(name), folder, symlinks=True, dirs_exist_ok=True)
        control = folder / 'DEBIAN' / 'control'
        control.write_text(control.read_text().replace(f'{self.version}-1', f'{self.version}-2'))
        if change:
            change(folder)
        made = self.folder / f'{name}_next.deb'
        output_of('dpkg-deb', '--build', '--root-owner-group', folder, made, env=FAST)
        return made


def owners_of(paths):
    """The installed Debian packages that files belong to, in the order of the paths."""
    # dpkg has them by the names with which they were installed: before or after /lib became a link to /usr/lib.
    names = [{path, os.path.realpath(path), path.removeprefix('/usr')} for path in paths]
    printed = run('dpkg-query', '--search', *set().union(*names)).stdout
    owners = {line.partition(': ')[2]: line.partition(':')[0] for line in printed.splitlines()}
    return [next(owners[name] for name in same if name in owners) for same in names]
