/** A model is looked at before it is unfolded, and shown where there is something to decide. */
import { expect, test } from 'vitest';
import { cube } from '../web/fixtures.js';
import { objText, wavyRing } from '../web/model-text.js';
import { resultIn, withElementPage } from './element-page.js';
import { useStudio } from './studio-fixture.js';
import { phone, type StudioPage } from './studio-page.js';

const withStudio = useStudio();

/** Of 5000 triangles. */
const large = objText(wavyRing(50));

/** Waits until the picture has so many triangles. */
async function picturesHave({ page }: StudioPage, least: number, most: number): Promise<void> {
  const isThere = async (): Promise<boolean> => {
    const words = await page.locator('#check-look').innerText();
    const triangles = Number(/^The picture has ([\d,]+)/.exec(words)?.[1]?.replace(',', ''));
    return triangles >= least && triangles <= most;
  };
  await expect.poll(isThere, { timeout: 20_000 }).toBe(true);
}

async function holds(studio: StudioPage, name: string): Promise<void> {
  await studio.page.locator('#check').waitFor();
  await studio.page.locator('#model-name', { hasText: name }).waitFor();
}

function trianglesOf({ page }: StudioPage): Promise<string> {
  return page.locator('#facts div').filter({ hasText: 'Triangles' }).locator('dd').innerText();
}

test('a large model is held with fewer triangles set, which can be changed before it is unfolded', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const faces = page.locator('#faces');
    const pressed = page.locator('#check-levels [aria-pressed="true"]');
    await studio.choose('ring.obj', large);
    await holds(studio, 'ring.obj');
    expect(await page.locator('#check-why').innerText()).toContain(
      'This model has 5000 triangles.',
    );
    expect(await faces.inputValue()).toBe('1500');
    expect(await faces.getAttribute('data-proposed')).toBe('');
    expect(await pressed.allInnerTexts()).toEqual(['1500']);
    await picturesHave(studio, 1400, 1500);
    await studio.drawn('#model-picture');
    expect(await page.locator('#progress').isVisible()).toBe(false);

    await page.getByRole('button', { name: '200', exact: true }).click();
    await picturesHave(studio, 150, 200);
    await page.locator('#check-faces').press('ArrowRight');
    expect(await faces.inputValue()).toBe('250');
    await picturesHave(studio, 201, 250);
    await page.getByRole('button', { name: 'as it is: 5000' }).click();
    expect(await faces.inputValue()).toBe('');
    await picturesHave(studio, 5000, 5000);

    expect(await page.locator('#check-drawing').isVisible()).toBe(false);
    await page.getByRole('button', { name: '15 cm', exact: true }).click();
    expect(await page.locator('#check-drawing').isVisible()).toBe(true);
    expect(await page.locator('#check-size-words').innerText()).toMatch(/^15 cm high/);
    expect(await page.locator('#size').inputValue()).toBe('150');

    await page.getByRole('button', { name: '500', exact: true }).click();
    await studio.picture('check');
    await page.locator('#check').getByRole('button', { name: 'Unfold' }).click();
    await studio.resultOf('ring');
    expect(Number(await trianglesOf(studio))).toBeLessThanOrEqual(500);
    expect(await page.locator('#check').isVisible()).toBe(false);
    expect(studio.complaints).toEqual([]);
  }));

test('what was set for a model leaves with it, and a small model is unfolded at once', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await studio.choose('ring.obj', large);
    await holds(studio, 'ring.obj');
    await studio.chooseSample('Cube');
    await studio.resultOf('cube');
    expect(await page.locator('#faces').inputValue()).toBe('');
    expect(await page.locator('#check, #check-again').filter({ visible: true }).count()).toBe(0);

    // A number that a person writes stays, and is an answer already.
    await page.fill('#faces', '300');
    await studio.choose('ring.obj', large);
    await studio.resultOf('ring');
    expect(Number(await trianglesOf(studio))).toBeLessThanOrEqual(300);
    expect(await page.locator('#faces').inputValue()).toBe('300');
    expect(studio.complaints).toEqual([]);
  }));

test('a held model can be left for the nets before, and a file that is none changes nothing', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await studio.chooseSample('Cube');
    await studio.resultOf('cube');
    await studio.choose('ring.obj', large);
    await holds(studio, 'ring.obj');
    expect(await page.locator('#result').isVisible()).toBe(false);
    await page.getByRole('button', { name: 'Back to the nets' }).click();
    await page.locator('#result #model-name', { hasText: 'cube.obj' }).waitFor();
    expect((await studio.download('FOLD')).name).toBe('cube.fold');

    await studio.choose('broken.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n');
    expect(await studio.message()).toContain('“broken.obj” could not be unfolded');
    expect(await page.locator('#chosen').innerText()).toBe('Chosen: ring.obj');
    expect(await page.locator('#faces').inputValue()).toBe('1500');
    await page.getByRole('button', { name: 'Check the model again' }).click();
    await holds(studio, 'ring.obj');
    expect(studio.complaints).toEqual([]);
  }));

