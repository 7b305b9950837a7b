"""`rva serve` with the built firmware on a simulated board at the end of its serial line, and an ear on that line."""
import os
import pathlib
import select
import subprocess
import termios
import threading
import time
import tty


class Line:
    """A serial line of its own between the program and the robot: passes all on, and notes what the host sends and when."""

    def __init__(self, link, robot):
        self.said = []  # (monotonic seconds, bytes)
        self.link = pathlib.Path(link)
        self.robot = os.open(robot, os.O_RDWR | os.O_NOCTTY)
        tty.setraw(self.robot, termios.TCSANOW)
        self.plug_in()

    def plug_in(self):
        # The device stays open here, so that the line outlives the programs that use it.
        self.host, self.device = os.openpty()
        tty.setraw(self.device)
        os.symlink(os.ttyname(self.device), self.link)
        self.plugged_in = True
        self.ways = [threading.Thread(target=self._pass, args=way, daemon=True)
                     for way in ((self.host, self.robot, True), (self.robot, self.host, False))]
        for way in self.ways:
            way.start()

    def unplug(self):
        self.link.unlink()
        self.plugged_in = False
        for way in self.ways:
            way.join()
        os.close(self.device)
        os.close(self.host)

    def _pass(self, source, target, note):
        try:
            while self.plugged_in:
                if not select.select([source], [], [], 0.05)[0]:
                    continue
                data = os.read(source, 4096)
                if note:
                    self.said.append((time.monotonic(), data))
                os.write(target, data)
        except OSError:
            return

    def stops_after(self, time_s):
        """When the host first said to stop after that, or nothing."""
        return next((at for at, data in list(self.said) if at >= time_s and (b'STOP' in data or b'!' in data)), None)

    def moves(self):
        return sum(data.count(b'MOVE') for _, data in list(self.said))


class NotBuilt(Exception):
    """The firmware: gcc-avr, arduino-core-avr and libsimavr-dev are missing."""


class ServedRobot:
    def __init__(self, program, robot_in_the_loop, scene, folder, *options):
        folder = pathlib.Path(folder)
        robot, joints, line = folder / 'robot', folder / 'joints', folder / 'line'
        self.board = subprocess.Popen([robot_in_the_loop, robot, joints], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                      encoding='utf-8')
        if 'ready\n' not in self.board.stdout:  # simavr prints what it loads
            raise NotBuilt if self.board.wait() == 77 else ChildProcessError('the board did not come up')
        self.line = Line(line, robot)
        self.server = subprocess.Popen(
            [program, 'serve', '--camera', f'sim:{scene},joints={joints}', '--robot', f'serial:{line}', '--data',
             folder / 'data', '--port', '0', *options], stdout=subprocess.PIPE, encoding='utf-8')
        self.address = self.server.stdout.readline().strip()

    def end(self):
        self.server.terminate()
        status = self.server.wait(60)
        self.server.stdout.close()
        self.board.stdin.close()
        self.board.wait(60)
        self.board.stdout.close()
        return status
