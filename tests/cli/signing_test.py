"""Signing a closed inspection in the console: who may, what is written, and what is left when the server is killed.

usage: signing_test.py RVA REPOSITORY
"""
import concurrent.futures
import contextlib
import json
import pathlib
import random
import shutil
import sqlite3
import subprocess
import sys
import time

import program
from console_client import Console, ask
from simulations import TOOLS
from time_stamp_server import TimeStampServer

REPOSITORY = pathlib.Path(sys.argv.pop(2)).resolve()
PASSWORDS = {'ida weber': 'correct horse', 'max': 'battery staple', 'vera': 'purple monkey'}
CAPTURE = 'inspections/000003/initial/000'
SIGN = '/api/inspections/3/sign'


class Signing(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.data = self.folder / 'data'
        for name, role in (('ida weber', 'inspector'), ('max', 'operator'), ('vera', 'viewer')):
            self.set_password(name, PASSWORDS[name], '--role', role)
        with contextlib.closing(sqlite3.connect(self.data / 'rva.db')) as database, database:
            for number in (3, 4):
                database.execute('insert into inspection (id, aircraft, zone, work_order, person, created_at, dither) '
                                 "values (?, 'N1', 'bay', 'W1', 'Ann', '2026-01-01T00:00:00.000Z', 1)", (number,))
                database.execute('insert into view values (?, 0, 0, 0)', (number,))
                database.execute("insert into side values (?, 'initial', 1, '2026-01-01T00:00:00.000Z', 'Ann', 'b')", (number,))
            database.execute("insert into closing values (3, 1, 'Ann', '', '2026-01-01T00:00:00.000Z')")
        for k in range(20):
            file = self.data / CAPTURE / f'depth/{k:06}.png'
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(random.Random(k).randbytes(200_000))
        (self.data / CAPTURE / 'capture.json').write_text('{}')
        (self.folder / 'console').mkdir()
        (self.folder / 'console' / 'index.html').write_text('<title>RVA</title>')
        self.log = open(self.folder / 'server.log', 'w+', encoding='utf-8')
        self.addCleanup(self.log.close)
        self.start()

    def set_password(self, name, password, *more):
        subprocess.run(self.command('account', 'add', name, *more, '--data', self.data), input=f'{password}\n', check=True,
                       capture_output=True, encoding='utf-8')

    def start(self, *options):
        self.server = subprocess.Popen(
            self.command('serve', '--camera', f'sim:{TOOLS}', '--data', self.data, '--port', 0, '--console', self.folder / 'console', *options),
            stdout=subprocess.PIPE, stderr=self.log, encoding='utf-8')
        self.addCleanup(self.server.stdout.close)
        self.addCleanup(self.server.wait, 60)
        self.addCleanup(self.server.kill)
        self.address = self.server.stdout.readline().strip()
        self.tasks = 0  # that this server has started

    def sign_in(self, name):
        headers = {}
        self.assertEqual(ask(self.address, 'POST', '/api/sign-in', {'name': name, 'password': PASSWORDS[name]}, headers=headers)[0], 200)
        return headers['Set-Cookie'].split(';')[0]

    def ask_to_sign(self, cookie, name, others=(), path=SIGN):
        people = [{'name': other, 'password': PASSWORDS[other]} for other in others]
        answer = ask(self.address, 'POST', path, {'password': PASSWORDS[name], 'others': people}, cookie=cookie)
        self.tasks += answer[0] == 202
        return answer

    def wait_for_end(self, cookie):
        console = Console(self.address, cookie=cookie)
        console.wait_for(lambda status: status['task']['number'] == self.tasks and status['task']['end'] != 'running')
        end = console.status['task']
        console.close()
        return end

    def signed(self, cookie):
        return ask(self.address, 'GET', '/api/inspections/3', cookie=cookie)[1].get('signed', [])

    def verify(self, package):
        """By both verifiers, with the keys that the server publishes, against the site's log."""
        keys = [argument for file in sorted(self.data.glob('keys/**/*.pub')) for argument in ('--key', file)]
        log = ('--log', self.data / 'log')
        done = self.succeed('inspection', 'verify', package, *keys, *log)
        subprocess.run([REPOSITORY / 'script/verify-record', package, *keys, *log], check=True, capture_output=True)
        return done.stdout

    def test_a_mechanic_and_an_inspector_sign_one_package(self):
        cookie = self.sign_in('max')
        self.assertEqual(self.signed(cookie), [])
        self.assertEqual(self.ask_to_sign(cookie, 'max', ['ida weber'])[0], 202)
        self.assertEqual(self.wait_for_end(cookie)['end'], 'done')
        package, = self.signed(cookie)
        self.assertEqual(package['folder'], 'signed/000003-1')
        self.assertEqual([key.split('+')[0] for key in package['signers']], ['max', 'ida_weber'])
        report = self.verify(self.data / package['folder'])
        self.assertIn('ida_weber', report)
        done = self.succeed('inspection', 'actions', '--data', self.data, '--person', 'ida weber').stdout.splitlines()
        self.assertEqual([line.split(',')[1:3] + line.split(',')[-1:] for line in done[1:]], [['ida_weber', '3', 'Signed signed/000003-1']])
        everybody = self.succeed('inspection', 'actions', '--data', self.data).stdout
        for action in ('Ann,3,N1,bay,W1,Inspection begun', 'Ann,4,N1,bay,W1,Baseline captured', 'Ann,3,N1,bay,W1,Inspection closed', 'max,3,N1'):
            self.assertIn(action, everybody)
        published = ask(self.address, 'GET', '/api/keys', cookie=cookie)[1]['keys']
        self.assertEqual(published[0], (self.data / 'keys/log.key.pub').read_text().strip())
        self.assertLessEqual(set(package['signers']), set(published))
        with open(self.data / package['folder'] / 'data' / 'report.html', encoding='utf-8') as page:
            self.assertIn('Closed by <bdi class="typed">Ann</bdi>', page.read())

    def test_what_is_signed_gets_a_time_stamp(self):
        authority = TimeStampServer(self.folder / 'authority')
        self.addCleanup(authority.close)
        self.server.terminate()
        self.server.wait()
        (self.folder / 'serve.conf').write_text(f'timestamp-server = {authority.url}\n')
        self.start('--config', self.folder / 'serve.conf')
        cookie = self.sign_in('ida weber')
        for authority.behave in (authority.stamp, lambda _: (500, b'')):
            self.ask_to_sign(cookie, 'ida weber')
            self.assertEqual(self.wait_for_end(cookie)['end'], 'done')
        first, second = (self.data / package['folder'] for package in self.signed(cookie))
        self.assertIn('Authority of tests', self.succeed('inspection', 'verify', first, '--timestamp-ca', authority.ca).stdout)
        self.assertIn('HTTP status 500', self.succeed('inspection', 'verify', second).stdout)
        self.log.seek(0)
        self.assertRegex(self.log.read(), r'HTTP status 500[^\n]*event=no-time-stamp')

    def test_signing_again_appends_and_keeps_what_was_signed(self):
        cookie = self.sign_in('ida weber')
        self.assertEqual(self.ask_to_sign(cookie, 'ida weber')[0], 202)
        self.assertEqual(self.wait_for_end(cookie)['end'], 'done')
        first = {path: path.read_bytes() for path in (self.data / 'signed').rglob('*') if path.is_file()}
        self.addCleanup(PASSWORDS.__setitem__, 'ida weber', PASSWORDS['ida weber'])
        PASSWORDS['ida weber'] = 'another horse'
        self.set_password('ida weber', PASSWORDS['ida weber'])
        self.assertEqual(ask(self.address, 'POST', SIGN, {'password': PASSWORDS['ida weber']}, cookie=cookie)[0], 401,
                         'a changed account ends the sign-in')
        cookie = self.sign_in('ida weber')
        self.assertEqual(self.ask_to_sign(cookie, 'ida weber')[0], 202)
        self.assertEqual(self.wait_for_end(cookie)['end'], 'done')
        before, now = self.signed(cookie)
        self.assertNotEqual(before['signers'], now['signers'], 'a new password makes a new key')
        for path, content in first.items():
            self.assertEqual(path.read_bytes(), content)
        for package in (before, now):
            self.verify(self.data / package['folder'])
        # A command of the administrator continues the same log.
        self.succeed('key', 'create', 'example.com/qa', '--out', self.folder / 'qa.key', '--no-password')
        self.succeed('inspection', 'export', '--data', self.data, '--inspection', 3, '--key', self.folder / 'qa.key', '--out', self.out)
        self.succeed('inspection', 'verify', self.out, '--key', self.folder / 'qa.key.pub', '--key', self.data / 'keys/log.key.pub',
                     '--log', self.data / 'log')
        self.assertEqual((self.data / 'log/leaves.txt').read_text().count('\n'), 3)

    def test_nobody_signs_without_password_role_or_closing(self):
        inspector, operator, viewer = (self.sign_in(name) for name in PASSWORDS)
        for cookie, name, body, status, words in (
                (viewer, 'vera', None, 403, 'viewer'),
                (operator, 'max', None, 403, 'inspector'),
                (inspector, 'ida weber', {'password': 'wrong horse'}, 403, 'wrong'),
                (inspector, 'ida weber', {}, 403, 'wrong'),
                (inspector, 'ida weber', {'password': 7}, 400, 'password'),
                (inspector, 'ida weber', {'password': PASSWORDS['ida weber'], 'others': [{'name': 'max', 'password': 'no'}]}, 403, 'max'),
                (inspector, 'ida weber', {'password': PASSWORDS['ida weber'], 'others': [{'name': 'vera', 'password': PASSWORDS['vera']}]}, 403, 'vera'),
                (inspector, 'ida weber', {'password': PASSWORDS['ida weber'], 'others': [{'name': 'ida weber', 'password': 'x'}]}, 400, 'twice'),
                (inspector, 'ida weber', {'password': PASSWORDS['ida weber'], 'others': [7]}, 400, 'person'),
                (inspector, 'ida weber', {'password': PASSWORDS['ida weber'], 'others': 7}, 400, 'people'),
                (inspector, 'ida weber', {'password': PASSWORDS['ida weber'], 'others': [{}] * 9}, 400, 'seven'),
                ('', '', {'password': PASSWORDS['ida weber']}, 401, 'sign')):
            answer = self.ask_to_sign(cookie, name) if body is None else ask(self.address, 'POST', SIGN, body, cookie=cookie)
            self.assertEqual(answer[0], status, answer)
            self.assertIn(words, answer[1]['error']['message'])
        status, answer = self.ask_to_sign(inspector, 'ida weber', path='/api/inspections/4/sign')
        self.assertEqual((status, answer['error']['code']), (409, 'refused'))
        self.assertIn('not closed', answer['error']['message'])
        self.assertEqual(self.ask_to_sign(inspector, 'ida weber', path='/api/inspections/9/sign')[0], 404)
        for _ in range(5):
            ask(self.address, 'POST', SIGN, {'password': 'a guess'}, cookie=inspector)
        self.assertEqual(self.ask_to_sign(inspector, 'ida weber')[0], 429, 'guessing ends')
        self.assertFalse((self.data / 'signed').exists())
        self.assertFalse((self.data / 'log').exists())

    def test_only_an_inspector_releases_what_is_lost(self):
        operator, inspector = self.sign_in('max'), self.sign_in('ida weber')
        items = '/api/inspections/4/items'
        self.assertEqual(ask(self.address, 'POST', items, {'csv': 'item\nwrench\n'}, cookie=operator)[0], 201)
        lost = {'returned': 0, 'used': 0, 'lost': 1, 'released': False, 'note': ''}
        self.assertEqual(ask(self.address, 'POST', f'{items}/1', lost, cookie=operator)[0], 200)
        released = {**lost, 'released': True, 'note': 'fell outside'}
        self.assertEqual(ask(self.address, 'POST', f'{items}/1', released, cookie=operator)[0], 403)
        status, after = ask(self.address, 'POST', f'{items}/1', released, cookie=inspector)
        self.assertEqual((status, after['items'][0]['state']), (200, 'released'))
        self.assertEqual([statement['person'] for statement in after['items'][0]['statements']], ['max', 'ida weber'])

    def test_a_log_of_another_key_is_left_alone(self):
        self.succeed('key', 'create', 'example.com/other', '--out', self.folder / 'other.key', '--no-password')
        self.succeed('inspection', 'export', '--data', self.data, '--inspection', 3, '--key', self.folder / 'other.key', '--out', self.out)
        before = {path: path.read_bytes() for path in (self.data / 'log').iterdir()}
        cookie = self.sign_in('ida weber')
        self.assertEqual(self.ask_to_sign(cookie, 'ida weber')[0], 202)
        end = self.wait_for_end(cookie)
        self.assertEqual(end['end'], 'failed')
        self.assertIn('log', end['problem'])
        self.assertEqual({path: path.read_bytes() for path in (self.data / 'log').iterdir()}, before)
        self.assertEqual(list((self.data / 'signed').glob('*')), [])

    def test_two_people_sign_at_once(self):
        cookies = {name: self.sign_in(name) for name in ('ida weber', 'max')}
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            answers = list(pool.map(lambda name: self.ask_to_sign(cookies[name], name, ['max' if name != 'max' else 'ida weber'])[0], cookies))
        self.tasks = answers.count(202)
        self.wait_for_end(cookies['max'])
        self.assertLessEqual(set(answers), {202, 409})
        packages = self.signed(cookies['max'])
        self.assertEqual(len(packages), answers.count(202))
        for package in packages:
            self.verify(self.data / package['folder'])

    def test_a_killed_server_leaves_whole_packages_only(self):
        chance, acknowledged = random.Random(1), 0
        for _ in range(6):
            cookie = self.sign_in('ida weber')
            self.assertEqual(self.ask_to_sign(cookie, 'ida weber')[0], 202)
            time.sleep(chance.uniform(0, 0.25))
            acknowledged = max(acknowledged, len(self.signed(cookie)))
            self.server.kill()
            self.server.wait(60)
            self.start()
            self.assertEqual(list(self.data.glob('signed/*.partial-*')), [])
            packages = sorted(self.data.glob('signed/*'))
            self.assertGreaterEqual(len(packages), acknowledged)
            for package in packages:
                self.verify(package)
        cookie = self.sign_in('ida weber')
        self.assertEqual(self.ask_to_sign(cookie, 'ida weber')[0], 202)
        self.assertEqual(self.wait_for_end(cookie)['end'], 'done')
        self.verify(self.data / self.signed(cookie)[-1]['folder'])

    def test_a_damaged_package_does_not_hide_the_inspection(self):
        cookie = self.sign_in('ida weber')
        self.ask_to_sign(cookie, 'ida weber')
        self.wait_for_end(cookie)
        package = self.data / 'signed/000003-1'
        envelope = package / 'signature/statement.dsse.json'
        envelope.write_text(json.dumps({'payload': 'x'}))
        damaged, = self.signed(cookie)
        self.assertEqual(damaged, {'folder': 'signed/000003-1', 'signed_at': '', 'signers': []})
        shutil.rmtree(package / 'signature')
        self.assertEqual(self.signed(cookie), [damaged])
        self.ask_to_sign(cookie, 'ida weber')
        self.wait_for_end(cookie)
        self.assertEqual([package['folder'] for package in self.signed(cookie)], ['signed/000003-1', 'signed/000003-2'])


if __name__ == '__main__':
    program.main()
