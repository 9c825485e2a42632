// The tables of docs/elements.md are made from the manifest of the elements: fails when they differ, and with --fix
// writes them.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { elementsManifest } from './elements-manifest.mjs';
import { root } from './setup/paths.mjs';

const path = join(root, 'docs/elements.md');

const code = (text) => `\`${text}\``;
const cell = (text) => text.replaceAll('\n', ' ').replaceAll('|', '\\|');
const sentence = (text) =>
  cell(text)
    .replace(/\.$/, '')
    .replace(/^[A-Z](?=[a-z ])/, (letter) => letter.toLowerCase());

function table(head, rows) {
  const line = (cells) => `| ${cells.join(' | ')} |`.replaceAll('|  |', '| |');
  return [line(head), `|${head.map(() => '---').join('|')}|`, ...rows.map(line)].join('\n');
}

function call({ name, parameters = [] }) {
  return code(`${name}(${parameters.map((parameter) => parameter.name).join(', ')})`);
}

/** What each kind of table is made of. */
const kinds = {
  attributes: ({ attributes }) =>
    table(
      ['attribute', 'property', ''],
      attributes.map(({ name, fieldName, description }) => [
        code(name),
        fieldName ? code(fieldName) : '',
        sentence(description),
      ]),
    ),
  methods: ({ members }) =>
    table(
      ['method', ''],
      members
        .filter(({ kind }) => kind === 'method')
        .map((method) => [call(method), cell(method.description)]),
    ),
  events: ({ events }) =>
    table(
      ['event', 'type', ''],
      events.map(({ name, type, description }) => [
        code(name),
        code(cell(type.text)),
        sentence(description),
      ]),
    ),
  parts: ({ cssParts }) =>
    table(
      ['part', ''],
      cssParts.map(({ name, description }) => [code(name), sentence(description)]),
    ),
  properties: ({ cssProperties }) =>
    table(
      ['custom property', ''],
      cssProperties.map(({ name, description }) => [code(name), sentence(description)]),
    ),
};

const elements = new Map(
  elementsManifest().modules.map(({ declarations: [element] }) => [element.tagName, element]),
);
const before = readFileSync(path, 'utf8');
const after = before.replace(
  /(<!-- (\w+) of ([\w-]+) -->\n)[\s\S]*?(<!-- end -->)/g,
  (_, begin, kind, tag, end) => `${begin}\n${kinds[kind](elements.get(tag))}\n\n${end}`,
);
const isFixed = process.argv.includes('--fix');
if (isFixed) writeFileSync(path, after);
else if (after !== before)
  console.error('docs/elements.md: a table differs; npm run format writes it');
console.log(`elements: ${elements.size} elements`);
process.exit(isFixed || after === before ? 0 : 1);
