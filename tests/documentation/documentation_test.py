"""The documents are right: options, links, named files, the list of pages, and the inspection of the README.

usage: documentation_test.py RVA REPOSITORY
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

RVA, ROOT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
PAGES = [ROOT / name for name in ('README.md', 'CONTRIBUTING.md', 'data/README.md', 'examples/README.md', 'firmware/README.md',
                                 'hardware/README.md', 'hardware/assembly.md', 'hardware/bill-of-materials.md')]
PAGES += sorted((ROOT / 'docs').glob('*.md'))


def anchors(page):
    """The anchors of a page's headings, as GitHub forms them."""
    headings = re.findall(r'^#+ (.*)$', page.read_text(), re.MULTILINE)
    return {re.sub(r'[^\w\- ]', '', heading).lower().replace(' ', '-') for heading in headings}


def share_covered(truth, box):
    """How much of the true box the found one covers."""
    width = min(truth[0] + truth[2], box[0] + box[2]) - max(truth[0], box[0])
    height = min(truth[1] + truth[3], box[1] + box[3]) - max(truth[1], box[1])
    return max(0, width) * max(0, height) / (truth[2] * truth[3])


class Documentation(unittest.TestCase):
    def test_options_page_is_what_the_program_prints(self):
        printed = subprocess.run([RVA, 'options'], capture_output=True, text=True, check=True, timeout=20).stdout
        self.assertEqual((ROOT / 'docs' / 'options.md').read_text(), printed)

    def test_links_lead_somewhere(self):
        links = 0
        for page in PAGES:
            for target, anchor in re.findall(r'\]\(([^)#\s]*)#?([^)\s]*)\)', page.read_text()):
                if not target.startswith('http'):
                    links += 1
                    linked = page.parent / target if target else page
                    self.assertTrue(linked.exists(), f'{page.name}: {target}')
                    self.assertTrue(not anchor or anchor in anchors(linked), f'{page.name}: #{anchor}')
        self.assertGreater(links, 10)

    def test_each_page_is_listed_once(self):
        folder = ROOT / 'docs'
        rows = re.findall(r'^\| \[[^]]+\]\(([^)]+)\) \|', (folder / 'README.md').read_text(), re.MULTILINE)
        listed = [(folder / row).resolve() for row in rows]
        for page in PAGES:
            if page not in (ROOT / 'README.md', folder / 'README.md'):
                self.assertEqual(listed.count(page.resolve()), 1, page.name)

    def test_each_reader_has_a_start(self):
        rows = re.findall(r'^\| ([a-z ]+) \| \[', (ROOT / 'docs' / 'README.md').read_text(), re.MULTILINE)
        self.assertLessEqual({'mechanic', 'inspector', 'quality engineer', 'robotics engineer'}, set(rows))

    def test_named_files_exist(self):
        named = 0
        for page in PAGES:
            for target in re.findall(r'`((?:src|tests|bench|script|data)/[\w/.-]+)`', page.read_text()):
                named += 1
                self.assertTrue((ROOT / target).exists(), f'{page.name}: {target}')
        self.assertGreater(named, 20)

    def test_the_api_page_names_definitions_of_its_schema(self):
        page = (ROOT / 'docs' / 'api.md').read_text()
        definitions = json.loads((ROOT / 'console' / 'schema' / 'api.json').read_text())['$defs']
        named = set(re.findall(r'`([A-Z][a-z]\w*)`', page))
        self.assertGreater(len(named), 10)
        self.assertLessEqual(named, set(definitions))
        for name, definition in definitions.items():
            if name.endswith('Request'):
                self.assertIn(name, named)
        for code in definitions['ErrorCode']['enum']:
            self.assertIn(f'`{code}`', page)

    def test_recorded_inspection_boxes_the_tools(self):
        folder = ROOT / 'data' / 'bin-tools'
        with tempfile.TemporaryDirectory() as name:
            out = pathlib.Path(name) / 'out'
            subprocess.run([RVA, 'detect', folder / 'initial', folder / 'final', '--method', 'constant', '--threshold',
                            '0.02', '--min-blob', '40', '--out', out], check=True, capture_output=True, timeout=60)
            found = [entry['bbox'] for entry in json.loads((out / 'detections.json').read_text())['detections']]
        truth = {entry['name']: entry['bbox'] for entry in json.loads((folder / 'truth.json').read_text())['objects']}
        # Glass and thin steel leave holes in this camera's depth; the two that it measures must be boxed.
        for tool in ('whisk', 'torch'):
            self.assertGreater(max(share_covered(truth[tool], box) for box in found), 0.5, tool)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1], verbosity=2, warnings='ignore')
