// The texts of the console: all in the files of texts, and the same ones in each language. Without a browser.
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test } from '@playwright/test';
import ts from 'typescript';
import { de } from '../../src/words/de';
import { en, type Figures } from '../../src/words/en';
import { decimal, sentence, setWords, words } from '../../src/words/words';

const sources = join(dirname(fileURLToPath(import.meta.url)), '..', '..', 'src');

/** The names of all texts, as "review.close", with what they are in two languages. */
function textsOf(one: object, other: object, before = ''): [string, unknown, unknown][] {
  return Object.keys({ ...one, ...other }).flatMap((key): [string, unknown, unknown][] => {
    const [a, b] = [(one as Record<string, unknown>)[key], (other as Record<string, unknown>)[key]];
    return typeof a === 'object' && a && typeof b === 'object' && b ? textsOf(a, b, `${before}${key}.`) : [[before + key, a, b]];
  });
}

/** What a person would read of a source file: text between tags, in attributes that are read out, and sentences. */
function literalsIn(name: string, text: string): string[] {
  const read = new Set(['alt', 'aria-label', 'caption', 'label', 'placeholder', 'title']);
  const found: string[] = [];
  const isRead = ({ parent }: ts.Node) => ts.isJsxAttribute(parent) && read.has(parent.name.getText());
  const look = (node: ts.Node) => {
    if (ts.isJsxText(node) && /\p{L}{2}/u.test(node.text)) found.push(node.text.trim());
    if (ts.isStringLiteral(node) && isRead(node) && /\p{L}/u.test(node.text)) found.push(node.text);
    if ((ts.isStringLiteralLike(node) || ts.isTemplateHead(node)) && /^[A-Z]\p{L}* \p{L}/u.test(node.text)) found.push(node.text);
    ts.forEachChild(node, look);
  };
  look(ts.createSourceFile(name, text, ts.ScriptTarget.ES2022, true, ts.ScriptKind.TSX));
  return found;
}

test('each language has the same texts, which differ', () => {
  const texts = textsOf(en, de);
  expect(texts.length).toBeGreaterThan(200);
  expect(texts.filter(([, one, other]) => typeof one !== typeof other || one === '' || other === '').map(([name]) => name)).toEqual([]);
  const alike = texts.filter(([, one, other]) => typeof one === 'string' && one === other).map(([name]) => name);
  expect(alike, 'names, and words that both languages have').toEqual(['page.live', 'page.plan', 'page.space', 'page.title', 'signIn.name', 'inspection.zone']);
});

test('a text with values has all of them in each language', () => {
  const names: (keyof Figures)[] = ['width_px', 'height_px', 'rate_hz', 'repeated_frames', 'frames', 'measured', 'drift_mm', 'duration_s', 'pan_deg', 'tilt_deg', 'free_gb', 'least_free_gb'];
  const figures = Object.fromEntries(names.map((name, i) => [name, `${7050 + i}`]));
  for (const [name, one, other] of textsOf(en, de)) {
    if (typeof one !== 'function' || typeof other !== 'function') continue;
    const values = Array.from({ length: one.length }, (_, i) => (name.startsWith('readiness.sentences.') ? figures : name === 'review.notHere' && i === 1 ? [7001] : name.startsWith('review.undone') && i === 0 ? [7000] : 7000 + i));
    const shown = (text: unknown) => [...String(text).matchAll(/70\d\d/g)].map(String).sort();
    expect(shown(other(...values)), name).toEqual(shown(one(...values)));
    expect(shown(one(...values)).length, name).toBeGreaterThanOrEqual(one.length);
  }
});

test('no other source file has a text that a person reads', () => {
  expect(literalsIn('x.tsx', `const x = <p title="Why">No {'Two words'} {y ? \`One \${y} more\` : ''}</p>;`)).toEqual(['Why', 'No', 'Two words']);
  const files = readdirSync(sources, { recursive: true, encoding: 'utf8' }).filter((file) => /\.tsx?$/.test(file) && !file.startsWith('words/') && file !== 'types.ts');
  expect(files.length).toBeGreaterThan(40);
  const found = files.flatMap((file) => literalsIn(file, readFileSync(join(sources, file), 'utf8')).map((text) => `${file}: ${text}`));
  expect(found.filter((text) => !/: (RVA|mm|px)$/.test(text))).toEqual([]);
});

test('numbers follow the language, and nothing separates thousands', () => {
  try {
    expect(decimal(1234.56, 1)).toBe('1234.6');
    setWords(de, 'de-DE');
    expect(decimal(1234.56, 1)).toBe('1234,6');
    expect(words.review.all(1)).toBe('1 Befund');
    expect(words.review.all(2)).toBe('2 Befunde');
  } finally {
    setWords(en, 'en');
  }
  expect(words).toBe(en);
  expect(sentence('über')).toBe('Über');
});
