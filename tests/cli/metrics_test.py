"""What monitoring programs read of `rva serve`: metrics, health, and the lines of its log.

usage: metrics_test.py RVA
"""
import os
import re
import signal
import subprocess
import time
import urllib.error
import urllib.request

from prometheus_client.parser import text_string_to_metric_families

import program
from console_client import Console, ask
from simulations import TOOLS

LINE = re.compile(r'(?P<level><\d>)?rva: (?P<message>.+) event=(?P<event>[a-z-]+)(?P<fields>( [a-z_]+=("([^"\\]|\\.)*"|[\w.:/+-]+))*)\Z')


class MetricsTest(program.ProgramTest):
    def serve(self, *options, journal=False):
        """Starts a server; its address."""
        console = self.folder / 'console'
        console.mkdir()
        (console / 'index.html').write_text('<title>RVA</title>')
        log = open(self.folder / 'log', 'wb')
        self.addCleanup(log.close)
        stream = os.fstat(log.fileno())
        environment = dict(os.environ, JOURNAL_STREAM=f'{stream.st_dev}:{stream.st_ino}' if journal else '8:1')
        self.server = subprocess.Popen(
            self.command('serve', '--camera', f'sim:{TOOLS}', '--robot', 'sim', '--data', self.folder / 'data', '--port', 0,
                         '--console', console, *options), stdout=subprocess.PIPE, stderr=log, encoding='utf-8', env=environment)
        self.addCleanup(self.server.stdout.close)
        self.addCleanup(self.server.wait, 60)
        self.addCleanup(self.server.terminate)
        return self.server.stdout.readline().strip()

    def log(self):
        """All lines of the log, taken apart."""
        lines = (self.folder / 'log').read_text().splitlines()
        matches = [LINE.match(line) for line in lines]
        self.assertNotIn(None, matches, lines)
        return matches

    def scrape(self, address):
        with urllib.request.urlopen(address + '/metrics', timeout=60) as answer:
            self.assertEqual(answer.headers['Content-Type'], 'text/plain; version=0.0.4; charset=utf-8')
            families = list(text_string_to_metric_families(answer.read().decode()))
        self.assertEqual(len({family.name for family in families}), len(families), 'a family is there once')
        for family in families:
            self.assertTrue(family.documentation, family.name)
            self.assertIn(family.type, ('counter', 'gauge', 'histogram'), family.name)
        return {(sample.name, *sorted(sample.labels.values())): sample.value for family in families for sample in family.samples}

    def test_metrics_count_what_happens(self):
        address = self.serve('--metrics', '--readiness-frames', 8)
        console = Console(address, stream='depth')
        self.addCleanup(console.close)
        console.wait_for(lambda status: status['camera']['streams'])
        before = self.scrape(address)
        self.assertEqual(ask(address, 'POST', '/api/readiness', {})[0], 202)
        console.wait_for(lambda status: status['task']['number'] == 1 and status['task']['end'] != 'running', timeout_s=120)
        after = self.scrape(address)
        self.assertEqual(before['rva_tasks_total', 'done', 'readiness'], 0)
        self.assertEqual(after['rva_tasks_total', 'done', 'readiness'], 1)
        self.assertGreaterEqual(after['rva_camera_frames_total',] - before['rva_camera_frames_total',], 8)
        for name in ('rva_uptime_seconds', 'process_cpu_seconds_total'):
            self.assertGreater(after[name,], before[name,], name)
        self.assertEqual(after['rva_http_request_duration_seconds_count', '202'], 1)
        self.assertGreater(after['rva_http_request_duration_seconds_count', '200'], 0)
        self.assertGreater(after['rva_picture_delay_seconds_count', 'depth'], 0)
        self.assertEqual((after['rva_consoles',], after['rva_robot_connected',]), (1, 1))
        self.assertTrue(0.0 < after['rva_camera_measured_ratio',] <= 1.0)
        self.assertTrue(0 < after['rva_data_free_bytes',] <= after['rva_data_size_bytes',])
        for check in ('camera', 'robot', 'data', 'records'):
            self.assertEqual(after['rva_healthy', check], 1, check)

    def test_metrics_need_the_option(self):
        address = self.serve()
        with self.assertRaises(urllib.error.HTTPError) as refused:
            urllib.request.urlopen(address + '/metrics', timeout=60)
        refused.exception.close()
        self.assertEqual(refused.exception.code, 404)
        self.assertIn(ask(address, 'GET', '/api/health')[0], (200, 503), 'health does not')

    def test_health_names_what_is_wrong(self):
        address = self.serve('--least-free', 1000000)
        status, health = ask(address, 'GET', '/api/health')
        self.assertEqual((status, health['healthy']), (503, False))
        problems = {check['name']: check['problem'] for check in health['checks'] if not check['healthy']}
        self.assertEqual(problems.keys(), {'disk'}, health)
        self.assertRegex(problems['disk'], r'\d GB are free of at least 1000000\.0 GB')
        self.assertEqual(ask(address, 'POST', '/api/health', {})[0], 405)
        self.wait_for_event('disk-failed')

    def wait_for_event(self, name):
        end = time.monotonic() + 60
        while name not in [line['event'] for line in self.log()]:
            self.assertLess(time.monotonic(), end, name)
            time.sleep(0.05)

    def test_the_journal_gets_levels(self):
        address = self.serve('--least-free', 1000000, '--readiness-frames', 8, journal=True)
        self.assertEqual(ask(address, 'POST', '/api/readiness', {})[0], 202)
        self.assertEqual(ask(address, 'POST', '/api/cancel', {})[0], 202)
        self.wait_for_event('task-ended')
        self.wait_for_event('disk-failed')
        self.server.send_signal(signal.SIGTERM)
        self.assertEqual(self.server.wait(60), 143)
        levels = {line['event']: line['level'] for line in self.log()}
        self.assertEqual({name: levels[name] for name in ('started', 'disk-failed', 'task-started', 'stopped')},
                         {'started': '<5>', 'disk-failed': '<4>', 'task-started': '<6>', 'stopped': '<5>'})
        self.assertIn('signal=15', self.log()[-1]['fields'])

    def test_others_get_none(self):
        self.serve()
        self.wait_for_event('started')
        self.assertEqual({line['level'] for line in self.log()}, {None})

    def test_what_ends_it_is_an_error_in_the_journal(self):
        ours, theirs = os.pipe()
        stream = os.fstat(theirs)
        done = subprocess.run(self.command('serve', '--camera', 'nothing', '--data', self.folder / 'data', '--console', self.folder), stderr=theirs,
                              env=dict(os.environ, JOURNAL_STREAM=f'{stream.st_dev}:{stream.st_ino}'), timeout=60)
        os.close(theirs)
        with os.fdopen(ours) as log:
            self.assertRegex(log.read(), r'\A<3>rva: [^\n]+\n\Z')
        self.assertEqual(done.returncode, 2)


if __name__ == '__main__':
    program.main()
