"""A time stamp authority for tests: `openssl ts -reply` behind HTTP, which can be made to misbehave."""
import http.server
import subprocess
import threading

CONFIGURATION = '''
[tsa]
default_tsa = authority
[authority]
serial = {folder}/serial
signer_digest = sha256
default_policy = 1.2.3.4.1
digests = sha256
ess_cert_id_alg = sha256
ess_cert_id_chain = {chain}
[authority_certificate]
extendedKeyUsage = critical,timeStamping
'''


def openssl(*arguments):
    return subprocess.run(['openssl', *map(str, arguments)], check=True, capture_output=True).stdout


class TimeStampServer:
    """Answers in a thread; `behave` is changed between requests. Its CA is in `ca`."""

    def __init__(self, folder, chain='no'):
        folder.mkdir()
        self.folder, self.ca, self.behave, self.asked = folder, folder / 'ca.pem', self.stamp, []
        (folder / 'tsa.cnf').write_text(CONFIGURATION.format(folder=folder, chain=chain))
        (folder / 'serial').write_text('01\n')
        new_key = 'req', '-newkey', 'ec', '-pkeyopt', 'ec_paramgen_curve:P-256', '-nodes', '-batch'
        openssl(*new_key, '-x509', '-days', 3650, '-subj', '/CN=Root of tests', '-keyout', folder / 'ca.key', '-out', self.ca)
        openssl(*new_key, '-subj', '/CN=Authority of tests', '-keyout', folder / 'tsa.key', '-out', folder / 'tsa.csr')
        openssl('x509', '-req', '-in', folder / 'tsa.csr', '-CA', self.ca, '-CAkey', folder / 'ca.key', '-CAcreateserial', '-days', 3650,
                '-extfile', folder / 'tsa.cnf', '-extensions', 'authority_certificate', '-out', folder / 'tsa.pem')
        outer = self

        class Handler(http.server.BaseHTTPRequestHandler):
            def do_POST(self):
                question = self.rfile.read(int(self.headers['Content-Length']))
                outer.asked.append((self.path, self.headers['Content-Type'], question))
                status, answer = outer.behave(question)
                self.send_response(status)
                self.send_header('Content-Type', 'application/timestamp-reply')
                self.send_header('Content-Length', str(len(answer)))
                self.end_headers()
                self.wfile.write(answer)

            def log_message(self, *_):
                pass

        self.server = http.server.ThreadingHTTPServer(('127.0.0.1', 0), Handler)
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        self.url = f'http://127.0.0.1:{self.server.server_port}/tsa'

    def close(self):
        self.server.shutdown()
        self.server.server_close()

    def stamp(self, question):
        (self.folder / 'question').write_bytes(question)
        return 200, openssl('ts', '-reply', '-config', self.folder / 'tsa.cnf', '-queryfile', self.folder / 'question',
                            '-inkey', self.folder / 'tsa.key', '-signer', self.folder / 'tsa.pem', '-chain', self.ca)

    def stamp_instead(self, *query):
        """Stamps another question than the one that was asked."""
        return lambda _: self.stamp(openssl('ts', '-query', '-sha256', *query))

    @staticmethod
    def digest_in(question):
        """The imprint of a question, in hexadecimal."""
        return question[question.index(bytes.fromhex('0420')) + 2:][:32].hex()
