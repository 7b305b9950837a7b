"""`rva doctor` with simulated cameras, the built firmware on a simulated board, and an old robot.

usage: doctor_test.py RVA ROBOT_IN_THE_LOOP
"""
import binascii
import json
import os
import re
import select
import subprocess
import sys
import threading
import time
import tty

import program

ROBOT_IN_THE_LOOP = None
WALL = 'sim:wall'
QUICK = ('--frames', 8, '--least-free', 0)
STATES = {'ok', 'warning', 'failed', 'not-tried'}


class OldRobot:
    """Firmware 1.0.0, which has no lamp and refuses to look for servos."""

    def __init__(self, link):
        self.host, self.device = os.openpty()
        tty.setraw(self.device)
        os.symlink(os.ttyname(self.device), link)
        self.running = True
        self.thread = threading.Thread(target=self.run, daemon=True)
        self.thread.start()

    def end(self):
        self.running = False
        self.thread.join()
        os.close(self.host)
        os.close(self.device)

    def send(self, body):
        os.write(self.host, f'${body}*{binascii.crc_hqx(body.encode(), 0xFFFF):04X}\n'.encode())

    def run(self):
        came = b''
        while self.running:
            self.send('READY 1 1.0.0 -90 90 -90 9 90')
            self.send(f'POS {int(1000 * time.monotonic()) % 1000000} 1.00 3 -2.00 3 HOLD')
            if not select.select([self.host], [], [], 0.025)[0]:
                continue
            came += os.read(self.host, 4096)
            *lines, came = came.split(b'\n')
            for number, verb in re.findall(rb'\$(\d+) ([A-Z]+)', b'\n'.join(lines)):
                self.send(f'NAK {int(number)} FORM' if verb in (b'FIND', b'LAMP') else f'ACK {int(number)}')


class DoctorTest(program.ProgramTest):
    def doctor(self, *options, status):
        """The checks by name, of JSON whose form is as the page states."""
        report = json.loads(self.succeed('doctor', '--data', self.folder, '--json', *QUICK, *options, status=status).stdout)
        self.assertEqual((report['format'], report['version']), ('rva-doctor', 1))
        self.assertEqual(report['provenance']['program'], 'rva')
        self.assertEqual(report['state'] == 'failed', status == 3)
        names = [(check['part'], check['name']) for check in report['checks']]
        self.assertEqual(names, [('computer', name) for name in ('udev-rules', 'camera-rights', 'usb', 'robot-rights', 'data-folder', 'disk')]
                         + [('camera', name) for name in ('camera', 'camera-firmware', 'frame-rate', 'fill', 'noise')]
                         + [('robot', name) for name in ('robot', 'robot-firmware', 'servos', 'stop', 'lamp')])
        for check in report['checks']:
            self.assertIn(check['state'], STATES)
            self.assertEqual('advice' in check, check['state'] in ('warning', 'failed'), check)
        return {check['name']: check for check in report['checks']}

    def test_simulated_devices_are_fit(self):
        checks = self.doctor('--camera', WALL, '--robot', 'sim', '--move', status=0)
        for name in ('data-folder', 'disk', 'camera', 'frame-rate', 'fill', 'noise', 'robot', 'servos', 'stop', 'lamp'):
            self.assertEqual(checks[name]['state'], 'ok', checks[name])
        self.assertTrue(0.0 < checks['noise']['values']['noise_px'] < 0.1)
        self.assertGreater(checks['fill']['values']['measured'], 0.9)

    def test_the_firmware_on_its_board_is_fit(self):
        link = self.folder / 'robot'
        board = subprocess.Popen([ROBOT_IN_THE_LOOP, link, self.folder / 'joints'], stdin=subprocess.PIPE,
                                 stdout=subprocess.PIPE, encoding='utf-8')
        try:
            if 'ready\n' not in board.stdout:  # simavr prints what it loads
                self.skipTest('the firmware was not built')
            checks = self.doctor('--camera', 'none', '--robot', f'serial:{link}', '--move', status=0)
            for name in ('robot-rights', 'robot', 'robot-firmware', 'servos', 'stop', 'lamp'):
                self.assertEqual(checks[name]['state'], 'ok', checks[name])
            self.assertEqual(checks['noise']['state'], 'not-tried')
        finally:
            board.stdin.close()
            board.wait(60)
            board.stdout.close()

    def test_an_old_robot_is_named(self):
        link = self.folder / 'old'
        old = OldRobot(link)
        self.addCleanup(old.end)
        checks = self.doctor('--camera', 'none', '--robot', f'serial:{link}', status=3)
        self.assertEqual(checks['robot']['state'], 'ok')
        self.assertEqual((checks['robot-firmware']['state'], checks['robot-firmware']['result']),
                         ('warning', '1.0.0 is older than 1.1.0'))
        self.assertEqual(checks['servos']['state'], 'failed')
        self.assertIn('firmware/README.md', checks['servos']['advice'])
        self.assertEqual(checks['lamp']['state'], 'warning')

    def test_what_is_missing_fails_and_nothing_is_left_behind(self):
        before = self.names()
        checks = self.doctor('--camera', 'sim:missing', '--robot', 'serial:/dev/nowhere', status=3)
        self.assertEqual({name for name, check in checks.items() if check['state'] == 'failed'},
                         {'robot-rights', 'camera', 'robot'})
        self.assertEqual(self.names(), before)

    def test_a_person_reads_what_to_do(self):
        done = self.succeed('doctor', '--camera', WALL, '--data', self.folder / 'new', *QUICK, '--most-noise', 0.001, status=3)
        self.assertRegex(done.stdout, r'(?m)^  failed +noise +0\.0\d+ px of disparity.+\n +do this: keep the scene still')
        self.assertRegex(done.stdout, r'(?m)^  not-tried +servos +no robot was named')
        self.assertTrue(done.stdout.endswith('not fit: begin with the first check that failed, since later ones may follow from it\n'))
        self.assertFalse((self.folder / 'new').exists())

    def test_bad_arguments_are_wrong_usage(self):
        for options, words in ((('--camera', 'nothing'), 'sim:SCENE'),
                               (('--camera', 'none', '--robot', 'walking'), 'serial:DEVICE'),
                               (('--camera', 'none', '--robot', 'serial:'), 'serial:DEVICE'),
                               (('--frames', 1), '--frames'), (('--most-noise', 'nan'), '--most-noise')):
            done = self.rva('doctor', *options)
            self.assertEqual((done.returncode, done.stdout), (2, ''), options)
            self.assertIn(words, done.stderr)


if __name__ == '__main__':
    ROBOT_IN_THE_LOOP = sys.argv.pop(2)
    program.main()
