"""`rva inspection report --pdf`: other programs read the pages, and verify the signature.

usage: pdf_report_test.py RVA
"""
import os
import re
import subprocess

import program
from written_inspections import write_inspection

RTL = 'שלום \u202eWO\u2069'
LONG = 'N' * 300
NAMES = f'Zoë 東京 🛩 {RTL} {LONG}\nsecond line\t<b>&'


def output_of(*command):
    return subprocess.run([str(part) for part in command], capture_output=True, encoding='utf-8', check=False)


class PdfReport(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.data = self.folder / 'data'
        self.succeed('account', 'list', '--data', self.data)  # creates the tables
        self.pdf = self.folder / 'report.pdf'

    def written(self, *options, **inspection):
        """The path of the report on an inspection, which is a sound PDF file."""
        write_inspection(self.data, 1, **inspection)
        return self.report(*options)

    def report(self, *options, number=1, out=None):
        out = out or self.pdf
        done = self.succeed('inspection', 'report', '--data', self.data, '--inspection', number, '--pdf', out, *options)
        self.assertEqual(done.stdout, f'{out}\n')
        self.assertEqual(done.stderr, '', 'Pango and cairo have nothing to complain of')
        checked = output_of('qpdf', '--check', out)
        self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)
        return out

    def text(self, *options):
        return re.sub(r'\s+', ' ', output_of('pdftotext', '-layout', *options, self.pdf, '-').stdout)

    def pages(self):
        return int(re.search(r'^Pages:\s+(\d+)', self.info(), re.MULTILINE)[1])

    def info(self):
        return output_of('pdfinfo', self.pdf).stdout

    def test_nothing_found_is_one_page_of_either_size(self):
        self.written(views=2)
        self.assertEqual(self.pages(), 1)
        self.assertRegex(self.info(), r'Page size:\s+595\.\d+ x 841\.\d+ pts \(A4\)')
        text = self.text()
        for part in ('✓ No debris remains in what was inspected.', 'Inspected: at least 85 % of each view', 'no depth after 5 %',
                     'Closed by Ida, 2026-01-01 11:00 UTC', 'Inspection 1 · N123AB · Left wing, bay 3 · WO-4711', 'Page 1 of 1',
                     'false_alarms 0.05', 'SHA-256'):
            self.assertIn(part, text)
        self.report('--paper', 'letter', '--overwrite')
        self.assertEqual(self.pages(), 1)
        self.assertIn('612 x 792 pts (letter)', self.info())

    def test_every_finding_is_whole_with_its_pictures_and_decision(self):
        count = 30
        self.written(findings=count, views=2)
        pages = output_of('pdftotext', '-layout', self.pdf, '-').stdout.split('\f')[:-1]
        self.assertEqual(len(pages), self.pages())
        self.assertGreater(len(pages), 5)
        for number, page in enumerate(pages, 1):
            self.assertIn(f'Page {number} of {len(pages)}', page)
            self.assertIn('Inspection 1 · N123AB', page)
            lines = [line.strip() for line in page.splitlines() if line.strip()]
            self.assertNotRegex(lines[-2], r'^(Findings of round|\d+ · Added|Settings|Checksums|Actions)', 'an orphaned heading')
        for finding in range(1, count + 1):
            (page,) = [page for page in pages if re.search(rf'^\s*{finding} · Added$', page, re.MULTILINE)]
            after = re.split(rf'^\s*{finding} · Added$', page, flags=re.MULTILINE)[1]
            self.assertRegex(re.split(r'^\s*\d+ · Added$', after, flags=re.MULTILINE)[0],
                             rf'(?s){finding + 100} mm × 9\.5 mm.*Debris, removed: taken out {finding} — Ida, 2026-01-01 10:00 UTC'
                             r'.*Before\s+After\s+Before, depth\s+After, depth')
        pictures = output_of('pdfimages', '-list', self.pdf).stdout.splitlines()[2:]
        self.assertEqual(len(pictures), 2 + 4 * count, 'two views, four close-ups of each finding')
        self.assertEqual({line.split()[8] for line in pictures}, {'jpeg'})

    def test_the_contents_are_those_of_the_html_in_its_order(self):
        page = self.folder / 'report.html'
        write_inspection(self.data, 1, findings=3)
        self.succeed('inspection', 'report', '--data', self.data, '--inspection', 1, '--pdf', self.pdf, '--out', page)
        html = re.sub(r'(?s)<style>.*?</style>|<title>.*?</title>|<footer>.*', '', page.read_text())
        words = re.sub(r'<[^>]+>', ' ', html).split()
        text = output_of('pdftotext', '-raw', self.pdf, '-').stdout
        shown = re.sub(r'\s', '', re.sub(r'(?m)^Inspection 1 · .*\nPage .*$', '', text))
        self.assertEqual(shown[:200], re.sub(r'&#?\w+;', '', ''.join(words))[:200])

    def test_the_same_records_give_the_same_bytes_at_any_time(self):
        self.written(findings=1)
        first = self.pdf.read_bytes()
        os.environ['SOURCE_DATE_EPOCH'] = '1900000000'
        self.addCleanup(os.environ.pop, 'SOURCE_DATE_EPOCH')
        self.report('--overwrite')
        self.assertEqual(self.pdf.read_bytes(), first)
        self.assertIn('CreationDate: Thu Jan 1 11:00:00 2026', re.sub(r' +', ' ', output_of('env', 'TZ=UTC', 'pdfinfo', self.pdf).stdout))
        self.assertIn('Title: N123AB · Left wing, bay 3 · WO-4711 · inspection report', re.sub(r' +', ' ', self.info()))
        self.assertIn(b'/Lang (en)', first)

    def test_fonts_are_embedded_and_any_name_is_shown(self):
        self.written(findings=1, aircraft=NAMES, person='Zoë 東京 🛩', note='note\n' * 3 + RTL)
        rows = output_of('pdffonts', self.pdf).stdout.splitlines()[2:]
        self.assertTrue(rows)
        for row in rows:
            self.assertEqual(row.split()[-5], 'yes', row)
        text = re.sub(r'\s', '', output_of('pdftotext', self.pdf, '-').stdout)
        for part in ('Zoë', '東京', LONG, 'secondline<b>&', 'Page1of'):
            self.assertIn(part, text)
        self.assertGreaterEqual(text.count(',2026-01-0110:00UTC'), 1, 'words from right to left affect nothing after them')
        self.assertNotIn('CTU', text)

    def test_a_note_longer_than_a_page_is_continued(self):
        self.written(closing_note='\n'.join(f'line {k}.' for k in range(200)))
        text = self.text()
        for k in range(200):
            self.assertIn(f'line {k}.', text)
        self.assertGreater(self.pages(), 2)

    def test_files_are_replaced_only_when_asked(self):
        self.written()
        before = self.pdf.read_bytes()
        command = ('inspection', 'report', '--data', self.data, '--inspection', 1)
        self.check_fails(*command, '--pdf', self.pdf, names=['already exists', '--overwrite'])
        self.check_fails(*command, '--out', self.folder / 'report.html', '--pdf', self.pdf, names=['already exists'])
        self.check_fails(*command, '--pdf', self.folder / 'none' / 'report.pdf', names=['none'])
        self.check_fails(*command, '--pdf', self.data / 'rva.db', '--overwrite', names=['is in the folder of the inspections'])
        self.assertEqual(self.pdf.read_bytes(), before)
        for wrong in ((), ('--out', 'a', '--pdf', './a'), ('--out', 'a.html', '--paper', 'letter'), ('--pdf', 'a.pdf', '--paper', 'a5'),
                      ('--out', 'a.html', '--sign-with', 'shop.p12'), ('--pdf', 'a.pdf', '--passphrase-file', 'x')):
            self.assertEqual(self.rva(*command, *wrong).returncode, 2, wrong)

    def test_without_fonts_the_error_states_what_to_install(self):
        write_inspection(self.data, 1)
        (self.folder / 'fonts.conf').write_text('<?xml version="1.0"?><!DOCTYPE fontconfig SYSTEM "urn:fontconfig:fonts.dtd"><fontconfig/>')
        os.environ['FONTCONFIG_FILE'] = str(self.folder / 'fonts.conf')
        self.addCleanup(os.environ.pop, 'FONTCONFIG_FILE')
        self.check_fails('inspection', 'report', '--data', self.data, '--inspection', 1, '--pdf', self.pdf, names=['needs a font'])


if __name__ == '__main__':
    program.main()
