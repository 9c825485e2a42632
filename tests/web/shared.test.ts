import { expect, it } from 'vitest';
import { Shared } from '../../web/browser/shared.js';

/** Numbers in the order in which they were made and ended. */
function counted(): { shared: Shared<number>; make: () => number; ended: number[] } {
  const ended: number[] = [];
  let made = 0;
  return { shared: new Shared((thing) => ended.push(thing)), make: () => ++made, ended };
}

it('is made for the first borrower and ended with the last', () => {
  const { shared, make, ended } = counted();
  const [one, two] = [{}, {}];
  expect([shared.lend(one, make), shared.lend(two, make), shared.lend(one, make)]).toEqual([
    1, 1, 1,
  ]);
  shared.giveBack(one);
  shared.giveBack(one);
  expect(ended).toEqual([]);
  shared.giveBack(two);
  expect(ended).toEqual([1]);
  expect(shared.lend(one, make)).toBe(2);
});

it('is another one after it has failed, which earlier borrowers do not end', () => {
  const { shared, make, ended } = counted();
  const [one, two] = [{}, {}];
  const failed = shared.lend(one, make);
  shared.discard(failed);
  shared.discard(failed);
  expect(ended).toEqual([1]);
  expect(shared.lend(two, make)).toBe(2);
  shared.giveBack(one);
  shared.discard(failed);
  expect(ended).toEqual([1]);
  shared.giveBack(two);
  expect(ended).toEqual([1, 2]);
});
