// Addresses of what the console shows.
import { expect, test } from '@playwright/test';
import { addressIn, textOf, type Address } from '../../src/address';

const known: [string, Address][] = [
  ['#/', { id: null }],
  ['#/trends', { id: null, trends: true }],
  ['#/inspections/12', { id: 12 }],
  ['#/inspections/12/space', { id: 12, page: 'space' }],
  ['#/inspections/12/review', { id: 12, page: 'review' }],
  ['#/inspections/12/review/3', { id: 12, page: 'review', finding: 3 }],
  ['#/inspections/12/review/-1', { id: 12, page: 'review', finding: -1 }],
  ['#/inspections/12/rounds/2', { id: 12, round: 2 }],
  ['#/inspections/12/rounds/2/space', { id: 12, round: 2, page: 'space' }],
  ['#/inspections/12/rounds/2/review/3', { id: 12, round: 2, page: 'review', finding: 3 }],
];

for (const [text, address] of known) {
  test(`${text} leads to what it was made of`, () => {
    expect(textOf(address)).toBe(text);
    expect(addressIn(text)).toEqual(address);
  });
}

for (const text of ['', '#', '#/inspections', '#/trends/1', '#/inspections/x', '#/inspections/-1', '#/inspections/1/2/3/4', '#/inspections/1e9', '#/inspections/rounds/1', '#/inspections/1/rounds/x', '#/inspections/1/rounds/-1/space', '#/inspections/1/rounds/1/2/3/4', '#/../api/session', 'javascript:1']) {
  test(`"${text}" leads to the list`, () => {
    expect(addressIn(text)).toEqual({ id: null });
  });
}

test('a page that does not exist is left out', () => {
  expect(addressIn('#/inspections/5/elsewhere')).toEqual({ id: 5 });
  expect(textOf({ id: 5, page: 'live', finding: 3 }), 'a finding belongs to the review').toBe('#/inspections/5/live');
});
