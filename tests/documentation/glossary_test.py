"""No source file and no page uses a word that docs/glossary.md lists under "Words that are not used".

usage: glossary_test.py REPOSITORY
"""
import pathlib
import re
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv[1])
SECTION = '## Words that are not used\n'
PAGES = ('README.md', 'CONTRIBUTING.md', 'CMakeLists.txt')
FOLDERS = ('bench', 'console/schema', 'console/src', 'console/tests', 'data', 'debian', 'docs', 'examples', 'firmware',
           'hardware', 'python', 'script', 'src', 'tests')
SUFFIXES = ('.cpp', '.css', '.dox', '.h', '.hpp', '.ino', '.json', '.md', '.mjs', '.py', '.pyi', '.scad', '.ts', '.tsx', '.txt',
            '.yaml', '')
# A space of an expression stands for all that separates words: also the end of a line of a comment or of a
# part of a string, an underscore, and a capital letter within an identifier.
BETWEEN_WORDS = r'(?:\s*"?\s+(?:(?:///?|#|\*|")\s*)?|_|(?-i:(?<=[a-z0-9])(?=[A-Z])))'


def compiled(words):
    return re.compile(words.replace(r'\|', '|').replace(' ', BETWEEN_WORDS), re.IGNORECASE)


def forbidden(glossary):
    """The rows of the table: an example, the expression that finds it, and what to write."""
    section = glossary.partition(SECTION)[2].partition('\n## ')[0]
    rows = re.findall(r'^\| ([^|`]+) \| `((?:\\\||[^|`])+)` \| ([^|]+) \|$', section, re.MULTILINE)
    heads = 2
    if not rows or len(rows) < section.count('\n| ') - heads:
        raise ValueError('docs/glossary.md: no table of words that are not used, or a row of another form')
    return [(example, compiled(words), instead) for example, words, instead in rows]


def without_listed_words(glossary):
    """The glossary without the section and the last column of its other tables, which list such words."""
    before, section, rest = glossary.partition(SECTION)
    section += re.sub(r'.', '', rest.partition('\n## ')[0])
    after = ''.join(rest.partition('\n## ')[1:])
    return re.sub(r'(?m)^(\|.*\|)[^|]*\|$', r'\1', before + section + after)


def texts(root):
    """Relative path and text of each file to read. This test, which uses such words, is left out."""
    files = [root / name for name in PAGES]
    for folder in FOLDERS:
        files += [path for path in sorted((root / folder).rglob('*')) if path.suffix in SUFFIXES]
    for path in files:
        name = path.relative_to(root).as_posix()
        if not path.is_file() or 'corpus' in path.parts or name == 'tests/documentation/glossary_test.py':
            continue
        text = path.read_text(encoding='utf-8')
        yield name, without_listed_words(text) if name == 'docs/glossary.md' else text


def uses(root, rows):
    """A line for each use: where, which word, what to write."""
    found, read = [], 0
    for read, (name, text) in enumerate(texts(root), 1):
        for _, words, instead in rows:
            for match in words.finditer(text):
                line = text.count('\n', 0, match.start()) + 1
                found.append(f'{name}:{line}: "{" ".join(match[0].split())}" - write: {instead}')
    if read == 0:
        raise ValueError(f'{root}: no file was read')
    return found


class Glossary(unittest.TestCase):
    rows = forbidden((ROOT / 'docs' / 'glossary.md').read_text(encoding='utf-8'))

    def test_forbidden_words_are_not_used(self):
        found = uses(ROOT, self.rows)
        if found:
            self.fail('\n' + '\n'.join(found))

    def test_each_expression_finds_its_example(self):
        for example, words, _ in self.rows:
            self.assertTrue(words.search(example), f'{words.pattern} does not find "{example}"')

    def test_planted_word_is_found(self):
        planted = {'src/a.cpp': '\n// What the camera\n// says.\n',
                   'src/b.cpp': '"as the camera "\n    "says"',
                   'console/src/c.tsx': 'const cameraSays = 1;', 'tests/d.py': 'def camera_says():',
                   'docs/e.md': 'The depth image.\n', 'README.md': 'what the camera says'}
        rows = forbidden(SECTION + '| the camera says | `camera says` | states |\n')
        with tempfile.TemporaryDirectory() as folder:
            for name, text in planted.items():
                path = pathlib.Path(folder) / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding='utf-8')
            found = uses(pathlib.Path(folder), rows)
        where = [line.partition(': ')[0] for line in found]
        self.assertEqual(where, ['README.md:1', 'console/src/c.tsx:1', 'src/a.cpp:2', 'src/b.cpp:1',
                                 'tests/d.py:1'])
        self.assertIn('"camera // says" - write: states', found[2])

    def test_refuses_a_bad_table_and_an_empty_repository(self):
        with self.assertRaises(ValueError):
            forbidden(SECTION + '\nNone.\n\n## Captures\n\n| a | `b` | c |\n')
        with self.assertRaises(ValueError):
            forbidden(SECTION + '\n| not | words | write |\n| --- | --- | --- |\n| a | `b` | c |\n| bad |\n')
        with tempfile.TemporaryDirectory() as folder, self.assertRaises(ValueError):
            uses(pathlib.Path(folder), self.rows)


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1], verbosity=2, warnings='ignore')
