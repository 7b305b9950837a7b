"""Measures searches in the list of many inspections, and how long other requests wait while several consoles request
all of it, or the trends of all inspections.

usage: lists_bench.py RVA [--inspections 5000] [--lists 6]
"""
import argparse
import pathlib
import sqlite3
import subprocess
import tempfile
import threading
import time
import urllib.request

SCENE = pathlib.Path(__file__).resolve().parents[1] / 'data' / 'scenes' / 'three-tools.yaml'
VIEWS, FINDINGS = 4, 5
REPEATS = 11
OPEN_EVERY = 100  # one inspection in so many is not closed
PAGE = 'most=51'
SEARCHES = {'first page': PAGE, 'an aircraft': f'text=n77&{PAGE}', 'words of no inspection': f'text=left+nowhere&{PAGE}',
            'one of the first': f'text=WO-00007&{PAGE}', 'in review': f'stage=review&{PAGE}',
            'closed, of a month long ago': f'stage=done&until=2001-02-01&{PAGE}'}


class Server:
    def __init__(self, rva, folder):
        console = folder / 'console'
        console.mkdir(exist_ok=True)
        (console / 'index.html').write_text('<title>RVA</title>')
        self.process = subprocess.Popen([rva, 'serve', '--camera', f'sim:{SCENE}', '--data', folder / 'data', '--port', '0',
                                         '--console', console], stdout=subprocess.PIPE, encoding='utf-8')
        self.address = self.process.stdout.readline().strip()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait(60)
        self.process.stdout.close()

    def seconds(self, path):
        start = time.monotonic()
        with urllib.request.urlopen(self.address + path, timeout=120) as answer:
            answer.read()
        return time.monotonic() - start


def fill(database, inspections):
    """Writes inspections with comparisons and decisions into the database, as the program does."""
    with sqlite3.connect(database) as rows:
        for i in range(1, inspections + 1):
            rows.execute('insert into inspection (id, aircraft, zone, work_order, person, created_at, dither, comparison) '
                         "values (?, ?, 'left wing, bay 3', ?, 'Ann', datetime('2001-01-01', ? || ' hours'), 4, 1)",
                         (i, f'N{i % 997}', f'WO-{i:05}', i))
            rows.execute("insert into comparison values (?, 1, 't', 'comparison-1', 1)", (i,))
            if i % OPEN_EVERY:
                rows.execute("insert into closing values (?, 1, 'Ann', '', 't')", (i,))
            rows.executemany("insert into side values (?, ?, 1, 't', 'Ann', 'base')", [(i, 'initial'), (i, 'final')])
            rows.executemany('insert into view values (?, ?, 0, 0)', [(i, view) for view in range(VIEWS)])
            rows.executemany('insert into compared_view (inspection, comparison, view, method, compared, unseen, invalid, judged, warnings) '
                             "values (?, 1, ?, 'spatial', 1, 0, 0, 1, '[]')", [(i, view) for view in range(VIEWS)])
            for finding in range(1, FINDINGS + 1):
                rows.execute('insert into finding (inspection, comparison, number, view, same_as, kind, box, centroid) '
                             "values (?, 1, ?, 0, ?, 'added', '[1,2,3,4]', '[1,2]')", (i, finding, finding))
                rows.execute('insert into decision (inspection, comparison, finding, verdict, note, person, decided_at) '
                             "values (?, 1, ?, 'false-alarm', '', 'Ann', 't')", (i, finding))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('rva')
    parser.add_argument('--inspections', type=int, default=5000)
    parser.add_argument('--lists', type=int, default=6)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix='rva-lists-') as name:
        folder = pathlib.Path(name)
        with Server(arguments.rva, folder):
            pass  # starting the server creates the tables
        fill(folder / 'data' / 'rva.db', arguments.inspections)
        with Server(arguments.rva, folder) as server:
            time.sleep(2)  # until the camera's first view is rendered
            for what, query in SEARCHES.items():
                times = sorted(server.seconds(f'/api/inspections?{query}') for _ in range(REPEATS))
                print(f'{what}: median {1000 * times[REPEATS // 2]:.0f} ms, longest {1000 * times[-1]:.0f} ms')
            for path in ('/api/inspections', '/api/trends'):
                measure_beside_others(server, path, arguments.lists)


def measure_beside_others(server, path, requests):
    """Requests the path once, and several times at once while other requests are timed."""
    alone = server.seconds(path)
    times = []
    threads = [threading.Thread(target=lambda: times.append(server.seconds(path))) for _ in range(requests)]
    for thread in threads:
        thread.start()
    others = []
    while any(thread.is_alive() for thread in threads):
        others.append(server.seconds('/api/inspections/7'))
    for thread in threads:
        thread.join()
    print(f'{path}: one {alone:.2f} s; {requests} at a time, the last after {max(times):.2f} s; '
          f'meanwhile {len(others)} other requests, the longest {max(others):.3f} s')


if __name__ == '__main__':
    main()
