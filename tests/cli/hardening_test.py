"""What an attack on `rva serve` and `rva account` found, as somebody outside the program sees it.

usage: hardening_test.py RVA
"""
import json
import signal
import socket
import sqlite3
import ssl
import subprocess
import urllib.request

import cv2
import numpy as np
import program
from console_client import Console, ask
from simulations import TOOLS

PASSWORD = 'correct horse'


def is_open(console):
    return console.thread.is_alive()


class Served(program.ProgramTest):
    """A server with a simulated camera that stands still, unless a test requires otherwise."""

    def setUp(self):
        super().setUp()
        self.data = self.folder / 'data'
        console = self.folder / 'console'
        console.mkdir()
        (console / 'index.html').write_text('<title>RVA</title>')
        self.options = ['--camera', f'sim:{TOOLS}', '--data', self.data, '--port', 0, '--console', console, '--frames', 4]
        self.server, self.cookie = None, ''
        self.addCleanup(self.end)

    def start(self, *more):
        self.log = open(self.folder / 'log', 'w+', encoding='utf-8')
        self.addCleanup(self.log.close)
        self.server = subprocess.Popen(self.command('serve', *self.options, *more), stdout=subprocess.PIPE,
                                       stderr=self.log, encoding='utf-8', cwd=self.folder)
        self.address = self.server.stdout.readline().strip().replace('0.0.0.0', '127.0.0.1')

    def end(self, how=signal.SIGTERM):
        if self.server is None:
            return
        self.server.send_signal(how)
        self.server.wait(60)
        self.server.stdout.close()
        self.server = None

    def ask(self, method, path, body=None, status=200):
        answered, answer = ask(self.address, method, '/api/' + path, body, cookie=self.cookie)
        self.assertEqual(answered, status, answer)
        return answer

    def console(self, **options):
        console = Console(self.address, cookie=self.cookie, **options)
        self.addCleanup(console.close)
        return console

    def capture(self, side, console):
        self.work('capture', {'side': side, 'person': 'Ann'}, console)

    def work(self, what, body, console):
        before = console.wait_for(lambda status: status['camera']['streams'])['task']['number']
        self.ask('POST', f'inspections/1/{what}', body, 202)
        status = console.wait_for(lambda status: status['task']['number'] > before
                                  and status['task']['end'] != 'running', timeout_s=120)
        self.assertEqual(status['task']['end'], 'done', status['task'])

    def account(self, *arguments, password=PASSWORD):
        return subprocess.run(self.command('account', *arguments, '--data', self.data), input=password + '\n',
                              capture_output=True, encoding='utf-8', timeout=60)

    def sign_in(self, name, password=PASSWORD):
        headers = {}
        status, answer = ask(self.address, 'POST', '/api/sign-in', {'name': name, 'password': password}, headers=headers)
        self.assertEqual(status, 200, answer)
        self.cookie = headers['Set-Cookie'].split(';')[0]