test('tiny bodies are told before they are unfolded', () =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      const bodies = [1, 0.01, 0.9].map((size, i) => ({
        vertices: cube.vertices.map(([x, y, z]) => [size * x! + 100 * i, size * y!, size * z!]),
        faces: cube.faces.map((face) => face.map((vertex) => vertex + i * cube.vertices.length)),
      }));
      const [vertices, faces] = [bodies.flatMap((b) => b.vertices), bodies.flatMap((b) => b.faces)];
      await studio.choose('bodies.obj', objText({ vertices, faces }));
      await holds(studio, 'bodies.obj');
      expect(await page.locator('#check-bodies').innerText()).toMatch(
        /3 separate.* 1 of them is tiny/,
      );
      expect(await page.locator('#faces').inputValue()).toBe('');
      await page.locator('#unfold').click();
      await studio.resultOf('bodies');
      expect(studio.complaints).toEqual([]);
    },
    { viewport: phone },
  ));

/** A box of 40 with a hole of 2 in its top and a smaller box within; beside it one whose top is missing. */
function boxesWithHoles(): string {
  const [sides, bottom] = [cube.faces.slice(4), cube.faces.slice(0, 2)];
  const hole = [
    [19, 19, 40],
    [21, 19, 40],
    [21, 21, 40],
    [19, 21, 40],
  ];
  const around = [0, 1, 2, 3].map((i) => [4 + i, 4 + ((i + 1) % 4), 8 + ((i + 1) % 4), 8 + i]);
  const bodies = [
    { vertices: [...cube.vertices, ...hole], faces: [...bottom, ...sides, ...around] },
    { vertices: cube.vertices.map((point) => point.map((x) => 10 + x / 2)), faces: cube.faces },
    {
      vertices: cube.vertices.map(([x, ...rest]) => [x! + 80, ...rest]),
      faces: [...bottom, ...sides],
    },
  ];
  const offsets = [0, 12, 20];
  return objText({
    vertices: bodies.flatMap(({ vertices }) => vertices),
    faces: bodies.flatMap(({ faces }, i) => faces.map((face) => face.map((v) => v + offsets[i]!))),
  });
}

test('holes are closed and inner bodies left out where a person wants it, and seen before', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const [holes, inside] = [page.locator('#check-holes'), page.locator('#check-inside')];
    const pressed = '[aria-pressed="true"]';
    await studio.choose('boxes.obj', boxesWithHoles());
    await holds(studio, 'boxes.obj');
    expect(await page.locator('#check-holes-words').innerText()).toContain(
      'The model has 2 holes. 1 of them is small',
    );
    expect(await inside.isVisible()).toBe(false);
    await picturesHave(studio, 40, 40);
    await studio.drawn('#model-picture');

    // Once its hole is closed, the box has an inside.
    await holes.getByRole('button', { name: 'close the small ones' }).click();
    await picturesHave(studio, 42, 42);
    expect(await page.locator('#fill-holes').inputValue()).toBe('10');
    await inside.waitFor();
    await studio.picture('check-inside');
    await inside.getByRole('button', { name: 'leave out' }).click();
    await picturesHave(studio, 30, 30);
    await holes.getByRole('button', { name: 'close all' }).click();
    await picturesHave(studio, 32, 32);
    expect(await page.locator('#check-repaired').innerText()).toContain('2 holes were filled');
    expect(await holes.locator(pressed).innerText()).toBe('close all');
    expect(await inside.locator(pressed).innerText()).toBe('leave out');
    await studio.picture('check-mended');

    await page.locator('#check').getByRole('button', { name: 'Unfold' }).click();
    await studio.resultOf('boxes');
    expect(await trianglesOf(studio)).toBe('32');

    // What was set for a model leaves with it.
    await studio.chooseSample('Cube');
    await studio.resultOf('cube');
    expect(await page.locator('#fill-holes').inputValue()).toBe('off');
    expect(await page.locator('#inside').inputValue()).toBe('keep');
    expect(studio.complaints).toEqual([]);
  }));

