/** Project files without an engine: what is written, what is read again, and what is left of damaged ones. */
import { unzipSync, zipSync, type Zippable } from 'fflate';
import { describe, expect, it } from 'vitest';
import type { SavedNet } from '../../web/model/job.js';
import { isProject } from '../../web/project/is-project.js';
import type { Project, SavedState } from '../../web/project/project.js';
import { readProject } from '../../web/project/read-project.js';
import { entriesFor, writeProject } from '../../web/project/write-project.js';
import { Unreadable } from '../../web/read/unreadable.js';
import { englishPhrase } from '../../web/words/phrase.js';
import { damaged, numbers } from './damage.js';
import { objText, wavyRing } from './model-text.js';
import { documentsOf, projectErrors } from './project-schema.js';

const seed = 20261129;
const utf8 = new TextEncoder();
const options = { seed: 7, parts: 'auto', paper: 'A4', flaps: 5 };

function net(part: number): SavedNet {
  return {
    part,
    cause: 'part',
    faces: Int32Array.of(2 * part, 2 * part + 1),
    folds: Int32Array.of(3 * part),
    foldable: 'line',
    times: Float64Array.of(0, 1),
    shares: [Float64Array.of(0), Float64Array.of(1 / 3)],
  };
}

function state(hash: string, place?: SavedNet['place']): SavedState {
  const nets = [net(0), { ...net(1), ...(place && { place }) }];
  const seconds = { read: 0, learn: 0.1, cluster: 0, search: 0, compact: 0, paper: 0 };
  return {
    hash,
    options,
    flapEdges: [{ from: 0, to: 1, flaps: 'both', height: 4 }],
    locks: [{ from: 1, to: 2, as: 'cut' }],
    names: [{ part: 1, name: 'Ear' }],
    pins: [{ part: 0, face: 0, sheet: 0, x: 1, y: 2, angle: 3 }],
    start: {
      labels: Int32Array.of(0, 0, 1, 1),
      nets,
      paper: place ? { scale: 0.1, sheets: 1, sheetWidth: 210 } : null,
    },
    told: {
      search: { generations: 3, moves: 4 },
      seconds: { ...seconds, fold: 0, total: 0.1 },
      notices: [{ code: 'no-motion', params: { part: 1 } }],
    },
  };
}

function project(): Project {
  return {
    app: '0.1.0',
    name: 'ring',
    files: [
      { name: 'ring.obj', bytes: utf8.encode(objText(wavyRing(10))) },
      { name: 'tex/wood.mtl', bytes: utf8.encode('newmtl wood\nKd 1 0 0\n'.repeat(20)) },
    ],
    options,
    steps: [[{ kind: 'name', part: 2, text: 'Ear' }], [{ kind: 'cut', edge: [1, 2] }]],
    cursor: 1,
    states: [
      state('0123456789abcdef'),
      state('fedcba9876543210', { sheet: 0, x: 1 / 3, y: -2e-17, angle: 45.00000000000001 }),
      null,
    ],
  };
}

const file = (bytes: Uint8Array): { name: string; bytes: Uint8Array } => {
  return { name: 'a.foldwright', bytes };
};

/** A project whose entries are changed: null takes one out. */
function changed(changes: Record<string, object | string | null>): Uint8Array {
  const entries: Zippable = { ...unzipSync(writeProject(project())) };
  for (const [name, content] of Object.entries(changes)) {
    if (content === null) delete entries[name];
    else
      entries[name] = utf8.encode(typeof content === 'string' ? content : JSON.stringify(content));
  }
  return zipSync(entries);
}

function document(changes: object): Uint8Array {
  const before = documentsOf(writeProject(project()))['project.json'] as object;
  return changed({ 'project.json': { ...before, ...changes } });
}

function sentences(bytes: Uint8Array): string[] {
  return readProject(file(bytes)).faults.map(englishPhrase);
}

const latin = (bytes: Uint8Array): string => new TextDecoder('latin1').decode(bytes);

function refusal(bytes: Uint8Array): string {
  try {
    readProject(file(bytes));
  } catch (error) {
    if (error instanceof Unreadable) return englishPhrase(error);
    throw error;
  }
  throw new Error('It was read');
}

describe('a project file', () => {
  it('is valid, comes back as it was, and is the same bytes each time', () => {
    const bytes = writeProject(project());
    expect(projectErrors(bytes)).toEqual([]);
    const { project: read, faults } = readProject(file(bytes));
    expect(faults).toEqual([]);
    expect(read).toEqual(project());
    expect(writeProject(read)).toEqual(bytes);
    expect(writeProject(project())).toEqual(bytes);
  });

  it('has each net once', () => {
    const results = documentsOf(writeProject(project()))['results.json'] as { nets: object[] };
    expect(results.nets).toHaveLength(2);
  });

  it('is known by its beginning, or by its name', () => {
    const bytes = writeProject(project());
    expect(isProject({ name: 'a.zip', bytes })).toBe(true);
    expect(isProject({ name: 'a.FOLDWRIGHT', bytes: new Uint8Array() })).toBe(true);
    expect(isProject({ name: 'a.zip', bytes: zipSync({ 'a.obj': new Uint8Array(9) }) })).toBe(
      false,
    );
  });

  it('keeps names that lead elsewhere, or that two files have, out of its paths', () => {
    const names = ['../a.obj', 'b.png', 'B.png', 'C:\\x\\c.png', '', 'd/e.png', '/etc/f'];
    expect(entriesFor(names)).toEqual([
      'files/0/a.obj',
      'files/b.png',
      'files/2/B.png',
      'files/3/c.png',
      'files/4/file',
      'files/d/e.png',
      'files/6/f',
    ]);
    const files = names.map((name, i) => ({ name, bytes: Uint8Array.of(i) }));
    const { project: read } = readProject(file(writeProject({ ...project(), files })));
    expect(read.files).toEqual(files);
  });
});