class Retake(Served):
    def test_a_kill_before_its_first_view_costs_nothing(self):
        self.start()
        self.ask('POST', 'inspections', {'person': 'Ann'}, 201)
        console = self.console()
        self.capture('initial', console)
        self.capture('final', console)
        kept = {path: path.read_bytes() for path in self.data.glob('inspections/**/*') if path.is_file()}
        self.ask('POST', 'inspections/1/capture', {'side': 'final', 'person': 'Ann'}, 202)
        console.wait_for(lambda status: status['task'].get('frame', 0) >= 1 and status['task']['end'] == 'running')
        self.end(signal.SIGKILL)
        self.start()
        self.assertEqual(self.ask('GET', 'inspections/1')['final']['round'], 1)
        console = self.console()
        self.work('compare', {}, console)
        self.capture('final', console)
        self.assertEqual(self.ask('GET', 'inspections/1')['final']['round'], 3)
        for path, bytes_then in kept.items():
            self.assertEqual(path.read_bytes(), bytes_then, 'nothing that was captured or shown is replaced')
        self.end()
        self.assertEqual([str(path) for path in self.data.glob('**/*partial*')], [])

    def test_what_a_former_version_left_is_put_right_and_said(self):
        self.start()
        self.ask('POST', 'inspections', {'person': 'Ann'}, 201)
        console = self.console()
        self.capture('initial', console)
        self.capture('final', console)
        self.end(signal.SIGKILL)
        inspection = self.data / 'inspections' / '000001'
        (inspection / 'final').rename(inspection / 'final.replaced')
        (inspection / 'final' / '000.partial-17-0').mkdir(parents=True)
        self.start('--seed', '2')  # with the same seed, its frames would be copies of the baseline's
        self.assertIn('restored', (self.folder / 'log').read_text())
        self.assertTrue((inspection / 'final' / '000' / 'capture.json').exists())
        console = self.console()
        self.capture('final', console)

    def test_a_clock_that_stands_does_not_confuse_comparisons(self):
        self.start()
        self.ask('POST', 'inspections', {'person': 'Ann'}, 201)
        console = self.console()
        self.capture('initial', console)
        self.capture('final', console)
        with sqlite3.connect(self.data / 'rva.db') as database:
            database.execute("update comparison set compared_at = '2999-01-01T00:00:00Z'")
        self.capture('final', console)
        self.assertEqual(self.ask('GET', 'inspections/1')['comparison'], 2)

    def test_a_link_leads_nothing_out_of_the_data_folder(self):
        self.start()
        self.ask('POST', 'inspections', {'person': 'Ann'}, 201)
        (self.folder / 'elsewhere').mkdir()
        (self.data / 'inspections').symlink_to(self.folder / 'elsewhere')
        refused = self.ask('POST', 'inspections/1/capture', {'side': 'initial', 'person': 'Ann'}, 409)
        self.assertIn('is a link', refused['error']['message'])
        self.assertNotIn(str(self.folder), refused['error']['message'], 'where this computer keeps its files')
        self.assertEqual(list((self.folder / 'elsewhere').iterdir()), [])
        self.end()
        (self.data / 'rva.db').rename(self.folder / 'other.db')
        (self.data / 'rva.db').symlink_to(self.folder / 'other.db')
        self.check_fails('serve', *self.options, names=['rva.db', 'is a link'])


    def test_pictures_come_from_the_comparison_and_from_nowhere_else(self):
        for name in ('changes.png', 'map.ply'):
            (self.folder / name).write_text('of somebody else')
        self.start()
        self.ask('POST', 'inspections', {'person': 'Ann'}, 201)
        self.ask('GET', 'inspections/1/views/0/changes.png', status=404)
        self.ask('GET', 'inspections/1/map', status=404)
        console = self.console()
        self.capture('initial', console)
        self.capture('final', console)
        picture = self.data / 'inspections' / '000001' / 'comparison-1' / 'results' / '000' / 'changes.png'
        picture.unlink()
        picture.symlink_to('/etc/hostname')
        self.ask('GET', 'inspections/1/views/0/changes.png', status=404)

    def test_each_round_keeps_its_map(self):
        self.options += ['--dither', 1]
        self.start()
        self.ask('POST', 'inspections', {'person': 'Ann'}, 201)
        self.ask('GET', 'inspections/1/rounds/1/map', status=404)
        console = self.console()
        for side in ('initial', 'final', 'final'):
            self.capture(side, console)
        inspection = self.data / 'inspections' / '000001'
        for name in ('map', 'changes'):
            for comparison in (1, 2):
                kept = (inspection / f'comparison-{comparison}' / f'{name}.ply').read_bytes()
                self.assertEqual(self.bytes_of(f'inspections/1/rounds/{comparison}/{name}'), kept)
            self.assertEqual(self.bytes_of(f'inspections/1/{name}'), kept, 'of the valid comparison')
        self.assertNotEqual(self.bytes_of('inspections/1/rounds/1/map'), self.bytes_of('inspections/1/map'))
        for comparison in ('0', '3', 'x', '-1', '1e0', '..%2f..'):
            self.ask('GET', f'inspections/1/rounds/{comparison}/map', status=404)
        points = {'points_m': [[0, 0.6, 0], [0.1, 0.6, 0]]}
        self.ask('POST', 'inspections/1/rounds/1/map/measure', points)
        self.ask('POST', 'inspections/1/rounds/3/map/measure', points, 404)
        (inspection / 'comparison-1' / 'changes.ply').unlink()
        (inspection / 'comparison-1' / 'changes.ply').symlink_to('/etc/hostname')
        self.ask('GET', 'inspections/1/rounds/1/changes', status=404)
        self.end()
        # The first versions kept one map for all comparisons, that of the last one.
        (inspection / 'map.ply').write_text('of a later comparison')
        with sqlite3.connect(self.data / 'rva.db') as records:
            records.execute("update comparison set folder = '', final_round = 0 where number = 1")
        self.start()
        self.ask('GET', 'inspections/1/rounds/1/map', status=404)
        self.ask('POST', 'inspections/1/rounds/1/map/measure', points, 409)

    def bytes_of(self, path):
        with urllib.request.urlopen(f'{self.address}/api/{path}', timeout=60) as answer:
            return answer.read()


