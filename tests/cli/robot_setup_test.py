"""`rva robot setup` with the built firmware on a simulated board.

usage: robot_setup_test.py RVA ROBOT_IN_THE_LOOP
"""
import subprocess
import sys

import program

ROBOT_IN_THE_LOOP = None


class RobotSetupTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.robot = self.folder / 'robot'
        self.board = subprocess.Popen([ROBOT_IN_THE_LOOP, self.robot, self.folder / 'joints'], stdin=subprocess.PIPE,
                                      stdout=subprocess.PIPE, encoding='utf-8')
        self.addCleanup(self.end_board)
        if 'ready\n' not in self.board.stdout:  # simavr prints what it loads
            self.skipTest('the firmware was not built')

    def end_board(self):
        self.board.stdin.close()
        self.board.wait(60)
        self.board.stdout.close()

    def test_lists_what_is_connected(self):
        done = self.succeed('robot', 'setup', '--robot', f'serial:{self.robot}')
        self.assertEqual(done.stdout.splitlines()[1:3], ['servo: 1 (pan)', 'servo: 2 (tilt)'])
        self.assertRegex(done.stdout, r'firmware: \d+\.\d+\.\d+\n')
        self.assertIn('lamp: 25.', done.stdout)

    def test_refuses_to_name_one_of_two(self):
        done = self.rva('robot', 'setup', '--robot', f'serial:{self.robot}', '--joint', 'pan')
        self.assertEqual((done.returncode, done.stdout), (1, ''))
        self.check_line(done.stderr, ('several servos answer', 'connect the pan servo alone'))

    def test_bad_arguments(self):
        for options, names in ((('--robot', 'sim'), ('serial:DEVICE',)), (('--robot', 'serial:'), ('serial:DEVICE',)),
                               (('--robot', 'serial:/nowhere'), ('/nowhere',)),
                               (('--robot', f'serial:{self.robot}', '--joint', 'roll'), ('--joint',))):
            done = self.rva('robot', 'setup', *options)
            self.assertNotEqual(done.returncode, 0)
            for name in names:
                self.assertIn(name, done.stderr)


if __name__ == '__main__':
    ROBOT_IN_THE_LOOP = sys.argv.pop(2)
    program.main()
