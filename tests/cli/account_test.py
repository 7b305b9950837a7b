"""`rva account` on a terminal, which asks for the password.

usage: account_test.py RVA
"""
import os
import signal
import subprocess
import termios

import program

PASSWORD = 'correct horse'


class OnATerminal(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.data = self.folder / 'data'
        self.keyboard, self.terminal = os.openpty()
        self.addCleanup(os.close, self.keyboard)
        self.addCleanup(os.close, self.terminal)
        self.settings = termios.tcgetattr(self.terminal)

    def asked(self):
        """`rva account add`, when it has asked for the password."""
        process = subprocess.Popen(self.command('account', 'add', 'ann', '--data', self.data), stdin=self.terminal,
                                   stdout=subprocess.PIPE, stderr=self.terminal, encoding='utf-8', cwd=self.folder)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        self.displayed = b''
        while b'Password: ' not in self.displayed:
            self.displayed += os.read(self.keyboard, 100)
        return process

    def accounts(self):
        return self.succeed('account', 'list', '--data', self.data).stdout

    def test_the_password_is_not_displayed(self):
        process = self.asked()
        self.assertFalse(termios.tcgetattr(self.terminal)[3] & termios.ECHO)
        os.write(self.keyboard, f'{PASSWORD}\n'.encode())
        self.assertEqual(process.stdout.read(), 'ann may sign in as viewer\n')
        self.assertEqual(process.wait(program.TIMEOUT_S), 0)
        self.displayed += os.read(self.keyboard, 100)
        self.assertEqual(self.displayed, b'Password: \r\n')
        self.assertEqual(termios.tcgetattr(self.terminal), self.settings)
        self.assertIn('ann', self.accounts())

    def test_an_interrupt_restores_the_terminal(self):
        for how in (signal.SIGINT, signal.SIGTERM):
            process = self.asked()
            os.write(self.keyboard, b'corr')
            process.send_signal(how)
            self.assertEqual(process.wait(program.TIMEOUT_S), 128 + how)
            self.assertEqual(termios.tcgetattr(self.terminal), self.settings)
            self.assertEqual(self.accounts(), '')

    def test_an_end_of_input_is_an_empty_password(self):
        process = self.asked()
        os.write(self.keyboard, termios.tcgetattr(self.terminal)[6][termios.VEOF])
        self.assertEqual(process.wait(program.TIMEOUT_S), 1)
        self.assertEqual(termios.tcgetattr(self.terminal), self.settings)


if __name__ == '__main__':
    program.main()
