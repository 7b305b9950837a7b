"""`rva serve` under attack, with a console as its client."""
import http.client
import select
import signal
import subprocess
import sys
import urllib.error
import urllib.request

from setting import ROOT

sys.path.insert(0, str(ROOT / 'tests' / 'cli'))

from console_client import Console, ask  # noqa: E402

START_LIMIT_S = 30
TASK_LIMIT_S = 180
STOP_LIMIT_S = 60
# The exceptions that a client gets from a killed server. They include TimeoutError and those of urllib.
BROKEN_OFF = (OSError, http.client.HTTPException, ValueError)


class Refused(Exception):
    """The server answered with an error or another unexpected answer."""


class Server:
    """
    arguments:   arguments of rva serve in addition to those common to all servers
    log:         file for its output on stderr
    environment: environment for kill_at.c, or None
    account:     (name, password) to sign in with, if there are accounts
    """

    def __init__(self, setting, data, arguments, log, environment=None, account=None):
        console = ('--console', setting.console) if setting.console else ()
        self.log, self.console, self.cookie, self.person = log, None, '', 'Ann'
        with log.open('wb') as opened:
            self.process = subprocess.Popen(
                [str(argument) for argument in (setting.rva, 'serve', '--data', data, '--port', 0, '--frames', 4, '--dither', 1,
                                                '--least-free', 0, *console, *arguments)],
                env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=opened)
        try:
            self.address = self._read_address()
            if account and self.ask('GET', 'session')['sign_in_needed']:
                self.sign_in(*account)
            self.open_console()
        except BaseException:
            self.kill()
            raise

    def ask(self, method, path, body=None):
        client = self.console.client if self.console else ''
        status, answer = ask(self.address, method, '/api/' + path, body, client=client, cookie=self.cookie)
        if status >= 300:
            raise Refused(f'{method} {path}: {status}, {answer["error"]["message"]}')
        return answer

    def download(self, path):
        request = urllib.request.Request(f'{self.address}/api/{path}', headers={'Cookie': self.cookie})
        try:
            with urllib.request.urlopen(request, timeout=STOP_LIMIT_S) as answer:
                return answer.read()
        except urllib.error.HTTPError as error:
            raise Refused(f'GET {path}: {error.code}') from error

    def do(self, path, body):
        """Starts a task, and waits until the status reports that it is done."""
        last = self.console.status['task']['number']
        self.ask('POST', path, body)
        status = self.console.wait_for(lambda status: status['task']['number'] > last and status['task']['end'] != 'running',
                                       TASK_LIMIT_S)
        if status['task']['end'] != 'done':
            raise Refused(f'POST {path}: {status["task"]["end"]}, {status["task"].get("problem", "no reason given")}')

    def sign_in(self, name, password):
        headers = {}
        status, answer = ask(self.address, 'POST', '/api/sign-in', {'name': name, 'password': password}, headers=headers)
        if status != 200:
            raise Refused(f'{name} cannot sign in: {answer["error"]["message"]}')
        self.cookie, self.person = headers['Set-Cookie'].split(';')[0], name

    def open_console(self):
        self.console = Console(self.address, name=self.person, cookie=self.cookie)
        self.console.wait_for(lambda status: status['camera']['streams'] and
                              ('robot' not in status or 'pan_deg' in status['robot']), START_LIMIT_S)

    def is_dead(self):
        """Whether the server was killed. Waits briefly for the signal to take effect."""
        try:
            return self.process.wait(5) is not None
        except subprocess.TimeoutExpired:
            return False

    def kill(self):
        self.process.kill()
        self._end(STOP_LIMIT_S)

    def stop(self):
        """Ends the server as a user does. Returns whether it ended in time."""
        self.process.send_signal(signal.SIGTERM)
        try:
            self._end(STOP_LIMIT_S)
            return True
        except subprocess.TimeoutExpired:
            self.kill()
            return False

    def said(self):
        return self.log.read_text(errors='replace')

    def _end(self, limit_s):
        self.process.wait(limit_s)
        self.process.stdout.close()
        if self.console:
            self.console.close()
            self.console = None

    def _read_address(self):
        ready, _, _ = select.select([self.process.stdout], [], [], START_LIMIT_S)
        address = self.process.stdout.readline().decode().strip() if ready else ''
        if not address.startswith('http'):
            lines = self.said().strip().splitlines()
            raise Refused('does not start: ' + (lines[-1] if lines else 'prints no address'))
        return address
