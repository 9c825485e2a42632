/** A chosen model before it is unfolded: what is proposed, what is shown, what is said. */
import { describe, expect, it, vi } from 'vitest';
import type { Inspection } from '../../web/api/inspect.js';
import { Check } from '../../web/app/check.js';
import { bodyWords, lookWords, repairWords, triangleWords } from '../../web/app/check-words.js';
import type { Aspect } from '../../web/app/quick-looks.js';
import { JobError } from '../../web/core/job-error.js';
import type { Component } from '../../web/model/components.js';
import { mostFaces } from '../../web/model/face-numbers.js';
import type { Message } from '../../web/model/message.js';
import type { ModelFiles } from '../../web/model/model-files.js';
import { english } from '../../web/words/en/index.js';

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

/** A number of triangles of a model that is not mended. */
function aspect(faces: Aspect['faces']): Aspect {
  return { faces, up: 'guess', repair: 'on', fillHoles: 'off', inside: 'keep', crossing: 'keep' };
}

/** Answers when the test lets it, unless it is aborted. */
class SlowLooker {
  readonly asked: string[] = [];
  goOn: (look: Inspection | Error) => void = () => undefined;

  inspect(
    { faces, up, fillHoles = 'off', inside = 'keep' }: Partial<Aspect> = {},
    { signal }: { signal?: AbortSignal } = {},
  ): Promise<Inspection> {
    const mended = [fillHoles, inside].filter((word) => word !== 'off' && word !== 'keep');
    this.asked.push([faces, up, ...mended].join(' '));
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

describe('what can be mended of a model', () => {
  const found = (...repairs: Message[]): Inspection => ({ ...lookAt(9), repairs });
  const holes = (count: number, small: number): Message => ({
    code: 'open-holes',
    params: { count, percent: 40, small, small_percent: 10 },
  });

  it('is told by the model as it is', async () => {
    const inner: Message = { code: 'inner-bodies', params: { count: 2 } };
    const { check } = await checked(found(holes(3, 1), inner));
    expect(check.holes).toEqual({ count: 3, small: 1, smallPercent: 10 });
    expect([check.innerBodies, check.hasToDecide]).toEqual([2, true]);
    const sound = (await checked(lookAt(9))).check;
    expect([sound.holes, sound.innerBodies]).toEqual([null, 0]);
  });

  it('holds it for small holes and inner bodies, and not for large openings', async () => {
    expect((await checked(found(holes(3, 1)))).check.hasToDecide).toBe(true);
    expect((await checked(found(holes(3, 0)))).check.hasToDecide).toBe(false);
    const inner: Message = { code: 'inner-bodies', params: { count: 1 } };
    expect((await checked(found(inner))).check.hasToDecide).toBe(true);
  });

  it('is seen, and each way is kept', async () => {
    const { check, looker } = await checked(found(holes(3, 1)));
    const filled = check.show({ ...aspect('off'), fillHoles: 'all' });
    looker.goOn(lookAt(12));
    await filled;
    expect([check.look?.model.faces.length, check.holes?.count]).toEqual([36, 3]);
    await check.show(aspect('off'));
    await check.show({ ...aspect('off'), fillHoles: 'all' });
    expect(looker.asked).toEqual(['off guess', 'off guess all']);
  });

  it('appears once holes are filled', async () => {
    const { check, looker } = await checked(found(holes(1, 1)));
    const repairs = [{ code: 'dropped-inner-bodies', params: { count: 2, faces: 24 } }];
    const filled = check.show({ ...aspect('off'), fillHoles: 'all', inside: 'drop' });
    looker.goOn({ ...lookAt(12), repairs });
    await filled;
    expect(check.innerBodies).toBe(2);
    expect(check.repairs).toEqual(repairs);
  });

  it('is mended in the copy of a large model, too', async () => {
    const { check, looker, copy } = await checked(lookAt(70_000));
    void check.show({ ...aspect(500), inside: 'drop' });
    await settle();
    looker.goOn(lookAt(6000));
    await settle();
    expect(looker.asked).toEqual(['off guess', '6000 guess drop']);
    expect(copy.asked).toEqual(['500 y']);
    void check.show(aspect(500));
    await settle();
    expect(looker.asked.at(-1)).toBe('6000 guess');
  });
});

describe('looks at a number of triangles', () => {
  it('take over from the one before, and are kept', async () => {
    const { check, looker, changed } = await checked(lookAt(5000));
    const first = check.show(aspect(1500));
    expect(check.working).toBe(true);
    const second = check.show(aspect(500));
    await first;
    looker.goOn(lookAt(500));
    await second;
    expect([check.working, check.look?.model.faces.length]).toEqual([false, 1500]);
    await check.show(aspect('off'));
    expect(check.look?.model.faces.length).toBe(15_000);
    await check.show(aspect('off'));
    expect(looker.asked).toEqual(['off guess', '1500 guess', '500 guess']);
    expect(changed).toHaveBeenCalledTimes(4);
    expect(check.outline?.model.faces.length).toBe(1500);
  });

  it('that fail or are stopped leave the one before, and can be asked for again', async () => {
    const { check, looker } = await checked(lookAt(5000));
    const failing = check.show(aspect(4));
    looker.goOn(new JobError('no-area', { what: 'faces' }));
    await failing;
    const stopped = check.show(aspect(200));
    check.stop();
    await stopped;
    expect([check.working, check.look?.model.faces.length]).toEqual([false, 15_000]);
    void check.show(aspect(200));
    expect(looker.asked.slice(-2)).toEqual(['200 guess', '200 guess']);
  });

  it('are made from one coarser copy of a large model', async () => {
    const { check, looker, copy, opened } = await checked(lookAt(70_000));
    const first = check.show(aspect(1500));
    await settle();
    looker.goOn(lookAt(6000));
    await settle();
    const second = check.show(aspect(200));
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
    void check.show(aspect(4000));
    await settle();
    expect(looker.asked.at(-1)).toBe('4000 guess');
  });
});

describe('words', () => {
  it('say what is proposed and why', () => {
    expect(triangleWords(english, 70_000, 1500)).toBe(
      'This model has 70,000 triangles. Paper models have 200 to 1500, so 1500 are set for it: the picture shows what is left of its shape.',
    );
    expect(triangleWords(english, 800, null)).toContain('fine for paper');
    expect(triangleWords(english, 8000, null)).toBe('This model has 8000 triangles.');
    expect(english.check.tooMany(345_678, mostFaces)).toContain(
      'All 345,678 are too many: nets of more than 100,000',
    );
    expect(lookWords(english, 1500, false, '')).toBe('The picture has 1500 triangles.');
    expect(lookWords(english, 1500, true, '200 triangles')).toBe(
      'Making a model of 200 triangles …',
    );
    expect(english.speech.large(1500)).toBe('1500');
  });

  it('tell bodies', () => {
    expect(bodyWords(english, 1, 0)).toBe('');
    expect(bodyWords(english, 3, 0)).toMatch(/3 separate bodies, each with nets of its own\.$/);
    expect(bodyWords(english, 3, 1)).toContain('1 of them is tiny');
    expect(bodyWords(english, 9, 2)).toContain('2 of them are tiny');
  });

  it('tell what can be mended', () => {
    const { holes, inside } = english.check;
    expect(holes({ count: 3, small: 1, smallPercent: 10 })).toBe(
      'The model has 3 holes. 1 of them is small: at most 10 % of its length across. What closes a hole gets the colours beside it.',
    );
    expect(holes({ count: 1, small: 1, smallPercent: 10 })).toBe(
      'The model has 1 hole. What closes a hole gets the colours beside it.',
    );
    expect(inside(1)).toMatch(/^A body lies inside another one/);
    expect(inside(2)).toMatch(/^2 bodies lie inside others/);
  });

  it('part what was repaired from what was not', () => {
    const repairs: Message[] = [
      { code: 'welded-vertices', params: { count: 2 } },
      { code: 'open-border', params: { count: 4, gap: 0.01, bodies: 1 } },
      { code: 'inner-bodies', params: { count: 4 } }, // told beside its switch
    ];
    const { repaired, remaining } = repairWords(english, repairs);
    expect(repaired.map(({ step }) => step)).toEqual(['weld']);
    expect(repaired[0]?.words).toMatch(/^2 vertices .*\.$/);
    expect(remaining).toEqual([expect.stringMatching(/^4 edges lie on the border/)]);
  });

  it('give lengths as people do', () => {
    expect([0.52, 8, 75, 175, 1234].map(english.check.length)).toEqual([
      '0.52 mm',
      '8 mm',
      '7.5 cm',
      '17.5 cm',
      '1.2 m',
    ]);
  });
});
