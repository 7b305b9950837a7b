"""`rva inspection list` and `trends`: a table that fits the terminal, and CSV that gives back whatever people typed.

usage: inspection_list_test.py RVA
"""
import contextlib
import csv
import io
import sqlite3

import program

ROWS = (
    (1, 'N1', 'left wing', 'W1', 'Ann', '2026-01-31T23:59:59.999Z'),
    (2, 'N2, "the old one"', 'bay\nwith two lines', '=1+1', 'Ann', '2026-02-01T00:00:00.000Z'),
    (3, 'Flügel ' * 10, 'right wing', 'W3', 'Bob', '2026-02-02T00:00:00.000Z'),
)


class InspectionList(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.data = self.folder / 'data'
        self.succeed('account', 'list', '--data', self.data)  # creates the tables
        with contextlib.closing(sqlite3.connect(self.data / 'rva.db')) as database, database:
            for row in ROWS:
                database.execute('insert into inspection (id, aircraft, zone, work_order, person, created_at, dither) '
                                 'values (?, ?, ?, ?, ?, ?, 1)', row)
                database.execute('insert into view values (?, 0, 1.5, -20)', (row[0],))
            database.execute("insert into side values (3, 'initial', 1, '2026-02-03T00:00:00.000Z', 'Ann', 'b')")

    def listed(self, *options):
        done = self.succeed('inspection', 'list', '--data', self.data, '--csv', *options)
        return list(csv.DictReader(io.StringIO(done.stdout, newline='')))

    def numbers(self, *options):
        return [int(row['number']) for row in self.listed(*options)]

    def test_csv_gives_back_what_was_typed(self):
        rows = {int(row['number']): row for row in self.listed()}
        self.assertEqual(len(rows), 3)
        for number, aircraft, zone, work_order, person, begun in ROWS:
            row = rows[number]
            if work_order.startswith('='):
                work_order = "'" + work_order  # a spreadsheet would compute it otherwise
            self.assertEqual((row['aircraft'], row['zone'], row['work_order'], row['begun_by'], row['begun_at']),
                             (aircraft, zone, work_order, person, begun))
        self.assertEqual((rows[3]['stage'], rows[3]['baseline_at'], rows[3]['final_at'], rows[3]['closed_by']),
                         ('work', '2026-02-03T00:00:00.000Z', '', ''))

    def test_filters(self):
        self.assertEqual(self.numbers(), [3, 2, 1])
        self.assertEqual(self.numbers('--text', 'WING ann'), [1])
        self.assertEqual(self.numbers('--stage', 'work'), [3])
        self.assertEqual(self.numbers('--from', '2026-02-01'), [3, 2])
        self.assertEqual(self.numbers('--until', '2026-02-01'), [1])
        self.assertEqual(self.numbers('--from', '2026-02-01T00:00:00Z', '--until', '2026-02-02'), [2])
        self.assertEqual(self.numbers('--text', 'nowhere'), [])

    def test_the_table_fits_100_columns(self):
        lines = self.succeed('inspection', 'list', '--data', self.data).stdout.splitlines()
        self.assertEqual(len(lines), 4, 'a line for each, whatever was typed')
        self.assertLessEqual(max(map(len, lines)), 100)

    def test_trends(self):
        done = self.succeed('inspection', 'trends', '--data', self.data, '--csv')
        rows = [(row['zone'], row['month'], row['inspections'], row['closed'], row['median_hours'], row['comparisons'])
                for row in csv.DictReader(io.StringIO(done.stdout, newline=''))]
        self.assertEqual(rows, [('bay\nwith two lines', '2026-02', '1', '0', '', '0'), ('left wing', '2026-01', '1', '0', '', '0'),
                                ('right wing', '2026-02', '1', '0', '', '0')])
        lines = self.succeed('inspection', 'trends', '--data', self.data).stdout.splitlines()
        self.assertEqual(len(lines), 4)
        self.assertLessEqual(max(map(len, lines)), 100)
        done = self.succeed('inspection', 'trends', '--data', self.data, '--csv', '--until', '2026-02-01')
        self.assertEqual([row['zone'] for row in csv.DictReader(io.StringIO(done.stdout, newline=''))], ['left wing'])

    def check_usage(self, name, *arguments, command='list'):
        done = self.rva('inspection', command, '--data', self.data, *arguments)
        self.assertEqual((done.returncode, done.stdout), (2, ''), done.stderr)
        self.assertIn(name, done.stderr)

    def test_bad_input(self):
        for option in ('--from', '--until'):
            for text in ('2026-13-01', 'yesterday', '2026-02-01T', '2026-02-30'):
                self.check_usage(text, option, text)
        self.check_usage('--stage', '--stage', 'lost')
        self.check_usage('2026-02-30', '--from', '2026-02-30', command='trends')
        self.check_fails('inspection', 'list', '--data', self.folder / 'nowhere', names=['contains no inspections'])


if __name__ == '__main__':
    program.main()
