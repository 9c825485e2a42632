// No file may name a folder of the machine it was written on, or the address of a package registry: both differ from
// machine to machine.
import { readFileSync } from 'node:fs';
import { homedir } from 'node:os';
import { dirname, join } from 'node:path';
import { root } from './setup/paths.mjs';
import { capture } from './setup/shell.mjs';

const places = [root, dirname(root), homedir()].filter((place) => !['/', '/tmp'].includes(place));
const escaped = places.map((place) => place.replace(/[.*+?^${}()|[\]\\]/g, '\\$&'));
// Not after a word or a closing brace: `${root}/web` and `the-root/x` are relative names.
const machine = new RegExp(`(?<![\\w.}\\])-])(?:${escaped.join('|')})/`);
const people = /(?<![\w.}])\/(?:home|Users)\/\w+\//;
const registry = /https?:\/\/[^\s"'`]*(?:npmjs|yarnpkg|debian)\./;

const listing = capture('git', ['ls-files', '-co', '--exclude-standard', '-z'], { cwd: root });
if (listing === null) {
  console.log('addresses: not a git repository, nothing to check');
  process.exit(0);
}

const faults = [];
for (const path of listing.split('\0').filter(Boolean)) {
  let text;
  try {
    text = readFileSync(join(root, path), 'utf8');
  } catch {
    continue; // deleted, but not yet in the index
  }
  if (text.includes('\0')) continue; // not text
  text.split('\n').forEach((line, index) => {
    if ([machine, people, registry].some((pattern) => pattern.test(line))) {
      faults.push(`${path}:${index + 1}: ${line.trim().slice(0, 100)}`);
    }
  });
}
for (const fault of faults) console.error(fault);
console.log(`addresses: ${faults.length} faults`);
process.exit(faults.length === 0 ? 0 : 1);
