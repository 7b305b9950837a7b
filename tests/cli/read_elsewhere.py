"""What commands, other programs and people read of a closed inspection: parts of api_schema_test.py."""
import json
import re
import subprocess
import urllib.request

from captures import read_image
from read_page import ReadPage
from simulations import contents


def without_time(text):
    return re.sub(r'Made by rva [^,]+, [0-9: -]+ UTC', '', text)


class ReadElsewhere:
    """Checks of inspection 1 of the server's data folder."""

    def export(self):
        """A closed inspection as a folder: what the server sends, and the files that it names."""
        out = self.folder / 'exported'
        self.succeed('export', '--data', self.folder / 'data', '--inspection', 1, '--out', out)
        record = json.loads((out / 'inspection.json').read_text())
        inspection = record['inspection']
        self.read_picture(out, inspection['marked'][1].pop('picture'))
        self.read_picture(out, inspection['marked'][0].pop('picture'))
        regions = json.loads((out / inspection['views'][0].pop('regions')).read_text())
        self.assertEqual(regions['ignore'], inspection['views'][0]['ignore'])
        self.assertEqual(inspection, self.get('inspections/1', 'Inspection'))
        for round in record['rounds']:
            for folder in round.pop('results'):
                json.loads((out / folder / 'detections.json').read_text())
                self.read_picture(out, f'{folder}/final_color.png')
        self.assertEqual(record['rounds'], self.get('inspections/1/rounds', 'RoundList')['rounds'])
        self.assertEqual([(round['side'], round['round']) for round in record['captured']],
                         [('initial', 1), ('final', 1), ('final', 3)], 'the second was cancelled')
        for round in record['captured']:
            for capture in round['captures'][0]:
                self.succeed('info', out / capture)
        verdicts = [entry['verdict'] for entry in record['decisions'] if 'marked' in entry]
        self.assertEqual(verdicts, ['debris-removed', 'debris-removed', 'false-alarm'])
        self.assertIn(('debris-removed', 1), [(entry['verdict'], entry.get('comparison')) for entry in record['decisions']],
                      'of the first comparison')

    def report(self):
        """The same page from the server, the command and the export; its checksums are what a shell computes."""
        with urllib.request.urlopen(f'{self.address}/api/inspections/1/report', timeout=60) as answer:
            self.assertEqual(answer.headers['Content-Type'], 'text/html; charset=utf-8')
            self.assertIn("default-src 'none'", answer.headers['Content-Security-Policy'])
            page = answer.read().decode()
        with urllib.request.urlopen(f'{self.address}/api/inspections/1/report.pdf', timeout=60) as answer:
            self.assertEqual(answer.headers['Content-Type'], 'application/pdf')
            pdf = answer.read()
        self.assertEqual(pdf, (self.folder / 'exported' / 'report.pdf').read_bytes())
        self.refuse('GET', 'inspections/7/report', None, 404)
        self.refuse('GET', 'inspections/7/report.pdf', None, 404)
        read = ReadPage(page)
        self.assertEqual(read.faults, [])
        self.assertIn('Closed by Ann', read.text)
        self.assertIn('Findings of round 2 (the last)', read.text)
        out = self.folder / 'report.html'
        path = ['inspection', 'report', '--data', self.folder / 'data', '--inspection', 1, '--out', out]
        self.succeed(*path)
        for other in (out, self.folder / 'exported' / 'report.html'):
            self.assertEqual(without_time(ReadPage(other.read_text()).text), without_time(read.text))
        self.assertEqual(self.rva(*path).returncode, 1, 'nothing is replaced unasked')
        self.succeed(*path, '--overwrite')
        records = self.folder / 'data' / 'rva.db'
        before = records.read_bytes()
        self.assertEqual(self.rva(*path[:-1], records, '--overwrite').returncode, 1, 'of the records themselves')
        self.assertEqual(records.read_bytes(), before)
        inspection = self.folder / 'data/inspections/000001'
        for folder in ('initial', 'final-3', 'comparison-1', 'marks', 'snapshots', 'baseline-check'):
            printed = subprocess.run(f'find {folder} -type f -print0 | LC_ALL=C sort -z | xargs -0 sha256sum | sha256sum', shell=True,
                                     cwd=inspection, capture_output=True, encoding='utf-8', check=True).stdout
            self.assertIn(f'{folder} {printed.split()[0]}', read.text)

    def trends(self):
        """Sums over all inspections, of which there is one: from the server, and as the command has them."""
        trends = self.get('trends', 'Trends')
        self.assertEqual([trends['months'][0] | {'month': '', 'zone': 'bay'}, trends['zones'][0] | {'month': ''}],
                         2 * [trends['zone_months'][0] | {'month': ''}])
        rounds = self.get('inspections/1/rounds', 'RoundList')['rounds']
        self.assertEqual((trends['sum']['inspections'], trends['sum']['closed'], trends['sum']['comparisons']), (1, 1, len(rounds)))
        objects = sum(finding['same_as'] == finding['number'] for round in rounds for finding in round['findings'])
        self.assertEqual(sum(trends['sum']['found'].values()), objects)
        self.assertEqual(sum(named['objects'] for named in trends['sum']['debris']), sum(
            trends['sum'][by][verdict] for by in ('found', 'marked') for verdict in ('removed', 'left', 'unreachable')))
        with urllib.request.urlopen(f'{self.address}/api/trends.csv?text=bay', timeout=60) as answer:
            self.assertEqual(answer.headers['Content-Type'], 'text/csv; charset=utf-8')
            csv = answer.read().decode()
        self.assertEqual(csv.replace('\r', ''), self.succeed('inspection', 'trends', '--data', self.folder / 'data', '--csv').stdout)
        self.assertEqual(self.get('trends?text=nowhere', 'Trends')['zones'], [])
        self.refuse('GET', 'trends?zone=bay', None, 400)

    def rerun(self):
        """The recorded captures give the recorded results again."""
        out = self.folder / 'again'
        path = ['inspection', 'rerun', '--data', self.folder / 'data', '--inspection', 1, '--out', out]
        self.assertIn('has no comparison 99', self.rva(*path, '--comparison', 99).stderr)
        self.assertIn('gives the recorded results again', self.succeed(*path).stdout)
        self.assertEqual(contents(out).keys(), contents(self.folder / 'data/inspections/000001/comparison-3').keys())
        self.assertEqual(self.rva(*path).returncode, 1, 'nothing is replaced')

    def export_crops(self):
        """What was decided on, as labelled pictures that are parts of those that were shown."""
        out = self.folder / 'crops'
        path = ['export-crops', '--data', self.folder / 'data', '--out', out]
        self.assertIn('of 1 inspection(s)', self.succeed(*path).stdout)
        crops = json.loads((out / 'crops.json').read_text())['crops']
        found = self.get('inspections/1', 'Inspection')
        latest = {crop['finding']: crop for crop in crops if crop.get('comparison') == found['comparison']}
        detected = {finding['number']: finding for finding in found['findings'] if finding.get('planned') != 'missing'}
        self.assertEqual(latest.keys(), detected.keys(), 'a missing part of the plan shows nothing')
        self.assertEqual({crop['label'] for crop in latest.values()}, {'installed-work'})
        self.assertEqual((out / 'planes.f16').stat().st_size, 14 * 48 * 48 * 2 * (out / 'findings.json').read_text().count('"kind"'))
        marked = {crop['finding']: (crop['label'], crop.get('object')) for crop in crops if crop.get('marked')}
        self.assertEqual(marked, {1: ('false-alarm', None), 2: ('debris', 'rag')})
        pictures = self.folder / f'data/inspections/000001/comparison-{found["comparison"]}/results/000'
        for number, crop in latest.items():
            u, v, width, height = detected[number]['bbox']
            self.assertEqual(set(crop['files']), {'initial_color', 'final_color', 'initial_depth', 'final_depth'})
            for name, file in crop['files'].items():
                self.assertTrue(file.startswith('installed-work/'), file)
                x, y = crop['box_in_crop'][:2]
                cut, whole = read_image(out / file), read_image(pictures / f'{name}.png')
                self.assertTrue((cut[y:y + height, x:x + width] == whole[v:v + height, u:u + width]).all(), file)
        before = contents(out)
        self.assertEqual(self.rva(*path).returncode, 1, 'nothing is replaced unasked')
        self.succeed(*path, '--overwrite', '--inspection', 1, '--inspection', 1)
        again = contents(out)
        self.assertEqual(before.keys(), again.keys())
        for bad in (['--inspection', 7], ['--data', self.folder]):
            done = self.rva(*path, '--overwrite', *bad)
            self.assertEqual(done.returncode, 1 if bad[0] == '--inspection' else 2, done.stderr)
        self.assertEqual(contents(out), again)

    def read_picture(self, out, name):
        self.assertEqual((out / name).read_bytes()[:4], b'\x89PNG', name)
