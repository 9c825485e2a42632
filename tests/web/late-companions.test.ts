/** Files that are chosen after the model that they belong to. */
import { describe, expect, it } from 'vitest';
import { Choice } from '../../web/app/choice.js';

const namesIn = ({ model }: Choice): string[] => model!.files.map(({ name }) => name);

function take(choice: Choice, ...names: string[]): void {
  const files = names.map((name) => ({ name, bytes: new Uint8Array() }));
  choice.take({ name: names[0]!, files });
}

function chosen(name: string): Choice {
  const choice = new Choice();
  take(choice, name);
  choice.accept(name);
  return choice;
}

describe('files that are chosen after their model', () => {
  it('join it, and take the place of others of their name', () => {
    const choice = chosen('ring.obj');
    take(choice, 'wood.png', 'ring.mtl');
    expect(namesIn(choice)).toEqual(['ring.obj', 'wood.png', 'ring.mtl']);
    expect(choice.model).toMatchObject({ name: 'ring.obj', added: ['wood.png', 'ring.mtl'] });
    choice.accept('ring.obj');
    take(choice, 'wood.png');
    expect(choice.model!.added).toEqual(['ring.mtl', 'wood.png']);
    take(choice, 'other.obj');
    expect(namesIn(choice)).toEqual(['other.obj']);
    expect(choice.model!.added).toBeUndefined();
  });

  it('leave it as it was where it cannot be read with them', () => {
    const choice = chosen('ring.obj');
    take(choice, 'ring.mtl');
    choice.drop('out-of-memory');
    expect(namesIn(choice)).toEqual(['ring.obj']);
  });

  it('join one that could not be read without them', () => {
    const choice = chosen('ring.obj');
    take(choice, 'lamp.gltf');
    choice.drop('missing-files');
    expect(namesIn(choice)).toEqual(['ring.obj']);
    take(choice, 'lamp.bin');
    choice.drop('missing-files');
    take(choice, 'shade.bin');
    expect(namesIn(choice)).toEqual(['lamp.gltf', 'lamp.bin', 'shade.bin']);
  });

  it('are a choice of their own where there is no model, or one is among them', () => {
    const choice = new Choice();
    take(choice, 'wood.png');
    expect(namesIn(choice)).toEqual(['wood.png']);
    choice.accept('wood.png');
    // What can be a model is one.
    take(choice, 'notes.txt', 'wood.png');
    expect(namesIn(choice)).toEqual(['notes.txt', 'wood.png']);
  });
});
