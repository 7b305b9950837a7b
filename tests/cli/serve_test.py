"""`rva serve` and `rva account` as a person starts them; driving through the built firmware on a simulated board.

usage: serve_test.py RVA ROBOT_IN_THE_LOOP
"""
import os
import signal
import subprocess
import sys
import time

import program
from console_client import Console, ask
from served_robot import NotBuilt, ServedRobot
from simulations import TOOLS

ROBOT = None


def eventually(condition, timeout_s=60):
    end = time.monotonic() + timeout_s
    while time.monotonic() < end:
        if found := condition():
            return found
        time.sleep(0.01)
    raise TimeoutError


class WithARobot(program.ProgramTest):
    OPTIONS = ()

    def setUp(self):
        super().setUp()
        console = self.folder / 'console'
        console.mkdir()
        (console / 'index.html').write_text('<title>RVA</title>')
        try:
            self.served = ServedRobot(program.PROGRAM, ROBOT, TOOLS, self.folder, '--console', console, *self.OPTIONS)
        except NotBuilt:
            self.skipTest('the firmware was not built (gcc-avr, arduino-core-avr, libsimavr-dev)')
        self.addCleanup(self.served.end)
        self.line = self.served.line
        self.console = self.open_console('Ann')
        self.console.wait_for(lambda status: 'pan_deg' in status['robot'])

    def open_console(self, name):
        console = Console(self.served.address, name=name)
        self.addCleanup(console.close)
        return console

    def angle(self):
        return self.console.status['robot'].get('pan_deg', 0.0)


class Driving(WithARobot):
    def setUp(self):
        super().setUp()
        self.console.say(type='lease', action='take', name='Ann')

    def hold(self, pan, tilt, until):
        def held():
            self.console.drive(pan, tilt)
            time.sleep(0.04)
            return until()
        return eventually(held)

    def drive_away(self):
        before = self.angle()
        self.hold(1.0, 0.0, lambda: self.angle() > before + 5.0)

    def expect_rest(self):
        def rests():
            before = self.angle()
            time.sleep(0.5)
            return self.angle() == before
        eventually(rests)

    def test_held_sticks_turn_the_servos_and_letting_go_stops_them(self):
        self.drive_away()
        let_go = time.monotonic()
        self.console.drive(0.0, 0.0)
        eventually(lambda: self.line.stops_after(let_go))
        moves = self.line.moves()
        self.expect_rest()
        self.assertEqual(self.line.moves(), moves, 'no command to move is sent after the stop')

    def test_a_line_that_breaks_stops_them(self):
        self.drive_away()
        other = self.open_console('Bob')
        broken = time.monotonic()
        self.console.break_off()
        eventually(lambda: self.line.stops_after(broken))
        other.wait_for(lambda status: not status['robot']['driving'] and not status['robot']['armed'])

    def test_a_console_that_says_nothing_more_stops_them(self):
        self.drive_away()
        silent = time.monotonic()
        eventually(lambda: self.line.stops_after(silent))
        self.expect_rest()

    def test_anybodys_stop_stops_them(self):
        self.drive_away()
        other = self.open_console('Bob')
        pressed = time.monotonic()
        other.say(type='stop')
        self.hold(1.0, 0.0, lambda: self.line.stops_after(pressed))
        moves = self.line.moves()
        for _ in range(10):
            self.console.drive(1.0, 0.0)
            time.sleep(0.04)
        self.assertLessEqual(self.line.moves(), moves + 1, 'sticks that are still held have no effect')