/** Two cubes through each other: one with a triangle the other way round, and one whose triangles share no corners. */
function faultyBoxes(): string {
  const turned = cube.faces.map((face, i) => (i === 0 ? [...face].reverse() : face));
  const loose = cube.faces.flatMap((face) => face.map((v) => cube.vertices[v]!));
  const moved = loose.map((at) => at.map((x) => x / 2 + 27));
  return objText({
    vertices: [...cube.vertices, ...moved],
    faces: [...turned, ...cube.faces.map((_, i) => [0, 1, 2].map((k) => 8 + 3 * i + k))],
  });
}

test('steps of the repair are listed with what they did, and switched off and on', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    await studio.choose('boxes.obj', faultyBoxes());
    await holds(studio, 'boxes.obj');
    const list = page.locator('#check-repaired');
    const [weld, winding] = [
      list.getByRole('checkbox', { name: 'Join points at the same place' }),
      list.getByRole('checkbox', { name: 'Turn faces right side out' }),
    ];
    expect(await list.innerText()).toContain('28 vertices were merged with others');
    expect(await list.innerText()).toContain('1 face was turned over');
    expect([await weld.isChecked(), await winding.isChecked()]).toEqual([true, true]);
    const remaining = page.locator('#check-remaining');
    expect(await remaining.isVisible()).toBe(false);
    await list.scrollIntoViewIfNeeded();
    await studio.picture('check-repairs');

    await winding.uncheck();
    await list.getByText('Turning faces over was switched off: 1 face has').waitFor();
    expect(await remaining.innerText()).toContain('6 edges lie on the border of 2 open surfaces');
    expect(await page.locator('#repair-winding').isChecked()).toBe(false);
    await studio.picture('check-repair-off');
    await winding.check();
    await list.getByText('1 face was turned over').waitFor();
    // Whoever goes from switch to switch by keys stays there.
    await weld.focus();
    await page.keyboard.press('Space');
    await list.getByText('Welding was switched off: 28 vertices lie').waitFor();
    expect(await weld.evaluate((box) => box.matches(':focus'))).toBe(true);

    await page.locator('#check').getByRole('button', { name: 'Unfold' }).click();
    await studio.resultOf('boxes');
    expect(await trianglesOf(studio)).toBe('24');
    // What was set for a model leaves with it.
    await studio.chooseSample('Cube');
    await studio.resultOf('cube');
    expect(await page.locator('#repair-weld').isChecked()).toBe(true);
    expect(studio.complaints).toEqual([]);
  }));

test('bodies that run through each other are made one where a person wants it', () =>
  withStudio(async (studio) => {
    const { page } = studio;
    const vertices = [...cube.vertices, ...cube.vertices.map((at) => at.map((x) => x / 2 + 27))];
    const faces = [...cube.faces, ...cube.faces.map((face) => face.map((v) => v + 8))];
    await studio.choose('boxes.obj', objText({ vertices, faces }));
    await holds(studio, 'boxes.obj');
    const crossing = page.locator('#check-crossing');
    expect(await crossing.innerText()).toContain('their pieces would collide when glued');
    await crossing.getByRole('button', { name: 'make one' }).click();
    await page.getByText('2 bodies that ran through each other were united').waitFor();
    expect(await page.locator('#check-bodies').isVisible()).toBe(false);
    await studio.picture('check-crossing');
    await page.locator('#check').getByRole('button', { name: 'Unfold' }).click();
    await studio.resultOf('boxes');
    expect(await trianglesOf(studio)).toBe('40');
    expect(studio.complaints).toEqual([]);
  }));

test('who unfolds a model while it is looked at gets it as it is asked for', () =>
  withStudio(
    async (studio) => {
      const { page } = studio;
      await studio.choose('ring.obj', objText(wavyRing(33)));
      await page.getByText('Opening: ring.obj').waitFor();
      await page.locator('#unfold').click();
      await studio.resultOf('ring');
      expect(await trianglesOf(studio)).toBe('2178');
    },
    // Slow to start, so that there is time.
    { workerScript: 'for (const end = performance.now() + 2000; performance.now() < end; ) {}\n' },
  ));

test('an element with a large model unfolds what is proposed, or what it says', () =>
  withElementPage(
    {
      markup: `<foldwright-studio id="one" src="ring.obj"></foldwright-studio>
        <foldwright-studio id="two" src="ring.obj" faces="200"></foldwright-studio>`,
      files: { 'shop/ring.obj': large },
    },
    async ({ page, complaints }) => {
      for (const [id, most] of [
        ['#one', 1500],
        ['#two', 200],
      ] as const) {
        const studio = page.locator(id);
        await resultIn(studio, 'ring');
        const fact = studio.locator('#facts div').filter({ hasText: 'Triangles' }).locator('dd');
        expect(Number(await fact.innerText())).toBeLessThanOrEqual(most);
      }
      expect(complaints).toEqual([]);
    },
  ));
