import { describe, expect, it } from 'vitest';
import {
  noTurn,
  poseAfter,
  poseBack,
  posed,
  poseOnto,
  turnAbout,
  turnAfter,
  turnAround,
  turnBetween,
  turned,
  type Pose,
} from '../../web/model/pose.js';
import { direction, length, minus, type Vector } from '../../web/model/vector.js';

const quarter = Math.PI / 2;
const point: Vector = [3, -1, 2];

function expectNear(actual: readonly number[], expected: readonly number[]): void {
  expect(actual).toHaveLength(expected.length);
  actual.forEach((value, i) => expect(value).toBeCloseTo(expected[i]!, 12));
}

describe('turns', () => {
  it('go counter-clockwise around their axis', () => {
    expectNear(turned(turnAround([0, 0, 1], quarter), [1, 0, 0]), [0, 1, 0]);
    expectNear(turned(turnAround([1, 0, 0], quarter), [0, 1, 5]), [0, -5, 1]);
  });

  it('come one after another', () => {
    const first = turnAround([0, 0, 1], quarter);
    const then = turnAround([1, 0, 0], quarter);
    expectNear(turned(turnAfter(then, first), point), turned(then, turned(first, point)));
  });

  it('keep their length over many steps', () => {
    const step = turnAround(direction([1, 2, 3]), 0.1);
    let turn = noTurn;
    for (let i = 0; i < 10_000; ++i) turn = turnAfter(step, turn);
    expect(Math.hypot(...turn)).toBeCloseTo(1, 14);
  });

  it('go the shorter way from one to another, at constant speed', () => {
    const from = turnAround([0, 1, 0], 0.2);
    const to = turnAround([0, 1, 0], 1.4);
    const between = turnAround([0, 1, 0], 0.5);
    expectNear(turnBetween(from, to, 0.25), between);
    // The same turn written the other way round.
    const [x, y, z, w] = to;
    expectNear(turnBetween(from, [-x, -y, -z, -w], 0.25), between);
    expectNear(turnBetween(from, from, 0.5), from);
  });
});

describe('poses', () => {
  const a: Pose = { turn: turnAround(direction([1, 1, 0]), 0.7), move: [1, 2, 3] };
  const b: Pose = { turn: turnAround(direction([0, 2, 1]), -1.9), move: [-4, 0, 1] };

  it('come one after another and go back', () => {
    expectNear(posed(poseAfter(a, b), point), posed(a, posed(b, point)));
    expectNear(posed(poseBack(a), posed(a, point)), point);
  });

  it('leave the point alone that they turn about', () => {
    expectNear(posed(turnAbout(point, b.turn), point), point);
  });
});

describe('poseOnto', () => {
  const triangle: Vector[] = [
    [0, 0, 0],
    [4, 0, 0],
    [1, 2, 0],
  ];

  it.each([0, 0.4, quarter, 2 * quarter, -2.5])('finds a turn by %d around any axis', (angle) => {
    for (const axis of [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
      [1, 2, -3],
    ] as Vector[]) {
      const pose = { turn: turnAround(direction(axis), angle), move: point };
      const moved = triangle.map((corner) => posed(pose, corner));
      const found = poseOnto(triangle, moved);
      triangle.forEach((corner, i) => expectNear(posed(found, corner), moved[i]!));
      expectNear(posed(found, [5, 6, 7]), posed(pose, [5, 6, 7]));
    }
  });

  it('is not misled by a thin triangle', () => {
    const thin: Vector[] = [
      [0, 0, 0],
      [1e-6, 1e-7, 0],
      [100, 0, 0],
    ];
    const pose: Pose = { turn: turnAround(direction([1, 2, 3]), 1), move: [0, 0, 0] };
    const found = poseOnto(
      thin,
      thin.map((corner) => posed(pose, corner)),
    );
    const far: Vector = [50, 50, 50];
    expect(length(minus(posed(found, far), posed(pose, far)))).toBeLessThan(1e-5);
  });
});
