/**
 * Whatever a person does at the bench, in whatever order: nothing breaks, and all of it can be taken back.
 * `GESTURES=1000 SEED=7` makes more of it.
 */
import { expect, test } from 'vitest';
import { checkFold } from '../web/fold-check.js';
import { parseFold } from '../web/fold-file.js';
import { objText, wavyRing } from '../web/model-text.js';
import { Gestures } from './gestures.js';
import { useStudio } from './studio-fixture.js';

const withStudio = useStudio();

const count = Number(process.env['GESTURES'] ?? 25);
const seed = Number(process.env['SEED'] ?? 1);

test(
  `${count} random gestures leave nothing broken, and are taken back to the same bytes`,
  () =>
    withStudio(async (studio) => {
      const { page } = studio;
      await page.fill('#parts', '4');
      await studio.choose('ring.obj', objText(wavyRing(8)));
      await studio.resultOf('ring');
      const first = (await studio.download('FOLD')).bytes;
      const gestures = new Gestures(studio, seed);
      const deeds: string[] = [];
      try {
        for (let i = 1; i <= count; ++i) {
          deeds.push(await gestures.next());
          expect(studio.complaints).toEqual([]);
          if (i % 10 !== 0) continue;
          const { bytes } = await studio.download('FOLD');
          expect(checkFold(parseFold(bytes.toString()))).toEqual([]);
        }
        await gestures.undoAll();
        expect((await studio.download('FOLD')).bytes.equals(first)).toBe(true);
        expect(studio.complaints).toEqual([]);
        if (count > 100) console.log(deeds.join('\n'));
      } catch (error) {
        await studio.picture('gestures-failed');
        console.log(deeds.slice(-12).join('\n'));
        throw error;
      }
    }),
  60_000 + 5000 * count,
);