describe('a project file that was changed', () => {
  it('of a version to come is not read', () => {
    expect(refusal(document({ version: 2 }))).toMatch(/saved by a newer Foldwright/);
  });

  it('gives the model alone where its document is lost', () => {
    for (const content of [null, '{"format":', '[]', '{"format":"other"}']) {
      const bytes = changed({ 'project.json': content });
      const { project: read } = readProject(file(bytes));
      expect(read.files.map(({ name }) => name)).toEqual(['ring.obj', 'tex/wood.mtl']);
      expect([read.steps, read.cursor, read.states]).toEqual([[], 0, [null]]);
      expect(sentences(bytes)).toEqual([expect.stringMatching(/only the model could be read/)]);
    }
  });

  it('says which files are lost, and is refused without a model', () => {
    expect(sentences(changed({ 'files/tex/wood.mtl': null }))).toEqual([
      'the project file is damaged: tex/wood.mtl, which is part of the model, could not be read',
    ]);
    expect(refusal(changed({ 'files/ring.obj': null }))).toMatch(/the model in it is lost/);
    expect(refusal(new Uint8Array())).toMatch(/the model in it is lost/);
  });

  it('ends before the first step that is none', () => {
    const [first] = project().steps;
    const bytes = document({ steps: [first, [{ kind: 'cut', edge: [1] }], first], cursor: 3 });
    const { project: read } = readProject(file(bytes));
    expect([read.steps, read.cursor]).toEqual([[first], 1]);
    expect(read.states).toHaveLength(2);
    expect(sentences(bytes)).toEqual([
      'the project file is damaged: the last 2 changes could not be read',
    ]);
  });

  it('has no states that are none, and loses nothing with them', () => {
    const results = documentsOf(writeProject(project()))['results.json'] as {
      states: object[];
      nets: object[];
    };
    const [first, second] = results.states;
    const broken: [object | string | null, number[]][] = [
      [null, []],
      ['x', []],
      [{ ...results, nets: [{}] }, []],
      [{ ...results, labels: [[1.5]] }, []],
      [{ ...results, states: [first, { ...second, hash: 1 }, null] }, [0]],
      [{ ...results, states: [{ ...first, labels: 7 }, second] }, [1]],
      [{ ...results, states: [first, { ...second, nets: [{ net: 99, part: 0 }] }] }, [0]],
    ];
    for (const [content, kept] of broken) {
      const { project: read, faults } = readProject(file(changed({ 'results.json': content })));
      expect(read.states.flatMap((one, i) => (one ? [i] : []))).toEqual(kept);
      expect(faults).toEqual([]);
      expect(read.steps).toEqual(project().steps);
    }
  });

  it('does not unpack to hundreds of times its size', () => {
    const bomb = { ...unzipSync(writeProject(project())) };
    bomb['files/ring.obj'] = new Uint8Array(64 * 2 ** 20);
    expect(refusal(zipSync(bomb, { level: 9 }))).toMatch(/the model in it is lost/);
  });
});

describe('a project file that was damaged on its way', () => {
  it('gives all before the place at which it is cut off', () => {
    const bytes = writeProject(project());
    // Without the list of contents, and without the last of the results.
    const { project: read, faults } = readProject(file(bytes.slice(0, bytes.length - 200)));
    expect(faults).toEqual([]);
    expect([read.files, read.steps]).toEqual([project().files, project().steps]);
  });

  it('gives what is sound, or one sentence, 200 times', () => {
    const bytes = writeProject(project());
    const below = numbers(seed);
    const sound = new Map(project().files.map(({ name, bytes: own }) => [name, own.join()]));
    // The model with its header, up to the next file.
    const text = latin(bytes);
    const model = text.slice(text.indexOf('files/ring.obj') - 30, text.indexOf('files/tex') - 30);
    const counts = { whole: 0, partial: 0, refused: 0 };
    for (let i = 0; i < 200; ++i) {
      const broken = damaged(bytes, below);
      try {
        const { project: read, faults } = readProject(file(broken));
        // Whatever comes out is as it was: checksums see to that.
        for (const { name, bytes: own } of read.files) expect(own.join()).toBe(sound.get(name));
        expect(read.steps).toEqual(project().steps.slice(0, read.steps.length));
        expect(read.states).toHaveLength(read.steps.length + 1);
        faults.forEach((fault) => expect(englishPhrase(fault)).not.toMatch(/^message/));
        ++counts[faults.length === 0 && read.states[0] ? 'whole' : 'partial'];
      } catch (error) {
        if (!(error instanceof Unreadable)) throw error;
        expect(englishPhrase(error)).toMatch(/^'a\.foldwright' is damaged/);
        // Only a model that was hit is lost.
        expect(latin(broken).includes(model), `${i}`).toBe(false);
        ++counts.refused;
      }
    }
    expect(Math.min(...Object.values(counts))).toBeGreaterThan(9);
  });
});
