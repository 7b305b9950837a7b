// Writes src/types.ts from schema/api.json; with --check, only compares the two.
// usage: node generate_types.mjs [--check]
import { readFileSync, writeFileSync } from 'node:fs';

const schemaFile = new URL('./api.json', import.meta.url);
const typesFile = new URL('../src/types.ts', import.meta.url);
const widest = 110;

function literal(value) {
  return typeof value === 'string' ? `'${value}'` : String(value);
}

function listOf(item, { minItems, maxItems }) {
  if (maxItems !== undefined && minItems === maxItems) return `[${Array(maxItems).fill(item).join(', ')}]`;
  return item.includes(' | ') ? `(${item})[]` : `${item}[]`;
}

function typeOf(schema) {
  if (schema.$ref) return schema.$ref.replace('#/$defs/', '');
  if ('const' in schema) return literal(schema.const);
  if (schema.enum) return schema.enum.map(literal).join(' | ');
  if (schema.oneOf) return schema.oneOf.map(typeOf).join(' | ');
  switch (schema.type) {
    case 'array':
      return listOf(typeOf(schema.items), schema);
    case 'integer':
      return 'number';
    case 'number':
    case 'string':
    case 'boolean':
    case 'null':
      return schema.type;
  }
  throw new Error(`api.json: no type for ${JSON.stringify(schema)}; give objects definitions of their own, or extend typeOf()`);
}

function comment(schema, indent = '') {
  return schema.description ? [`${indent}/** ${schema.description} */`] : [];
}

function property(name, schema, required) {
  return [...comment(schema, '  '), `  ${name}${required.includes(name) ? '' : '?'}: ${typeOf(schema)};`];
}

function interfaceOf(name, { allOf = [], properties, required = [] }) {
  if (Object.keys(properties).length === 0) return [`export type ${name} = Record<string, never>;`];
  const bases = allOf.length > 0 ? ` extends ${allOf.map(typeOf).join(', ')}` : '';
  const lines = Object.entries(properties).flatMap(([key, schema]) => property(key, schema, required));
  return [`export interface ${name}${bases} {`, ...lines, '}'];
}

function aliasOf(name, schema) {
  const line = `export type ${name} = ${typeOf(schema)};`;
  if (line.length <= widest) return line;
  const options = typeOf(schema).split(' | ').map((option) => `\n  | ${option}`);
  return `export type ${name} =${options.join('')};`;
}

function definition([name, schema]) {
  const lines = schema.type === 'object' ? interfaceOf(name, schema) : [aliasOf(name, schema)];
  return [...comment(schema), ...lines];
}

function typesOf({ $defs }) {
  const blocks = Object.entries($defs).map((one) => definition(one).join('\n'));
  return ['// Generated from schema/api.json by `npm run types`.', ...blocks].join('\n\n') + '\n';
}

const types = typesOf(JSON.parse(readFileSync(schemaFile, 'utf8')));
if (!process.argv.includes('--check')) writeFileSync(typesFile, types);
else if (readFileSync(typesFile, 'utf8') !== types) {
  console.error('src/types.ts: differs from schema/api.json; run `npm run types` in console/');
  process.exitCode = 1;
}
