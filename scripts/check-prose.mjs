// The engine gives codes and parameters; their sentences stand in web/words. Fails for a string of several words in
// cpp/ or bindings/, and for a message code that nothing gives.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { sourceFiles } from './files.mjs';
import { root } from './setup/paths.mjs';

/** Strings of several words that nobody reads on a screen, by the reason why they are there. */
const allowed = {
  'types of TypeScript': ['{ id: number; surface: number; bytes: Uint8Array } | undefined'],
  'beginnings of files of other programs': [
    'Kaydara FBX Binary',
    '; FBX',
    '3D Geometry File Format',
    'AutoCAD Binary DXF',
    'version https://git-lfs',
    '<!doctype html',
  ],
  'errors of the program itself, which reach nobody but through the code "internal" or "bad-option"':
    [
      'unknown word: ',
      'unknown edit: ',
      'a value without a name',
      'not in kMessageCodes',
      'vertex is not a corner of the face',
      'edge is not manifold and oriented',
      'a piece fits no sheet in any turn',
      'a structure without a list of fields',
      'graph is not connected',
      'folds do not span the graph',
    ],
};

/** C++ without comments; what stood there leaves its line breaks. */
function withoutComments(text) {
  const pattern = /"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*'|\/\/[^\n]*|\/\*[\s\S]*?\*\//g;
  return text.replace(pattern, (found) =>
    found.startsWith('/') ? found.replace(/[^\n]/g, ' ') : found,
  );
}

/** Strings of a file with their places; those of an #include left out. */
function stringsOf(path) {
  return withoutComments(readFileSync(join(root, path), 'utf8'))
    .split('\n')
    .flatMap((line, index) => {
      if (/^\s*#/.test(line)) return [];
      const found = line.matchAll(/"((?:[^"\\]|\\.)*)"/g);
      return [...found].map(([, string]) => ({ string, place: `${path}:${index + 1}` }));
    });
}

/** Two words with blanks between them, or one before a colon that something follows. */
function isProse(string) {
  return /[A-Za-z]{2,}[,;:.]? +[A-Za-z]/.test(string) || /[A-Za-z]{2,}: $/.test(string);
}

const codesFile = 'cpp/mesh/message_codes.h';
const paths = sourceFiles(['cpp', 'bindings'], ['.h', '.cpp']).filter((path) => path !== codesFile);
const strings = paths.flatMap(stringsOf);
const said = new Set(strings.map(({ string }) => string));
const excused = Object.values(allowed).flat();

const faults = [
  ...strings
    .filter(({ string }) => isProse(string) && !excused.includes(string))
    .map(({ string, place }) => `${place}: "${string}" belongs into web/words`),
  ...excused
    .filter((string) => !said.has(string))
    .map((string) => `scripts/check-prose.mjs: nothing says "${string}" any more`),
  ...stringsOf(codesFile)
    .filter(({ string }) => !said.has(string))
    .map(({ string, place }) => `${place}: nothing gives "${string}"`),
];
for (const fault of faults) console.error(fault);
console.log(`prose: ${paths.length} files, ${faults.length} faults`);
process.exit(faults.length === 0 ? 0 : 1);
