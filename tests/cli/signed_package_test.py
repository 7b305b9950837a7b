"""`rva key`, `rva inspection export` and `verify`, and script/verify-record, which contains none of our code: both
verifiers accept what was signed, and refuse every damaged copy.

usage: signed_package_test.py RVA REPOSITORY
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys

import program
import signed_packages
from signed_packages import CAPTURE, cover, flip_bit

signed_packages.VERIFIER = pathlib.Path(sys.argv.pop(2)).resolve() / 'script' / 'verify-record'
PASSWORD = 'correct horse'
SIGNATURE = 'signature/statement.dsse.json'


class SignedPackage(signed_packages.SignedPackageTest):
    def test_what_was_signed_is_accepted(self):
        self.sign(self.package)
        self.sign(self.folder / 'second')
        log = '--log', self.data / 'log'
        for options in ((), self.trusted(), (*self.trusted(), *log), (*log, '--checkpoint', self.package / 'signature' / 'record.tlog-proof')):
            text = self.check_accepted(self.package, *options)
        for part in ('inspection: 3', 'N1 \u2713', 'example.com/ann+', 'example.com/bob+', 'record 1 of 1', 'example.com/log+'):
            self.assertIn(part, text)
        stated = json.loads(self.succeed('inspection', 'verify', self.folder / 'second', '--json', *log).stdout)
        self.assertEqual((stated['verified'], stated['log']['index'], stated['log']['size'], stated['files']), (True, 1, 2, 6))
        self.assertEqual(stated['compared_with'], {'keys': False, 'log': True, 'checkpoint': False, 'timestamp_ca': False})

    def test_sha256sum_accepts_the_manifests(self):
        self.sign(self.package)
        for manifest, count in (('manifest-sha256.txt', 6), ('tagmanifest-sha256.txt', 7)):
            done = subprocess.run(['sha256sum', '--check', '--strict', manifest], cwd=self.package, capture_output=True, text=True,
                                  check=True)
            self.assertEqual(done.stdout.count(': OK'), count)
        exported = self.folder / 'exported'
        self.succeed('export', '--data', self.data, '--inspection', 3, '--out', exported)
        for file in exported.rglob('*.png'):
            self.assertEqual((self.package / 'data' / file.relative_to(exported)).read_bytes(), file.read_bytes())

    def test_every_damaged_copy_is_refused(self):
        self.sign(self.package)
        files = [path.relative_to(self.package) for path in sorted(self.package.rglob('*')) if path.is_file()]
        self.assertEqual(len(files), 14)
        for file in files:
            for at in (0, 0.4, 1):
                self.check_refused(self.damaged(lambda copy: flip_bit(copy / file, at)))
            self.check_refused(self.damaged(lambda copy: os.truncate(copy / file, (copy / file).stat().st_size - 1)))
            self.check_refused(self.damaged(lambda copy: (copy / file).unlink()))

    def test_covered_changes_are_refused(self):
        self.sign(self.package)

        def changed(file, change):
            def apply(copy):
                change(copy / file)
                cover(copy)
            return self.damaged(apply)

        def reverse_lines(path):
            path.write_text(''.join(reversed(path.read_text().splitlines(keepends=True))))

        def strip_signature(path):
            envelope = json.loads(path.read_text())
            del envelope['signatures'][1]
            path.write_text(json.dumps(envelope, indent=1) + '\n')
            keys = path.parent / 'signers.pub'
            keys.write_text(keys.read_text().splitlines(keepends=True)[0])

        for file in ('bag-info.txt', 'bagit.txt', 'manifest-sha256.txt', 'signature/signers.pub', 'signature/log.pub', SIGNATURE,
                     'signature/record.tlog-proof', 'data/inspection.json'):
            self.check_refused(changed(file, flip_bit))
        for file in ('manifest-sha256.txt', 'signature/signers.pub', SIGNATURE):
            self.check_refused(changed(file, reverse_lines))
        self.check_refused(changed(SIGNATURE, strip_signature), names='signers.pub')
        self.check_refused(changed(SIGNATURE, lambda path: path.write_text(json.dumps(json.loads(path.read_text())))))
        for text in ('', '{', '[]', '{"payload": 1}', '{"payload": "*", "payloadType": "", "signatures": []}', '[' * 100_000):
            self.check_refused(changed(SIGNATURE, lambda path: path.write_text(text)))
        self.check_refused(changed('signature/signers.pub', lambda path: path.write_bytes(b'\xff\n')))

    def test_files_that_do_not_belong_are_refused(self):
        self.sign(self.package)

        def add(name):
            def apply(copy):
                (copy / name).parent.mkdir(parents=True, exist_ok=True)
                (copy / name).write_text('more')
                cover(copy)
            return self.damaged(apply)

        def list_outside(copy):
            (self.folder / 'outside').write_text('pixels')
            manifest = copy / 'manifest-sha256.txt'
            manifest.write_text(manifest.read_text() + f'{"0" * 64}  data/../../outside\n')
            cover(copy)

        def link(copy):
            (copy / 'data' / 'inspection.json').unlink()
            (copy / 'data' / 'inspection.json').symlink_to(self.package / 'data' / 'inspection.json')

        def link_folder(copy):
            shutil.rmtree(copy / 'data' / 'initial')
            (copy / 'data' / 'initial').symlink_to(self.package / 'data' / 'initial')

        for name in ('data/more', 'more.txt', 'signature/more', 'data/new/more', '.hidden', 'data/with space', 'data/a\nb'):
            self.check_refused(add(name))
        self.check_refused(self.damaged(list_outside), names='manifest')
        self.check_refused(self.damaged(link), names='symbolic link')
        self.check_refused(self.damaged(link_folder), names='symbolic link')
        self.check_refused(self.damaged(lambda copy: (copy / 'data' / 'empty').mkdir()), names='empty folder')
        self.check_refused(self.damaged(lambda copy: os.mkfifo(copy / 'data' / 'pipe')))
        self.check_refused(self.folder / 'none')
        self.check_refused(self.data)

    def test_replaced_keys_are_refused_with_the_keys_from_elsewhere(self):
        forged = self.sign(self.package, [self.key(name, 'eve') for name in ('ann', 'bob', 'log')], self.folder / 'forged-log')
        self.check_accepted(forged)
        self.check_refused(forged, *self.trusted(), names='none of those given')
        self.check_refused(forged, '--key', self.package / 'bagit.txt')

    def test_another_log_is_refused(self):
        log, kept = self.data / 'log', self.folder / 'kept'
        self.sign(self.folder / 'first')
        shutil.copytree(log, kept)
        self.sign(self.package)
        shutil.copytree(log, self.folder / 'checkpoint-of-two')
        self.check_refused(self.package, '--log', kept, names='taken back')
        # The site goes on from the earlier log, as if the second record had never been.
        shutil.rmtree(log)
        shutil.copytree(kept, log)
        self.sign(self.folder / 'instead')
        self.check_refused(self.package, '--log', log, names='other records')
        known = '--checkpoint', self.folder / 'checkpoint-of-two' / 'checkpoint'
        self.check_refused(self.folder / 'instead', *known, names='other records')
        self.check_refused(self.folder / 'instead', '--log', log, *known, names='other records')
        self.check_accepted(self.folder / 'instead', '--log', log, '--checkpoint', kept / 'checkpoint')
        self.check_refused(self.folder / 'instead', '--checkpoint', kept / 'checkpoint', names='log')
        flip_bit(log / 'leaves.txt')
        self.check_refused(self.folder / 'instead', '--log', log)

    def with_input(self, text, *arguments):
        return subprocess.run(self.command(*arguments), input=text, capture_output=True, text=True, cwd=self.folder, check=False)

    def test_a_key_with_a_password(self):
        file = self.folder / 'carl.key'
        create = 'key', 'create', 'example.com/carl', '--out', file
        self.assertEqual(self.with_input('short\n', *create).returncode, 1)
        self.assertFalse(file.exists())
        done = self.with_input(f'{PASSWORD}\n', *create)
        self.assertEqual(done.stdout, f'{file}\n{file}.pub\n', done.stderr)
        self.assertEqual(file.stat().st_mode & 0o777, 0o600)
        public = pathlib.Path(f'{file}.pub').read_text()
        self.assertEqual(self.succeed('key', 'public', file).stdout, public)
        export = 'inspection', 'export', '--data', self.data, '--inspection', 3, '--key', file, '--out', self.package
        wrong = self.with_input('another\n', *export)
        self.assertEqual(wrong.returncode, 1)
        self.check_line(wrong.stderr, ['password'])
        self.assertFalse(self.package.exists() or (self.data / 'log').exists())
        self.assertEqual(self.with_input(f'{PASSWORD}\n', *export).returncode, 0)
        self.check_accepted(self.package, '--key', f'{file}.pub')
        self.check_fails(*create, names=['never replaced'])

    def test_what_cannot_be_signed_leaves_nothing(self):
        self.sign(self.package)
        export = 'inspection', 'export', '--data', self.data, '--inspection'
        key = '--key', self.keys[2]
        self.check_fails(*export, 3, *key, '--out', self.package, names=['never replaced'])
        self.check_fails(*export, 4, *key, '--out', self.out, names=['inspection 4'])
        self.check_fails(*export, 3, '--key', self.keys[0], '--out', self.out, names=['checkpoint', 'example.com/ann'])
        self.check_fails(*export, 3, '--key', f'{self.keys[2]}.pub', '--out', self.out, names=['public key'])
        (self.data / CAPTURE / 'depth' / '000001.png').rename(self.data / CAPTURE / 'depth' / 'a b.png')
        self.check_fails(*export, 3, *key, '--out', self.out, names=['a b.png'])
        for arguments in ((), ('export',), ('verify',), ('sign', self.package)):
            self.assertEqual(self.rva('inspection', *arguments).returncode, 2, arguments)
        self.assertEqual(self.rva('key', 'create', 'a b', '--out', self.out, '--no-password').returncode, 2)


if __name__ == '__main__':
    program.main()
