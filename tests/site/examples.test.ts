/** No example is forgotten: each is in a language that some test runs. */
import { expect, test } from 'vitest';
import { examples, sketches } from './examples.js';

/** By the test that runs them; what has no language is no code, such as what a command prints. */
const languages = {
  'shell.test.ts': ['sh', 'yaml'],
  'scripts.test.ts': ['ts', 'tsx', 'js'],
  'markup.test.ts': ['html'],
  'none, since it is no code': [''],
};

test('all examples are in languages that a test runs', () => {
  const known = Object.values(languages).flat();
  const others = examples.filter(({ language }) => !known.includes(language));
  expect(others).toEqual([]);
  expect(examples.length).toBeGreaterThan(25);
});

test('few examples are sketches, which no test can run', () => {
  expect(sketches.map(({ source, language }) => `${source}: ${language}`)).toEqual([
    'docs/elements.md: html',
    'docs/elements.md: js',
    'docs/elements.md: html',
  ]);
});
