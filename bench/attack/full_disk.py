#!/usr/bin/python3
"""Fills the disk while an inspection is signed, at different moments, and reports what was lost or is left over.

usage: full_disk.py [--times 20] [--rva build/rva] [--console DIR] [--work DIR]

A closed inspection lies on a file system in memory with room for less than its signed package. Signing has to fail with a
sentence that names the disk, and to leave nothing behind; once there is room, it has to succeed, and every package has to
verify. Needs user namespaces (unshare), as Debian has them.
"""
import argparse
import copy
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from inspection_stages import Story, WithoutRobot, start
from inspection_steps import PASSWORD, Steps
from ledger import is_remains
from record_checks import check_packages
from server import Refused
from setting import Setting, Unusable
from stored import integrity

ROOT = pathlib.Path(__file__).resolve().parents[2]
IN_NAMESPACE = 'RVA_FULL_DISK_IN_NAMESPACE'
PAGE = 4096


def size_of(folder):
    return sum(-(-path.stat().st_size // PAGE) * PAGE for path in folder.rglob('*') if path.is_file())


def mount(disk, size, *options):
    subprocess.run(['mount', '-t', 'tmpfs', '-o', ','.join([f'size={size // PAGE * PAGE}', *options]), 'tmpfs', disk], check=True)


def faults_of(setting, story, sign, disk, room):
    """Signs with `room` bytes left, then with room enough."""
    kept, known, _ = story.before(setting, sign)
    ledger, faults = copy.deepcopy(known), []
    mount(disk, size_of(kept) + 64 * PAGE + room)
    try:
        data = disk / 'data'
        shutil.copytree(kept, data)
        server = start(setting, story.rig, data, setting.folder / 'full.log', True, ledger)
        try:
            try:
                server.do('inspections/%d/sign' % ledger.current, {'password': PASSWORD})
                faults.append('signing succeeded: there was room enough')
            except Refused as refused:
                if 'No space left' not in str(refused) and 'disk is full' not in str(refused):
                    faults.append(f'the reason is not stated: {refused}')
            faults += [f'{path.relative_to(data)} is left over' for path in data.rglob('*') if is_remains(path.relative_to(data))]
            faults += [problem.text for problem in check_packages(setting, ledger, data)]
            mount(disk, 2 * size_of(kept) + (1 << 30), 'remount')
            Steps(setting, server, ledger, data).sign()
            faults += [problem.text for problem in check_packages(setting, ledger, data)]
        finally:
            server.stop()
        faults += integrity(data / 'rva.db')
    finally:
        subprocess.run(['umount', disk], check=True)
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--times', type=int, default=20)
    parser.add_argument('--rva', type=pathlib.Path, default=ROOT / 'build' / 'rva')
    parser.add_argument('--console', type=pathlib.Path, help="folder of the console's files, if not beside the program")
    arguments = parser.parse_args()
    if IN_NAMESPACE not in os.environ:
        inside = ['unshare', '--user', '--map-root-user', '--mount', sys.executable, '-B', *sys.argv]
        sys.exit(subprocess.run(inside, env={**os.environ, IN_NAMESPACE: '1'}).returncode)
    work = pathlib.Path(tempfile.mkdtemp(prefix='rva-full-disk-')).resolve()
    failed = 0
    try:
        setting = Setting(arguments.rva.resolve(), arguments.console and arguments.console.resolve(), work)
        story = Story(WithoutRobot())
        sign = story.steps[-1]
        disk = work / 'disk'
        disk.mkdir()
        package = size_of(story.before(setting, sign)[0])
        for k in range(arguments.times):  # the package is smaller than the data folder by the database and other inspections
            room = int(0.98 * package) * k // arguments.times
            faults = faults_of(setting, story, sign, disk, room)
            failed += bool(faults)
            print(f'{room / 1e6:.2f} of about {package / 1e6:.2f} MB left:', '; '.join(faults) or 'refused, then signed', flush=True)
    except (Unusable, Refused) as error:
        sys.exit(f'full_disk: {error}')
    finally:
        shutil.rmtree(work, ignore_errors=True)
    print(f'{arguments.times - failed} of {arguments.times} as they should be')
    sys.exit(1 if failed else 0)


if __name__ == '__main__':
    main()
