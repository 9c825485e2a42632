/** The manifest of the elements against the built viewer, which can be imported without a DOM. The studio's is in `tests/e2e`. */
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { elementsManifest } from '../../scripts/elements-manifest.mjs';
import { builtText, viewerPackage } from './built-package.js';
import { isBuilt } from './command.js';
import { root } from './packed.js';

const [viewer, studio] = elementsManifest().modules.map(({ declarations: [element] }) => element);

type Named = { name: string };
const names = (list: readonly Named[]): string[] => list.map(({ name }) => name).sort();

describe('the manifest of the elements', () => {
  it('has a sentence for everything', () => {
    const all = [viewer!, studio!].flatMap(({ attributes, events, members }) => [
      ...attributes,
      ...events,
      ...members,
    ]);
    expect(all.length).toBeGreaterThan(40);
    for (const { name, description } of all) expect(description, name).toMatch(/\w{2}/);
  });

  it('tells of the events that listeners are typed for', () => {
    expect(names(viewer!.events)).toEqual([
      'before-download',
      'error',
      'fold-change',
      'foldwright-event',
      'load',
      'selection-change',
      'unfold',
    ]);
    expect(names(studio!.events)).toEqual(['foldwright-event', 'foldwright-ready']);
  });
});

describe.skipIf(!isBuilt)('each element', () => {
  it.each([viewer!, studio!])('$tagName is defined by its script', async ({ tagName }) => {
    // What defines it is imported for its effect alone, which bundlers must be told of.
    const script = await builtText(`package/${tagName}.js`);
    expect(script).toMatch(new RegExp(`\\.define\\(.${tagName}.`));
  });
});

describe.skipIf(!isBuilt)('the built viewer', () => {
  it('comes with its manifest, where the package says', async () => {
    const { customElements, files } = JSON.parse(
      await readFile(join(root, 'package.json'), 'utf8'),
    ) as { customElements: string; files: string[] };
    expect(files).toContain(customElements);
    const built: unknown = JSON.parse(await readFile(join(root, customElements), 'utf8'));
    expect(built).toEqual(JSON.parse(JSON.stringify(elementsManifest())));
  });

  it('has the attributes and members of its manifest, and no others', async () => {
    const { FoldwrightViewer } = await viewerPackage();
    expect([...FoldwrightViewer.observedAttributes].sort()).toEqual(names(viewer!.attributes));
    const own = FoldwrightViewer.prototype;
    for (const { name, kind } of viewer!.members) {
      const has = Object.getOwnPropertyDescriptor(own, name);
      expect(typeof has?.[kind === 'method' ? 'value' : 'get'], name).toBe('function');
    }
  });
});
