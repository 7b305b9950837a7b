// The colours of both themes: all in one file, and legible, the bright ones in sunlight. Without a browser.
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test } from '@playwright/test';

const sources = join(dirname(fileURLToPath(import.meta.url)), '..', '..', 'src');
const sheet = readFileSync(join(sources, 'theme.css'), 'utf8');

function variablesOf(theme: string): Record<string, string> {
  const block = new RegExp(`data-theme='${theme}'\\] \\{([^}]*)\\}`).exec(sheet)![1]!;
  return Object.fromEntries([...block.matchAll(/--([\w-]+): (#[0-9a-f]{6});/g)].map(([, name, value]) => [name!, value!]));
}

// WCAG 2.2, relative luminance and contrast ratio.
function luminance(color: string): number {
  const [r, g, b] = [1, 3, 5].map((at) => parseInt(color.slice(at, at + 2), 16) / 255).map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)) as [number, number, number];
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

function contrast(one: string, other: string): number {
  const [low, high] = [luminance(one), luminance(other)].sort((a, b) => a - b) as [number, number];
  return (high + 0.05) / (low + 0.05);
}

const grounds = ['ground', 'panel', 'raised', 'notice'];
const inks = ['text', 'soft', 'good', 'bad', 'warn'];
const least = { dark: { text: 4.5, shape: 3, line: 1.3 }, bright: { text: 7, shape: 4, line: 3 } };

for (const [theme, { text, shape, line }] of Object.entries(least)) {
  test(`the ${theme} theme is legible`, () => {
    const colors = variablesOf(theme);
    const pairs = [...grounds.flatMap((ground) => inks.map((ink) => [ink, ground] as const)), ['accent-ink', 'accent'] as const];
    const weak = pairs.filter(([ink, ground]) => contrast(colors[ink]!, colors[ground]!) < text);
    expect(weak, 'text').toEqual([]);
    expect(contrast('#ffffff', colors['stop']!)).toBeGreaterThan(text);
    for (const kind of ['added', 'removed', 'appearance']) expect(contrast(colors[kind]!, colors['ground']!), kind).toBeGreaterThan(shape);
    expect(contrast(colors['line']!, colors['raised']!), 'line').toBeGreaterThan(line);
  });
}

test('both themes have the same colours', () => {
  expect(Object.keys(variablesOf('bright'))).toEqual(Object.keys(variablesOf('dark')));
  expect(contrast('#000000', '#ffffff')).toBeCloseTo(21, 9);
});

test('no other style sheet has a colour of its own', () => {
  const files = readdirSync(sources, { recursive: true, encoding: 'utf8' }).filter((file) => file.endsWith('.css') && file !== 'theme.css');
  expect(files.length).toBeGreaterThan(5);
  const coloured = files.filter((file) => /#[0-9a-f]{3,8}\b|\b(rgb|hsl)a?\(/i.test(readFileSync(join(sources, file), 'utf8')));
  expect(coloured).toEqual([]);
});

test('the scale of depth has the colours that the server draws', () => {
  // Jet, by its definition, not by its stops.
  const jet = (share: number) => [3, 2, 1].map((peak) => Math.max(0, Math.min(1, 1.5 - Math.abs(4 * share - peak))));
  const stops = [...sheet.matchAll(/(#[0-9a-f]{6}) ([\d.]+)%/g)].map(([, color, at]) => ({ at: Number(at) / 100, rgb: [1, 3, 5].map((i) => parseInt(color!.slice(i, i + 2), 16) / 255) }));
  expect(stops.length).toBeGreaterThanOrEqual(2);
  const scale = (share: number) => {
    const next = Math.max(1, stops.findIndex(({ at }) => at >= share));
    const [a, b] = [stops[next - 1]!, stops[next]!];
    return a.rgb.map((value, i) => value + ((b.rgb[i]! - value) * (share - a.at)) / (b.at - a.at));
  };
  const furthest = Math.max(...Array.from({ length: 101 }, (_, i) => i / 100).flatMap((share) => scale(share).map((value, i) => Math.abs(value - jet(share)[i]!))));
  expect(furthest).toBeLessThan(0.01);
});