class Capturing(WithARobot):
    OPTIONS = ('--frames', '6', '--dither', '2')

    def ask(self, method, path, body=None, status=200):
        answered, answer = ask(self.served.address, method, '/api/' + path, body)
        self.assertEqual(answered, status, answer)
        return answer

    def test_a_robot_that_is_unplugged_is_waited_for(self):
        self.ask('POST', 'inspections', {'person': 'Ann'}, 201)
        views = [{'pan_deg': pan, 'tilt_deg': -20.0} for pan in (0.0, 12.0, 24.0)]
        self.ask('PUT', 'inspections/1/views', {'views': views})
        self.ask('POST', 'inspections/1/capture', {'side': 'initial', 'person': 'Ann'}, 202)
        self.console.wait_for(lambda status: status['task'].get('view', 0) >= 1)
        self.line.unplug()
        status = self.console.wait_for(lambda status: status['task'].get('waiting'))
        self.assertIn(self.line.link.name, status['task']['waiting'])
        self.assertEqual(status['task']['end'], 'running')
        kept = sorted((self.folder / 'data').glob('**/depth/*.png'))
        self.line.plug_in()
        status = self.console.wait_for(lambda status: status['task']['end'] != 'running', timeout_s=120)
        self.assertEqual(status['task']['end'], 'done', status)
        self.assertEqual(self.ask('GET', 'inspections/1')['stage'], 'work')
        self.assertTrue(all(path.exists() for path in kept if '.partial' not in str(path)), 'what was taken is kept')


