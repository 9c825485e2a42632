/** A chosen model before it is unfolded: what is proposed, what is shown, what is said. */
import { describe, expect, it, vi } from 'vitest';
import type { Inspection } from '../../web/api/inspect.js';
import { Check } from '../../web/app/check.js';
import {
  bodyWords,
  boundWords,
  large,
  lengthWords,
  lookWords,
  repairWords,
  triangleWords,
} from '../../web/app/check-words.js';
import type { Aspect } from '../../web/app/quick-looks.js';
import { JobError } from '../../web/core/job-error.js';
import type { Component } from '../../web/model/components.js';
import type { Message } from '../../web/model/message.js';
import type { ModelFiles } from '../../web/model/model-files.js';

const model = { name: 'bust.obj', files: [{ name: 'bust.obj', bytes: new Uint8Array() }] };

/** A look at a model of so many triangles, all of them the same one. */
function lookAt(
  count: number,
  components: Component[] = [{ faces: count, longestSide: 1 }],
): Inspection {
  const faces = Int32Array.from({ length: 3 * count }, (_, i) => i % 3);
  const vertices = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0);
  const componentOfFaces = Int32Array.from(
    { length: count },
    (_, face) => face % components.length,
  );
  return {
    file: 'in/bust.obj',
    model: { vertices, faces },
    repairs: [],
    components,
    componentOfFaces,
    fileNets: 0,
  };
}

/** Answers when the test lets it, unless it is aborted. */
class SlowLooker {
  readonly asked: string[] = [];
  goOn: (look: Inspection | Error) => void = () => undefined;

  inspect(
    { faces, up }: Partial<Aspect> = {},
    { signal }: { signal?: AbortSignal } = {},
  ): Promise<Inspection> {
    this.asked.push(`${faces} ${up}`);
    return new Promise((resolve, reject) => {
      this.goOn = (look) => (look instanceof Error ? reject(look) : resolve(look));
      signal?.addEventListener('abort', () => reject(signal.reason as Error));
    });
  }
}

/** Lets everything happen that waits for nothing. */
const settle = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 0));

/** A model of so many triangles that was read. */
async function checked(look: Inspection, asked: Aspect['faces'] = 'off') {
  const [looker, copy] = [new SlowLooker(), new SlowLooker()];
  const opened: ModelFiles[] = [];
  const changed = vi.fn();
  const check = new Check(
    model,
    looker,
    (files) => {
      opened.push(files);
      return Promise.resolve(copy);
    },
    changed,
  );
  const reading = check.begin({ faces: asked, up: 'guess' }, new AbortController().signal);
  looker.goOn(look);
  await reading;
  return { check, looker, copy, opened, changed };
}

describe('a model that was read', () => {
  it('that is small and sound has nothing to decide', async () => {
    const { check, looker } = await checked(lookAt(2000));
    expect([check.hasToDecide, check.proposal, check.faces]).toEqual([false, null, 2000]);
    expect([check.name, check.working]).toEqual(['in/bust.obj', false]);
    expect(looker.asked).toEqual(['off guess']);
  });

  it('that is large gets fewer triangles proposed, unless a number was asked for', async () => {
    const { check } = await checked(lookAt(2001));
    expect([check.hasToDecide, check.proposal, check.isSearchable]).toEqual([true, 1500, true]);
    expect((await checked(lookAt(5000), 800)).check.hasToDecide).toBe(false);
    expect((await checked(lookAt(100_001))).check.isSearchable).toBe(false);
  });

  it('that the engine refuses whole is looked at as it is proposed', async () => {
    const looker = new SlowLooker();
    const check = new Check(model, looker, () => Promise.reject(new Error('not opened')), vi.fn());
    const reading = check.begin({ faces: 'off', up: 'z' }, new AbortController().signal);
    looker.goOn(new JobError('too-many-faces', { faces: 345_678, most: 100_000, proposed: 1500 }));
    await settle();
    looker.goOn(lookAt(1500));
    await reading;
    expect(looker.asked).toEqual(['off z', '1500 z']);
    expect([check.faces, check.isSearchable, check.look?.model.faces.length]).toEqual([
      345_678,
      false,
      4500,
    ]);
  });

  it('that cannot be read rejects', async () => {
    const looker = new SlowLooker();
    const check = new Check(model, looker, () => Promise.resolve(looker), vi.fn());
    const reading = check.begin({ faces: 'off', up: 'guess' }, new AbortController().signal);
    looker.goOn(new JobError('no-faces', { what: 'nothing' }));
    await expect(reading).rejects.toMatchObject({ code: 'no-faces' });
  });

  it('has its tiny bodies counted and marked, and is held for them', async () => {
    const components = [
      { faces: 2, longestSide: 1 },
      { faces: 2, longestSide: 0.029 },
      { faces: 2, longestSide: 0.031 },
    ];
    const { check } = await checked(lookAt(6, components));
    expect([check.bodies, check.tinyBodies, check.hasToDecide]).toEqual([3, 1, true]);
    expect([...check.tinyFaces]).toEqual([-1, 0, -1, -1, 0, -1]);
  });

  it('is held where bodies run through each other, and not for what was repaired', async () => {
    const message = (code: string) => ({ ...lookAt(9), repairs: [{ code, params: { count: 1 } }] });
    expect((await checked(message('crossing-bodies'))).check.hasToDecide).toBe(true);
    expect((await checked(message('flipped-faces'))).check.hasToDecide).toBe(false);
  });
});

