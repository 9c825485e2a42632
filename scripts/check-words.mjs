// All that people read stands in web/words, in a table per language. Fails for prose in markup, in texts of the programs
// and of what they print, for keys of the markup that the tables lack, and for keys that only one of both has. What a
// language lacks or has too many of is a fault of types; what its function says it is tested.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import ts from 'typescript';
import { sourceFiles } from './files.mjs';
import { root } from './setup/paths.mjs';

/** Texts of several words that nobody reads on a screen or on paper, by the reason why they are there. */
const allowed = {
  'names that programs read, the same in every language': [
    'Mountain folds',
    'Valley folds',
    'All pieces',
    'Fold and assemble',
    'Helvetica, Arial, sans-serif',
    'foldwright: ${}',
    'foldwright batch',
    'Piece ${}',
    'Part ${}',
    'Foldwright',
    'Model',
    'Textures',
    'Regmarks',
    'Guide',
    'Flaps',
    'Numbers',
    'Cuts',
  ],
  'keys of formats and of libraries': [
    'Files',
    'Usage:',
    'Arguments:',
    'Options:',
    'Continuous',
    'Standard',
    'Image',
    'Properties',
    'Layers',
  ],
  'errors of the program itself, for those who look for the fault': [
    'The markup has no ${} at ${}',
    'A file is missing, or there is no room',
    'A document that is not on the page cannot be printed',
    'This page takes no frame',
    'The result must come first',
    'A sheet is not an SVG document',
    'the picture is damaged',
    'This browser draws no canvases',
    'An empty tile makes no pattern',
    'The outline runs along no face',
  ],
  'keys of keyboards': ['Escape', 'Enter', 'Home', 'End'],
  'code of styles and selectors': ['(prefers-reduced-motion: reduce)', 'input, select', 'page ${}'],
};

/** Where people are spoken to. */
const programs = ['web/app', 'web/view', 'web/cli', 'web/export', 'web/element'];

/** Two words with blanks between them, or one that begins like a sentence; code of shaders, styles, selectors and markup is none. */
function isProse(text) {
  if (/[{}<>=;]|\w\(|\[\w/.test(text.replaceAll('${}', ''))) return false;
  return /[A-Za-z]{2,}[,;:.]? +[A-Za-z$]/.test(text) || /^[A-Z][a-z]+[.:]? *$/.test(text);
}

/** Names of classes, selectors and other words that no sentence is made of. */
function isCode(text) {
  const words = text.split(/[\s,]+/);
  return words.some((word) => /--|__|^[.#]/.test(word)) || /px system-ui/.test(text);
}

/** The text of a string or template, with `${}` for what is put in; null for any other node. */
function textOf(node) {
  if (ts.isStringLiteralLike(node)) return node.text;
  if (!ts.isTemplateExpression(node)) return null;
  const rest = node.templateSpans.map(({ literal }) => `\${}${literal.text}`);
  return node.head.text + rest.join('');
}

function parsed(path) {
  const text = readFileSync(join(root, path), 'utf8');
  return ts.createSourceFile(path, text, ts.ScriptTarget.Latest, true);
}

/** Texts of a script with their places; those of types and of names of modules left out. */
function textsOf(path) {
  const source = parsed(path);
  const texts = [];
  const visit = (node) => {
    if (ts.isImportDeclaration(node) || ts.isExportDeclaration(node) || ts.isTypeNode(node)) return;
    const text = textOf(node);
    if (text !== null) {
      const { line } = source.getLineAndCharacterOfPosition(node.getStart());
      texts.push({ text, place: `${path}:${line + 1}` });
    }
    ts.forEachChild(node, visit);
  };
  visit(source);
  return texts;
}

/** What is to be read in markup: text between tags, and attributes that are spoken or shown. */
function* markupTexts(markup) {
  const parts = markup.matchAll(/<!--[\s\S]*?-->|<(?:[^>"]|"[^"]*")*>|[^<]+/g);
  for (const [part] of parts) {
    if (!part.startsWith('<')) yield part.trim();
    for (const [, text] of part.matchAll(/\b(?:aria-label|title|placeholder|alt)="([^"]*)"/g))
      yield text;
  }
}

/** Names of programs and formats, sizes, and what an address looks like. */
const names = /^(?:Foldwright|Pepakura|PDF|SVG|FOLD|C3|\d+ cm|[^A-Za-z]*|[xyz]|0 %)$/;

const studio = readFileSync(join(root, 'web/app/studio.html'), 'utf8');
const page = readFileSync(join(root, 'web/app/index.html'), 'utf8');

/** The keys of an object that a script exports, those of objects in it after a point. */
function keysOf(path, name) {
  const source = parsed(path);
  const keys = [];
  const collect = (object, prefix) => {
    for (const { name: key, initializer } of object.properties) {
      if (ts.isObjectLiteralExpression(initializer)) collect(initializer, `${prefix}${key.text}.`);
      else keys.push(prefix + key.text);
    }
  };
  ts.forEachChild(source, (node) => {
    if (!ts.isVariableStatement(node)) return;
    for (const { name: found, initializer } of node.declarationList.declarations) {
      if (found.getText() === name) collect(initializer, '');
    }
  });
  return keys;
}

const table = 'web/words/en/page.ts';
const known = new Set(keysOf(table, 'page'));
const asked = new Set([...studio.matchAll(/\{\{([\w.]+)\}\}/g)].map(([, key]) => key));
asked.delete('code');
const sites = new Set(keysOf(table, 'site'));
const onPage = [...page.matchAll(/data-words="(\w+)"/g)].map(([, key]) => key);

const paths = sourceFiles(programs, ['.ts']);
const texts = paths.flatMap(textsOf);
const said = new Set(texts.map(({ text }) => text));
const excused = Object.values(allowed).flat();
const body = page.slice(page.indexOf('<body>'), page.indexOf('<noscript>'));

const faults = [
  ...texts
    .filter(({ text }) => isProse(text) && !isCode(text) && !excused.includes(text))
    .map(({ text, place }) => `${place}: "${text}" belongs into web/words`),
  ...excused
    .filter((text) => !said.has(text))
    .map((text) => `scripts/check-words.mjs: nothing says "${text}" any more`),
  ...[...markupTexts(studio), ...markupTexts(body)]
    .map((text) => text.replace(/\{\{[\w.]+\}\}/g, '').trim())
    .filter((text) => !names.test(text))
    .map((text) => `web/app: "${text}" in the markup belongs into ${table}`),
  ...[...asked]
    .filter((key) => !known.has(key))
    .map((key) => `web/app/studio.html: ${table} lacks "${key}"`),
  ...[...known].filter((key) => !asked.has(key)).map((key) => `${table}: no markup has "${key}"`),
  ...onPage
    .filter((key) => !sites.has(key))
    .map((key) => `web/app/index.html: ${table} lacks "${key}"`),
];
for (const fault of faults) console.error(fault);
console.log(`words: ${paths.length} files, ${known.size} keys of markup, ${faults.length} faults`);
process.exit(faults.length === 0 ? 0 : 1);
