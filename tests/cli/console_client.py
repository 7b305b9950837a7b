"""A console without a screen: the server's API and its WebSocket, with the standard library alone."""
import base64
import contextlib
import json
import os
import select
import socket
import ssl
import struct
import threading
import time
import urllib.error
import urllib.parse
import urllib.request

TEXT, BINARY, CLOSE, PING, PONG = 1, 2, 8, 9, 10
SILENCE_S = 60  # the server sends something every second


def any_certificate():
    context = ssl.create_default_context()
    context.check_hostname = False
    context.verify_mode = ssl.CERT_NONE
    return context


def ask(address, method, path, body=None, client='', cookie='', headers=None):
    """(status, answer) of a request; `headers` takes those of the answer."""
    request = urllib.request.Request(address + path, method=method,
                                     data=None if body is None else json.dumps(body).encode(),
                                     headers={'Content-Type': 'application/json', 'X-RVA-Client': client,
                                              'Cookie': cookie})
    try:
        with urllib.request.urlopen(request, timeout=SILENCE_S, context=any_certificate()) as answer:
            if headers is not None:
                headers.update(answer.headers)
            return answer.status, json.loads(answer.read())
    except urllib.error.HTTPError as error:
        return error.code, json.loads(error.read())


class Connection:
    """Bytes to and from the server, for several threads.

    OpenSSL does not let two threads use a connection at the same time, and Python's ssl module does not keep them apart:
    the socket does not block, each call of it is made under a lock, and nobody waits while they have the lock.
    """

    def __init__(self, address):
        host = urllib.parse.urlsplit(address)
        self.socket = socket.create_connection((host.hostname, host.port), timeout=SILENCE_S)
        if host.scheme == 'https':
            self.socket = any_certificate().wrap_socket(self.socket)
        self.socket.setblocking(False)
        self.calling, self.sending = threading.Lock(), threading.Lock()
        self.came = b''

    def send(self, data):
        with self.sending:  # one message after the other
            while data:
                data = data[self._call(lambda: self.socket.send(data), select.POLLOUT):]

    def read(self, length):
        while len(self.came) < length:
            self._receive()
        data, self.came = self.came[:length], self.came[length:]
        return data

    def read_line(self):
        while b'\n' not in self.came:
            self._receive()
        return self.read(self.came.index(b'\n') + 1)

    def shut_down(self):
        """Ends the connection, and wakes threads that wait for the server."""
        with contextlib.suppress(OSError):  # the server was quicker
            # Not the SSLSocket's own, which would have what has come read as it is, enciphered.
            socket.socket.shutdown(self.socket, socket.SHUT_RDWR)

    def close(self):
        self.socket.close()

    def _receive(self):
        data = self._call(lambda: self.socket.recv(65536), select.POLLIN)
        if not data:
            raise ConnectionError('the connection has ended')
        self.came += data

    def _call(self, action, awaited):
        """What the action gives when it need not wait any more."""
        while True:
            with self.calling:
                try:
                    return action()
                except ssl.SSLWantReadError:
                    awaited = select.POLLIN
                except ssl.SSLWantWriteError:
                    awaited = select.POLLOUT
                except BlockingIOError:
                    pass
            poll = select.poll()
            poll.register(self.socket, awaited)
            if not poll.poll(1000 * SILENCE_S):
                raise TimeoutError(f'nothing came or went for {SILENCE_S} s')


class Console:
    """Says hello, keeps the last status, and counts pictures, on a thread of its own."""

    def __init__(self, address, name='Ann', stream=None, cookie=''):
        self.client = os.urandom(16).hex()
        self.status, self.lease, self.refused, self.pointed = None, None, [], []
        self.pictures = 0
        self.latencies_ms = []
        self.changed = threading.Condition()
        self.ended = None  # why nothing more is heard
        self.connection = Connection(address)
        key = base64.b64encode(os.urandom(16)).decode()
        self.connection.send((f'GET /api/live HTTP/1.1\r\nHost: {urllib.parse.urlsplit(address).netloc}\r\n'
                              f'Origin: {address}\r\nCookie: {cookie}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n'
                              f'Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n').encode())
        answer = self.connection.read_line()
        if b' 101 ' not in answer:
            self.connection.close()
            raise ConnectionError(answer)
        while self.connection.read_line() != b'\r\n':
            pass
        self.thread = threading.Thread(target=self._listen, daemon=True)
        self.thread.start()
        self.say(type='hello', protocol=1, client=self.client, name=name)
        if stream:
            self.say(type='watch', stream=stream)

    def say(self, **message):
        self._send(TEXT, json.dumps(message).encode())

    def drive(self, pan, tilt):
        self.say(type='drive', pan=pan, tilt=tilt, stamp_ms=1000 * time.monotonic())

    def wait_for(self, condition, timeout_s=60):
        """Until condition(status), of which there is one."""
        def met():
            return self.status and condition(self.status)
        with self.changed:
            self.changed.wait_for(lambda: met() or self.ended, timeout_s)
            if met():
                return self.status
            if self.ended:
                raise ConnectionError(f'{self.ended!r} after {self.status}') from self.ended
            raise TimeoutError(self.status)

    def close(self):
        self.connection.shut_down()
        self.thread.join()
        self.connection.close()

    def break_off(self):
        """As a cable that is pulled: nothing more is sent or received, and nothing is closed properly."""
        self.connection.socket.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack('ii', 1, 0))
        self.connection.shut_down()

    def _send(self, kind, payload):
        mask = os.urandom(4)
        head = bytes([0x80 | kind, 0x80 | len(payload)]) if len(payload) < 126 else (
            bytes([0x80 | kind, 0x80 | 126]) + struct.pack('>H', len(payload)))
        masked = bytes(byte ^ mask[i % 4] for i, byte in enumerate(payload))
        self.connection.send(head + mask + masked)

    def _receive(self):
        first, second = self.connection.read(2)
        length = second & 0x7F
        if length == 126:
            length = struct.unpack('>H', self.connection.read(2))[0]
        elif length == 127:
            length = struct.unpack('>Q', self.connection.read(8))[0]
        return first & 0x0F, self.connection.read(length)

    def _listen(self):
        try:
            while True:
                kind, payload = self._receive()
                if kind == PING:
                    self._send(PONG, payload)
                elif kind == BINARY:
                    self._show(payload)
                elif kind == TEXT:
                    self._hear(json.loads(payload))
                elif kind == CLOSE:
                    raise ConnectionError(f'the server closed the WebSocket: {payload[2:].decode()}')
        except Exception as error:  # wait_for() raises it
            with self.changed:
                self.ended = error
                self.changed.notify_all()

    def _show(self, payload):
        length = struct.unpack('<I', payload[:4])[0]
        head = json.loads(payload[4:4 + length])
        self.latencies_ms.append(1000 * time.time() - head['taken_ms'])
        self.pictures += 1
        self.say(type='shown')

    def _hear(self, message):
        with self.changed:
            if message['type'] == 'status':
                self.status = message
            elif message['type'] == 'lease':
                self.lease = message
            elif message['type'] == 'pointed':
                self.pointed.append(message)
            else:
                self.refused.append(message)
            self.changed.notify_all()
