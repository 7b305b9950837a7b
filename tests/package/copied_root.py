"""This machine's files, copied on write: packages are installed there, and the machine stays as it is."""
import os
import pathlib
import sys
import tempfile

from processes import output_of, run

IN_NAMESPACE = 'RVA_TEST_MOUNTS'


def enter_mount_namespace():
    """Runs this program again with mounts of its own, if it may have them."""
    if os.geteuid() == 0 and IN_NAMESPACE not in os.environ and run('unshare', '--mount', 'true').returncode == 0:
        os.environ[IN_NAMESPACE] = '1'
        os.execvp('unshare', ['unshare', '--mount', sys.executable, '-B', *sys.argv])


def why_not_mounted():
    """Why there can be no such root, or nothing."""
    if IN_NAMESPACE not in os.environ:
        return 'only root may mount, in a namespace of its own'
    with tempfile.TemporaryDirectory(prefix='rva-test-') as folder:
        done = run('mount', '-t', 'tmpfs', 'none', folder)
        if done.returncode == 0:
            try:
                CopiedRoot(folder)
            except AssertionError as failure:
                done.stderr, done.returncode = str(failure), 1
            output_of('umount', '--recursive', folder)
    return f'no files that are copied on write: {done.stderr.strip()}' if done.returncode else ''


class CopiedRoot:
    """Mounted in a folder that is on a tmpfs. `path` is its root, `written` has what differs from the machine."""

    def __init__(self, folder):
        folder = pathlib.Path(folder)
        self.path, self.written, work = folder / 'root', folder / 'written', folder / 'work'
        for each in (self.path, self.written, work):
            each.mkdir()
        output_of('mount', '-t', 'overlay', 'overlay', '-o', f'lowerdir=/,upperdir={self.written},workdir={work}', self.path)
        output_of('mount', '-t', 'proc', 'proc', self.path / 'proc')

    def run(self, *command, user='root', **options):
        return run('chroot', f'--userspec={user}', '--groups=', self.path, *command, **options)

    def output_of(self, *command, **options):
        done = self.run(*command, **options)
        if done.returncode:
            raise AssertionError(f'{command}: {done.stdout}{done.stderr}')
        return done.stdout + done.stderr

    def files(self):
        """The files that were written, relative to the root; character devices mark those that were deleted."""
        return {str(path.relative_to(self.written)) for path in self.written.rglob('*') if path.is_file()}