class Starting(program.ProgramTest):
    def test_what_cannot_be_served_is_reported(self):
        for arguments, status, words in (
                (('--camera', 'sim:missing.yaml'), 1, 'missing.yaml'),
                (('--camera', 'nothing'), 2, 'sim:SCENE'),
                (('--camera', f'sim:{TOOLS}', '--robot', 'serial:/dev/missing'), 1, '/dev/missing'),
                (('--camera', f'sim:{TOOLS}', '--robot', 'walking'), 2, 'serial:DEVICE'),
                (('--camera', f'replay:{self.folder}', '--robot', 'sim'), 2, 'recording'),
                (('--camera', f'sim:{TOOLS}', '--port', '99999'), 2, '65535'),
                (('--camera', f'sim:{TOOLS}', '--address', '0.0.0.0', '--port', '0'), 2, '--tls-certificate'),
                (('--camera', f'sim:{TOOLS}', '--address', 'everywhere'), 2, '--address'),
                (('--camera', f'sim:{TOOLS}', '--console', self.folder), 1, 'console')):
            with self.subTest(arguments):
                done = self.rva('serve', '--data', self.folder / 'data', *arguments)
                self.assertEqual(done.returncode, status, done.stderr)
                self.assertIn(words, done.stderr)
                self.assertEqual(done.stderr.count('\n'), 1)

    def test_options_come_from_a_file_and_a_signal_ends_it(self):
        console = self.folder / 'console'
        console.mkdir()
        (console / 'index.html').write_text('<title>RVA</title>')
        config = self.folder / 'rva.conf'
        config.write_text(f'camera = "sim:{TOOLS}"\nrobot = "none"\ndata = "{self.folder}/data"\nport = 0\n'
                          f'console = "{console}"\n')
        server = subprocess.Popen(self.command('serve', '--config', config), stdout=subprocess.PIPE, encoding='utf-8')
        address = server.stdout.readline().strip()
        try:
            self.assertEqual(ask(address, 'GET', '/api/inspections'), (200, {'inspections': []}))
        finally:
            server.send_signal(signal.SIGINT)
            self.assertEqual(server.wait(60), 130)
            server.stdout.close()

    def test_a_file_of_options_is_checked(self):
        for text, status, words in (('walk = 1\n', 2, 'walk'), ('port = many\n', 2, 'port'), ('[x]\nport = 1\n', 2, 'x.port'),
                                    ('', 2, '--camera')):
            (self.folder / 'rva.conf').write_text(text)
            done = self.rva('serve', '--config', self.folder / 'rva.conf')
            self.assertEqual(done.returncode, status, done.stderr)
            self.assertIn(words, done.stderr)
        self.assertIn('missing.conf', self.rva('serve', '--config', 'missing.conf').stderr)

    def test_others_come_by_tls_and_sign_in(self):
        console = self.folder / 'console'
        console.mkdir()
        (console / 'index.html').write_text('"RVA"')
        certificate, key, data = self.folder / 'certificate.pem', self.folder / 'key.pem', self.folder / 'data'
        subprocess.run(['openssl', 'req', '-x509', '-newkey', 'rsa:2048', '-nodes', '-keyout', key, '-out', certificate,
                        '-days', '2', '-subj', '/CN=rva'], check=True, capture_output=True)
        options = ('--camera', f'sim:{TOOLS}', '--data', data, '--port', '0', '--console', console, '--address',
                   '0.0.0.0', '--tls-certificate', certificate, '--tls-key', key)
        self.assertIn('rva account add', self.rva('serve', *options).stderr)
        subprocess.run(self.command('account', 'add', 'ann', '--role', 'operator', '--data', data),
                       input='correct horse\n', check=True, capture_output=True, encoding='utf-8')
        server = subprocess.Popen(self.command('serve', *options), stdout=subprocess.PIPE, encoding='utf-8')
        try:
            address = server.stdout.readline().strip().replace('0.0.0.0', '127.0.0.1')
            self.assertTrue(address.startswith('https://'))
            headers = {}
            ask(address, 'GET', '/', headers=headers)
            self.assertIn('Strict-Transport-Security', headers)
            self.assertEqual(ask(address, 'GET', '/api/inspections')[0], 401)
            with self.assertRaises(ConnectionError):
                Console(address)
            self.assertEqual(ask(address, 'POST', '/api/sign-in', {'name': 'ann', 'password': 'wrong horse'})[0], 401)
            headers = {}
            ask(address, 'POST', '/api/sign-in', {'name': 'ann', 'password': 'correct horse'}, headers=headers)
            self.assertIn('Secure', headers['Set-Cookie'])
            cookie = headers['Set-Cookie'].split(';')[0]
            self.assertEqual(ask(address, 'GET', '/api/inspections', cookie=cookie)[0], 200)
            signed_in = Console(address, cookie=cookie)
            self.addCleanup(signed_in.close)
            signed_in.wait_for(lambda status: status['camera']['streams'])
            with self.assertRaises(OSError):
                ask(address.replace('https', 'http'), 'GET', '/api/session')
            # One program at a time has the data.
            second = self.rva('serve', *options)
            self.assertEqual(second.returncode, 1)
            self.assertIn('used by another', second.stderr)
            # The last account goes: nobody has access any more, signed in or not.
            subprocess.run(self.command('account', 'remove', 'ann', '--data', data), check=True, capture_output=True)
            self.assertEqual(ask(address, 'GET', '/api/inspections', cookie=cookie)[0], 401)
            self.assertEqual(ask(address, 'GET', '/api/inspections')[0], 401)
            signed_in.thread.join(60)
            self.assertFalse(signed_in.thread.is_alive(), 'the live view is closed, too')
        finally:
            server.terminate()
            server.wait(60)
            server.stdout.close()

    def test_accounts(self):
        data = ('--data', self.folder / 'data')

        def add(name, password, *more):
            return subprocess.run(self.command('account', 'add', name, *more, *data), input=password + '\n',
                                  capture_output=True, encoding='utf-8', timeout=30)
        self.assertEqual(add('ann', 'correct horse', '--role', 'inspector').returncode, 0)
        self.assertEqual(add('bob', 'short').returncode, 1)
        self.assertEqual(add('', 'correct horse').returncode, 2)
        self.assertEqual(add('eve', 'correct horse', '--role', 'king').returncode, 2)
        self.assertEqual(self.succeed('account', 'list', *data).stdout, 'inspector  ann\n')
        self.assertNotIn(b'correct horse', (self.folder / 'data' / 'rva.db').read_bytes())
        self.succeed('account', 'remove', 'ann', *data)
        self.assertEqual(self.rva('account', 'remove', 'ann', *data).returncode, 1)


if __name__ == '__main__':
    ROBOT = os.path.abspath(sys.argv.pop(2))
    program.main()
