"""Time stamps (RFC 3161) of signed packages, by `openssl ts`: both verifiers and openssl accept them, a server that gives
none or a wrong one blocks nothing, and nothing is accepted in their stead.

usage: time_stamp_test.py RVA REPOSITORY
"""
import json
import pathlib
import shutil
import subprocess
import sys

import program
import signed_packages
from time_stamp_server import TimeStampServer, openssl

signed_packages.VERIFIER = pathlib.Path(sys.argv.pop(2)).resolve() / 'script' / 'verify-record'
STAMP, ENVELOPE = 'signature/statement.tst', 'signature/statement.dsse.json'


class TimeStamps(signed_packages.SignedPackageTest):
    def setUp(self):
        super().setUp()
        self.server = self.authority('authority')

    def authority(self, name, **how):
        server = TimeStampServer(self.folder / name, **how)
        self.addCleanup(server.close)
        return server

    def signed(self, out, *, url=None):
        return self.rva('inspection', 'export', '--data', self.data, '--inspection', 3, '--key', self.keys[0], '--out', out,
                        '--timestamp-server', url or self.server.url)

    def sign_with_stamp(self, out):
        done = self.signed(out)
        self.assertEqual((done.returncode, 'time stamp' in done.stderr), (0, False), done.stderr)
        return out

    def stated(self, package, *options):
        return json.loads(self.succeed('inspection', 'verify', package, '--json', *options).stdout)['time_stamp']

    def test_a_time_stamp_is_verified_by_all(self):
        self.sign_with_stamp(self.package)
        path, kind, _ = self.server.asked[-1]
        self.assertEqual((path, kind), ('/tsa', 'application/timestamp-query'))
        self.assertIn('not checked', self.check_accepted(self.package))
        self.assertIn('Authority of tests', self.check_accepted(self.package, '--timestamp-ca', self.server.ca))
        openssl('ts', '-verify', '-token_in', '-in', self.package / STAMP, '-data', self.package / ENVELOPE, '-CAfile', self.server.ca)
        stamp = self.stated(self.package)
        text = openssl('ts', '-reply', '-token_in', '-text', '-in', self.package / STAMP).decode()
        self.assertEqual((stamp['server'], stamp['authority']), (self.server.url, 'CN=Authority of tests'))
        self.assertIn(f'{stamp["time"][11:19]}', text)

    def test_a_chain_of_certificates_is_accepted(self):
        self.server = self.authority('with-chain', chain='yes')
        self.sign_with_stamp(self.package)
        self.check_accepted(self.package)
        self.check_accepted(self.package, '--timestamp-ca', self.server.ca)

    def test_a_server_without_an_answer_blocks_nothing(self):
        server = self.server
        other = self.folder / 'other'
        other.write_text('other')
        digest = server.digest_in
        cases = [
            (lambda _: (500, b''), 'HTTP status 500'), (lambda _: (200, b''), 'something else'), (lambda _: (200, b'\x30\x03abc'), 'something else'),
            (lambda _: (200, b'x' * 300_000), 'body limit'), (lambda question: (200, server.stamp(question)[1] + b'more'), 'something else'),
            (server.stamp_instead('-data', other, '-cert'), 'not a valid time stamp'),
            (lambda question: server.stamp_instead('-digest', digest(question), '-cert')(question), 'nonce'),
            (lambda question: server.stamp_instead('-digest', digest(question), '-no_nonce', '-cert')(question), 'nonce'),
            (lambda question: server.stamp_instead('-digest', digest(question))(question), 'certificate'),
            (lambda _: server.stamp(openssl('ts', '-query', '-sha512', '-data', other)), 'refused')]
        for number, (server.behave, problem) in enumerate(cases):
            package = self.folder / f'package-{number}'
            done = self.signed(package)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stderr, r'warning: http://[^\n]*the package has no time stamp\n')
            self.assertIn(problem, done.stderr)
            self.check_accepted(package)
            self.assertIn(problem, self.stated(package)['failure'])
            self.assertFalse((package / STAMP).exists())
        self.check_refused(package, '--timestamp-ca', server.ca, names=problem)
        self.assertIn('refused', self.signed(self.package, url='http://127.0.0.1:1').stderr)
        self.check_accepted(self.package)
        for url in ('https://example.com', 'example.com', 'http://', 'http://a b/', 'http://a:port/', 'http://a/\n'):
            done = self.signed(self.out, url=url)
            self.assertEqual(done.returncode, 2, url)
            self.assertIn('--timestamp-server', done.stderr)

    def test_no_other_time_stamp_is_accepted(self):
        self.sign_with_stamp(self.package)
        earlier = self.sign_with_stamp(self.folder / 'earlier')
        self.check_refused(self.package, '--timestamp-ca', self.authority('another').ca, names='statement.tst')
        self.check_refused(self.package, '--timestamp-ca', self.folder / 'none')
        self.check_refused(self.package, '--timestamp-ca', self.keys[0])

        def changed(change):
            def apply(copy):
                change(copy / STAMP)
                signed_packages.cover(copy)
            return self.damaged(apply)

        self.check_refused(changed(lambda path: path.unlink()), names='statement.tst')
        self.check_refused(changed(lambda path: shutil.copy(earlier / STAMP, path)), names='imprint')
        for text in (b'', b'garbage', b'\x30\x80'):
            self.check_refused(changed(lambda path: path.write_bytes(text)))
        self.check_refused(changed(lambda path: path.write_bytes(path.read_bytes() + b'more')))
        size = (self.package / STAMP).stat().st_size
        for at in range(0, size, size // 12):  # what the authority signed, or what its signature needs
            def flip(path):
                data = bytearray(path.read_bytes())
                data[at] ^= 1
                path.write_bytes(data)
            ours, theirs, text = self.verdicts(changed(flip))
            self.assertEqual(ours, theirs, text)
        unstamped = self.folder / 'unstamped'
        self.succeed('inspection', 'export', '--data', self.data, '--inspection', 3, '--key', self.keys[0], '--out', unstamped)
        shutil.copy(self.package / STAMP, unstamped / STAMP)
        signed_packages.cover(unstamped)
        self.check_refused(unstamped)

    def test_a_package_without_a_server_states_nothing(self):
        self.succeed('inspection', 'export', '--data', self.data, '--inspection', 3, '--key', self.keys[0], '--out', self.package)
        self.assertIsNone(self.stated(self.package))
        self.assertIn('no server was asked', self.succeed('inspection', 'verify', self.package).stdout)
        self.check_refused(self.package, '--timestamp-ca', self.server.ca)
        shown = subprocess.run(self.command('serve', '--help'), capture_output=True, text=True, check=True).stdout
        self.assertIn('--timestamp-server', shown)


if __name__ == '__main__':
    program.main()
