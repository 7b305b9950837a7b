"""The Debian packages: contents, fields, bad input; installed, upgraded, removed and purged.

usage: package_test.py REPOSITORY

That an older program refuses records of a newer version is tested in tests/store/sqlite_file_test.cpp.
"""
import pathlib
import sys
import unittest

import contents
import copied_root
import installed
import packages

CASES = (contents.Contents, contents.BadInput, installed.Life, installed.LifeWithoutRecords, installed.PythonModule,
         installed.Service)
SKIPPED = 77


def main():
    root = pathlib.Path(sys.argv[1])
    reason = packages.why_not_made(root)
    if reason:
        print(f'skipped: {reason}')
        return SKIPPED
    copied_root.enter_mount_namespace()
    made = packages.Packages(root)
    suite = unittest.TestSuite()
    for case in CASES:
        case.packages = made
        suite.addTests(unittest.defaultTestLoader.loadTestsFromTestCase(case))
    done = unittest.TextTestRunner(verbosity=2).run(suite)
    return 0 if done.wasSuccessful() else 1


if __name__ == '__main__':
    sys.exit(main())