describe('looks at a number of triangles', () => {
  it('take over from the one before, and are kept', async () => {
    const { check, looker, changed } = await checked(lookAt(5000));
    const first = check.show({ faces: 1500, up: 'guess' });
    expect(check.working).toBe(true);
    const second = check.show({ faces: 500, up: 'guess' });
    await first;
    looker.goOn(lookAt(500));
    await second;
    expect([check.working, check.look?.model.faces.length]).toEqual([false, 1500]);
    await check.show({ faces: 'off', up: 'guess' });
    expect(check.look?.model.faces.length).toBe(15_000);
    await check.show({ faces: 'off', up: 'guess' });
    expect(looker.asked).toEqual(['off guess', '1500 guess', '500 guess']);
    expect(changed).toHaveBeenCalledTimes(4);
    expect(check.outline?.model.faces.length).toBe(1500);
  });

  it('that fail or are stopped leave the one before, and can be asked for again', async () => {
    const { check, looker } = await checked(lookAt(5000));
    const failing = check.show({ faces: 4, up: 'guess' });
    looker.goOn(new JobError('no-area', { what: 'faces' }));
    await failing;
    const stopped = check.show({ faces: 200, up: 'guess' });
    check.stop();
    await stopped;
    expect([check.working, check.look?.model.faces.length]).toEqual([false, 15_000]);
    void check.show({ faces: 200, up: 'guess' });
    expect(looker.asked.slice(-2)).toEqual(['200 guess', '200 guess']);
  });

  it('are made from one coarser copy of a large model', async () => {
    const { check, looker, copy, opened } = await checked(lookAt(70_000));
    const first = check.show({ faces: 1500, up: 'guess' });
    await settle();
    looker.goOn(lookAt(6000));
    await settle();
    const second = check.show({ faces: 200, up: 'guess' });
    await settle();
    copy.goOn(lookAt(200));
    await Promise.all([first, second]);
    expect(looker.asked).toEqual(['off guess', '6000 guess']);
    expect(copy.asked).toEqual(['1500 y', '200 y']);
    expect(opened).toHaveLength(1);
    const { bytes } = opened[0]![0]!;
    const header = new TextDecoder().decode(bytes.subarray(0, 200));
    // Floats, as the copy is one of floats.
    expect(header).toMatch(/^ply\nformat binary_[^]*element vertex 3\n[^]*element face 6000\n/);
    // More triangles than a copy is good for come from the model.
    void check.show({ faces: 4000, up: 'guess' });
    await settle();
    expect(looker.asked.at(-1)).toBe('4000 guess');
  });
});

describe('words', () => {
  it('say what is proposed and why', () => {
    expect(triangleWords(70_000, 1500)).toBe(
      'This model has 70,000 triangles. Paper models have 200 to 1500, so 1500 are set for it: the picture shows what is left of its shape.',
    );
    expect(triangleWords(800, null)).toContain('fine for paper');
    expect(triangleWords(8000, null)).toBe('This model has 8000 triangles.');
    expect(boundWords(345_678)).toContain('All 345,678 are too many: nets of more than 100,000');
    expect(lookWords(1500, false, '')).toBe('The picture has 1500 triangles.');
    expect(lookWords(1500, true, '200 triangles')).toBe('Making a model of 200 triangles …');
    expect(large(1500)).toBe('1500');
  });

  it('tell bodies', () => {
    expect(bodyWords(1, 0)).toBe('');
    expect(bodyWords(3, 0)).toMatch(/3 separate bodies, each with nets of its own\.$/);
    expect(bodyWords(3, 1)).toContain('1 of them is tiny');
    expect(bodyWords(9, 2)).toContain('2 of them are tiny');
  });

  it('part what was repaired from what was not', () => {
    const repairs: Message[] = [
      { code: 'welded-vertices', params: { count: 2 } },
      { code: 'open-border', params: { count: 4, gap: 0.01 } },
    ];
    const { repaired, remaining } = repairWords(repairs);
    expect(repaired).toEqual([expect.stringMatching(/^2 vertices .*\.$/)]);
    expect(remaining).toEqual([expect.stringMatching(/^4 edges lie on the border/)]);
  });

  it('give lengths as people do', () => {
    expect([0.52, 8, 75, 175, 1234].map(lengthWords)).toEqual([
      '0.52 mm',
      '8 mm',
      '7.5 cm',
      '17.5 cm',
      '1.2 m',
    ]);
  });
});