class Accounts(Served):
    def test_a_new_password_ends_every_sign_in_of_before(self):
        self.account('add', 'ann', '--role', 'operator')
        self.account('add', 'bob')
        self.start()
        self.sign_in('bob')
        others = self.console()
        self.sign_in('ann')
        console = self.console()
        console.wait_for(lambda status: status['camera']['streams'])
        self.assertEqual(self.account('add', 'ann', '--role', 'operator', password='another horse').returncode, 0)
        self.assertEqual(ask(self.address, 'GET', '/api/inspections', cookie=self.cookie)[0], 401)
        console.thread.join(60)
        self.assertFalse(is_open(console), 'the live view is closed, too')
        others.wait_for(lambda status: True)
        self.assertTrue(is_open(others), 'and nobody else is')

    def test_an_account_that_is_added_again_is_another_one(self):
        self.account('add', 'ann')
        self.start()
        self.sign_in('ann')
        self.account('remove', 'ann')
        self.assertEqual(ask(self.address, 'GET', '/api/inspections', cookie=self.cookie)[0], 401)
        self.account('add', 'ann')
        self.assertEqual(ask(self.address, 'GET', '/api/inspections', cookie=self.cookie)[0], 401)
        self.sign_in('ann')
        self.ask('GET', 'inspections')

    def test_names_that_can_be_taken_for_another_are_refused(self):
        self.assertEqual(self.account('add', 'paul').returncode, 0)
        for name, status, words in (('Paul', 1, 'looks like'), ('pau1', 1, 'looks like'), (' paul', 2, 'can be mistaken'),
                                    ('paul ', 2, 'can be mistaken'), ('pa\u200bul', 2, 'can be mistaken'),
                                    ('\u202eluap', 2, 'can be mistaken'), ('pa\u2066ul', 2, 'can be mistaken'),
                                    ('p\u0430ul', 2, 'can be mistaken'), ('\u0440\u0430ul', 2, 'can be mistaken')):
            with self.subTest(name):
                done = self.account('add', name)
                self.assertEqual(done.returncode, status, done.stderr)
                self.assertIn(words, done.stderr)
        self.assertEqual(self.account('add', 'paul', '--role', 'inspector').returncode, 0, 'it is changed')
        self.assertEqual(self.account('add', 'paul', password='another horse').returncode, 0)
        self.assertIn('inspector  paul', self.account('list').stdout, 'a new password leaves the role')


class Transport(Served):
    def test_tls_1_2_keeps_its_forward_secrecy(self):
        certificate, key = self.folder / 'certificate.pem', self.folder / 'key.pem'
        subprocess.run(['openssl', 'req', '-x509', '-newkey', 'rsa:2048', '-nodes', '-keyout', key, '-out', certificate,
                        '-days', '2', '-subj', '/CN=rva'], check=True, capture_output=True)
        self.account('add', 'ann')
        self.start('--tls-certificate', certificate, '--tls-key', key)
        port = int(self.address.rsplit(':', 1)[1])

        def connect(ciphers):
            context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
            context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
            context.maximum_version = ssl.TLSVersion.TLSv1_2
            context.set_ciphers(ciphers)
            with socket.create_connection(('127.0.0.1', port), timeout=60) as plain:
                with context.wrap_socket(plain) as secured:
                    return secured.cipher()[0]
        self.assertIn('ECDHE', connect('ECDHE+AESGCM'))
        with self.assertRaises(ssl.SSLError):
            connect('AES128-GCM-SHA256:AES256-GCM-SHA384:AES128-SHA')

    def test_a_hello_that_is_too_long_is_answered_by_a_close(self):
        self.start()
        console = self.console(name='Ann')
        console.wait_for(lambda status: True)
        loud = Console(self.address, name='A' * 300)
        self.addCleanup(loud.close)
        loud.thread.join(60)
        self.assertFalse(is_open(loud))


class Size(program.ProgramTest):
    def test_a_small_file_that_states_a_large_image_is_refused(self):
        folder = self.folder / 'capture'
        (folder / 'depth').mkdir(parents=True)
        (folder / 'capture.json').write_text(json.dumps({
            'format': 'rva-capture', 'version': 1,
            'depth': {'width': 8000, 'height': 4000, 'fx': 600, 'fy': 600, 'cx': 4000, 'cy': 2000, 'unit_m': 0.001}}))
        cv2.imwrite(str(folder / 'depth' / '000000.png'), np.zeros((4000, 8000), np.uint16))
        self.check_fails('detect', folder, self.folder, '--out', self.folder / 'out', names=['8000x4000', 'larger than any'])


if __name__ == '__main__':
    program.main()
