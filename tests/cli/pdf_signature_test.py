"""`rva inspection report --pdf --sign-with`: other programs verify the signature, and files that cannot sign are refused.

usage: pdf_signature_test.py RVA
"""
import os
import re
import subprocess

import program
from written_inspections import write_inspection

PASSPHRASE = 'a passphrase: ß'
KEYS = {'rsa': ('rsa:2048',), 'ecdsa': ('ec', '-pkeyopt', 'ec_paramgen_curve:P-256')}


class PdfSignature(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.data = self.folder / 'data'
        self.succeed('account', 'list', '--data', self.data)  # creates the tables
        write_inspection(self.data, 1, findings=1)
        self.pdf = self.folder / 'report.pdf'
        self.passphrase = self.folder / 'passphrase'
        self.passphrase.write_text(PASSPHRASE + '\nanother line\n')
        self.openssl('req', '-x509', '-newkey', 'rsa:2048', '-nodes', '-days', '30000', '-subj', '/CN=Authority of the test',
                     '-keyout', 'ca.key', '-out', 'ca.pem', '-addext', 'keyUsage=keyCertSign')

    def openssl(self, *arguments, **run):
        return subprocess.run(['openssl', *(str(argument) for argument in arguments)], cwd=self.folder, capture_output=True,
                              check=True, **run)

    def made(self, name, key=KEYS['ecdsa'], usage='digitalSignature', days=30000, keep=()):
        """The path of a PKCS#12 file with a certificate that the test's authority issued."""
        self.openssl('req', '-newkey', *key, '-nodes', '-subj', f'/CN=Shop {name} ß', '-utf8', '-keyout', f'{name}.key', '-out', f'{name}.csr')
        (self.folder / 'usage').write_text(f'keyUsage={usage}\n')
        self.openssl('x509', '-req', '-in', f'{name}.csr', '-CA', 'ca.pem', '-CAkey', 'ca.key', '-days', days, '-extfile', 'usage',
                     '-out', f'{name}.pem')
        self.openssl('pkcs12', '-export', '-in', f'{name}.pem', '-inkey', f'{name}.key', '-certfile', 'ca.pem', '-out', f'{name}.p12',
                     '-passout', f'file:{self.passphrase}', *keep)
        return self.folder / f'{name}.p12'

    def arguments(self, *options):
        return ('inspection', 'report', '--data', self.data, '--inspection', 1, '--pdf', self.pdf, *options)

    def sign(self, certificate, *options):
        self.succeed(*self.arguments('--sign-with', certificate, '--passphrase-file', self.passphrase, *options))
        return self.pdf.read_bytes()

    def verified(self):
        """What pdfsig states where the test's authority is trusted."""
        database = self.folder / 'nss'
        if not database.exists():
            database.mkdir()
            for command in (('-N', '--empty-password'), ('-A', '-n', 'authority', '-t', 'C,C,C', '-i', self.folder / 'ca.pem')):
                subprocess.run(['certutil', '-d', f'sql:{database}', *(str(part) for part in command)], check=True)
        return subprocess.run(['pdfsig', '-nssdir', f'sql:{database}', str(self.pdf)], capture_output=True, encoding='utf-8',
                              check=False).stdout

    def signed_ranges(self, signed):
        first, length, second, rest = (int(number) for number in re.findall(rb'/ByteRange \[(\d+) (\d+) (\d+) (\d+)\]', signed)[0])
        self.assertEqual((first, second + rest), (0, len(signed)), 'the whole file')
        cms = bytes.fromhex(signed[length + 1:second - 1].decode())
        return signed[:length] + signed[second:], cms.rstrip(b'\0')

    def test_other_programs_accept_the_signature(self):
        self.succeed(*self.arguments())
        unsigned = self.pdf.read_bytes()
        for name, key in KEYS.items():
            with self.subTest(key=name):
                signed = self.sign(self.made(name, key), '--overwrite')
                self.assertTrue(signed.startswith(unsigned), 'the signature is added to the unsigned file')
                checked = subprocess.run(['qpdf', '--check', str(self.pdf)], capture_output=True, check=False)
                self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)
                stated = self.verified()
                for part in ('Signature is Valid.', 'Certificate is Trusted.', 'Total document signed', 'ETSI.CAdES.detached',
                             f'Shop {name} ß', 'SHA-256'):
                    self.assertIn(part, stated)
                content, cms = self.signed_ranges(signed)
                (self.folder / 'content').write_bytes(content)
                (self.folder / 'cms').write_bytes(cms)
                self.openssl('cms', '-verify', '-cades', '-binary', '-inform', 'DER', '-in', 'cms', '-content', 'content', '-CAfile', 'ca.pem',
                             '-purpose', 'any', '-out', os.devnull)
                printed = self.openssl('cms', '-cmsout', '-print', '-inform', 'DER', '-in', 'cms').stdout.decode()
                for part in ('contentType', 'messageDigest', 'signingCertificateV2', 'Authority of the test'):
                    self.assertIn(part, printed)
                self.assertNotIn('signingTime', printed)

    def test_a_changed_byte_is_reported(self):
        signed = self.sign(self.made('shop'))
        self.assertIn('Signature is Valid.', self.verified())
        for at in (12, len(signed) // 3, signed.index(b'/Lang (en)') + 7, len(signed) - 2):
            self.pdf.write_bytes(signed[:at] + bytes([signed[at] ^ 1]) + signed[at + 1:])
            self.assertNotIn('Signature is Valid.', self.verified(), f'byte {at}')

    def test_the_passphrase_is_a_line_of_stdin(self):
        done = subprocess.run(self.command(*self.arguments('--sign-with', self.made('shop'))), input=PASSPHRASE + '\n', encoding='utf-8',
                              capture_output=True, cwd=self.folder, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ''))
        self.assertIn('Signature is Valid.', self.verified())

    def test_what_cannot_sign_is_refused(self):
        shop = self.made('shop')
        (self.folder / 'wrong').write_text('another\n')
        (self.folder / 'half.p12').write_bytes(shop.read_bytes()[:400])
        self.openssl('pkcs12', '-export', '-nokeys', '-in', 'shop.pem', '-out', 'keyless.p12', '-passout', f'file:{self.passphrase}')
        weak = self.made('weak', ('rsa:1024',))
        other = self.made('other', ('ec', '-pkeyopt', 'ec_paramgen_curve:secp384r1'))
        agrees = self.made('agrees', usage='keyAgreement')
        for certificate, passphrase, problem in (
                (shop, 'wrong', 'cannot be opened with this passphrase'),
                (shop, 'missing', 'missing'),
                (self.folder / 'ca.pem', 'passphrase', 'is no PKCS#12 file'),
                (self.folder / 'half.p12', 'passphrase', 'is no PKCS#12 file'),
                (os.devnull, 'passphrase', os.devnull),
                (self.folder / 'none.p12', 'passphrase', 'none.p12'),
                (self.folder / 'keyless.p12', 'passphrase', 'contains no certificate with its private key'),
                (weak, 'passphrase', 'neither RSA of at least 2048 bits nor ECDSA on P-256'),
                (other, 'passphrase', 'neither RSA of at least 2048 bits nor ECDSA on P-256'),
                (agrees, 'passphrase', 'not meant for signatures')):
            with self.subTest(certificate=certificate, problem=problem):
                self.check_fails(*self.arguments('--sign-with', certificate, '--passphrase-file', self.folder / passphrase), names=[problem])

    def test_a_certificate_that_is_not_valid_is_refused(self):
        shop = self.made('shop', days=10)
        self.addCleanup(os.environ.pop, 'SOURCE_DATE_EPOCH', None)
        for time_s, problem in ((4000000000, 'expired on 20'), (1000000000, 'is not valid before 20')):
            os.environ['SOURCE_DATE_EPOCH'] = str(time_s)
            self.check_fails(*self.arguments('--sign-with', shop, '--passphrase-file', self.passphrase), names=[problem])


if __name__ == '__main__':
    program.main()
