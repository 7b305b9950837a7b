"""A console without a screen: the server's API and its WebSocket, with the standard library alone."""
import base64
import json
import os
import socket
import ssl
import struct
import threading
import time
import urllib.error
import urllib.parse
import urllib.request

TEXT, BINARY, CLOSE, PING, PONG = 1, 2, 8, 9, 10


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
        with urllib.request.urlopen(request, timeout=30, context=any_certificate()) as answer:
            if headers is not None:
                headers.update(answer.headers)
            return answer.status, json.loads(answer.read())
    except urllib.error.HTTPError as error:
        return error.code, json.loads(error.read())


class Console:
    """Says hello, keeps the last status, and counts pictures, on a thread of its own."""

    def __init__(self, address, name='Ann', stream=None, cookie=''):
        self.client = os.urandom(16).hex()
        self.status, self.lease, self.refused = None, None, []
        self.pictures = 0
        self.latencies_ms = []
        self.changed = threading.Condition()
        host = urllib.parse.urlsplit(address)
        self.socket = socket.create_connection((host.hostname, host.port), timeout=30)
        if host.scheme == 'https':
            self.socket = any_certificate().wrap_socket(self.socket)
        self.file = self.socket.makefile('rb')
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall((f'GET /api/live HTTP/1.1\r\nHost: {host.netloc}\r\nOrigin: {address}\r\n'
                             f'Cookie: {cookie}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: {key}\r\n'
                             'Sec-WebSocket-Version: 13\r\n\r\n').encode())
        answer = self.file.readline()
        if b' 101 ' not in answer:
            self.close()
            raise ConnectionError(answer)
        while self.file.readline() != b'\r\n':
            pass
        self.lock = threading.Lock()
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
        with self.changed:
            if not self.changed.wait_for(lambda: self.status and condition(self.status), timeout_s):
                raise TimeoutError(self.status)
            return self.status

    def close(self):
        self.file.close()
        self.socket.close()

    def break_off(self):
        """As a cable that is pulled: nothing more is said or heard, and nothing is closed properly."""
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack('ii', 1, 0))
        self.socket.shutdown(socket.SHUT_RDWR)

    def _send(self, kind, payload):
        mask = os.urandom(4)
        head = bytes([0x80 | kind, 0x80 | len(payload)]) if len(payload) < 126 else (
            bytes([0x80 | kind, 0x80 | 126]) + struct.pack('>H', len(payload)))
        masked = bytes(byte ^ mask[i % 4] for i, byte in enumerate(payload))
        with self.lock:
            self.socket.sendall(head + mask + masked)

    def _receive(self):
        first, second = self.file.read(2)
        length = second & 0x7F
        if length == 126:
            length = struct.unpack('>H', self.file.read(2))[0]
        elif length == 127:
            length = struct.unpack('>Q', self.file.read(8))[0]
        return first & 0x0F, self.file.read(length)

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
                    return
        except (OSError, ValueError):
            return

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
            else:
                self.refused.append(message)
            self.changed.notify_all()
