import { describe, expect, it } from 'vitest';
import { writeFold } from '../../web/export/fold.js';
import type { JobResult } from '../../web/model/job.js';
import { beakResult, boxAndLidResult, cubeResult, makeResult, slitResult } from './fixtures.js';
import { checkFold, checkNets } from './fold-check.js';
import {
  parseFold,
  type FoldFile,
  type FoldMotion,
  type KeyFrame,
  type NetFrame,
} from './fold-file.js';
import { checkKeyFrame } from './key-frame-check.js';
import { layPiece } from './lay-piece.js';

/** Eight triangles around a point with more than 360 degrees: as a fan they overlap. */
const saddle = {
  vertices: [
    [0, 0, 0],
    ...Array.from({ length: 8 }, (_, i) => [
      30 * Math.cos((i * Math.PI) / 4),
      30 * Math.sin((i * Math.PI) / 4),
      i % 2 === 0 ? 15 : -15,
    ]),
  ],
  faces: Array.from({ length: 8 }, (_, i) => [0, i + 1, ((i + 1) % 8) + 1]),
};

/** The violations of a net after one change to it. */
function broken(change: (file: FoldFile) => void, result: JobResult = cubeResult()): string {
  const file = parseFold(writeFold(result));
  expect(checkFold(file)).toEqual([]);
  change(file);
  return checkNets(file).join('\n');
}

const net = (file: FoldFile) => file.nets[0]!;
const foldedEdge = (file: FoldFile) => net(file).edges_assignment.indexOf('M');

/** Makes the two cuts of a slit one fold. */
function glueSlit(frame: NetFrame, assignment: string, angle: number): void {
  const at = frame.vertices_coords.map((point) => point.map((x) => x.toFixed(6)).join());
  const first = at.map((key) => at.indexOf(key));
  const glued = (rows: number[][]) => rows.map((row) => row.map((vertex) => first[vertex]!));
  frame.edges_vertices = glued(frame.edges_vertices);
  frame.faces_vertices = glued(frame.faces_vertices);
  const keys = frame.edges_vertices.map((edge) => [...edge].sort((a, b) => a - b).join());
  const copy = keys.findIndex((key, i) => keys.indexOf(key) < i);
  frame.edges_assignment[keys.indexOf(keys[copy]!)] = assignment;
  frame.edges_foldAngle[keys.indexOf(keys[copy]!)] = angle;
  frame.edges_vertices.splice(copy, 1);
  frame.edges_assignment.splice(copy, 1);
  frame.edges_foldAngle.splice(copy, 1);
  // It is of the edges before.
  delete frame['foldwright:motion'];
}

describe('checkFold catches', () => {
  it('a mirrored net', () => {
    const mirror = (file: FoldFile) => {
      for (const point of net(file).vertices_coords) point[0] = -point[0]!;
    };
    expect(broken(mirror)).toMatch(/shows the inside/);
  });

  it('a mirrored net whose faces are turned around as well', () => {
    const mirror = (file: FoldFile) => {
      for (const point of net(file).vertices_coords) point[0] = -point[0]!;
      for (const face of net(file).faces_vertices) face.reverse();
    };
    expect(broken(mirror)).not.toBe('');
  });

  it('overlapping faces', () => {
    const fan = Array.from({ length: 7 }, (_, i): [number, number] => [i, i + 1]);
    const result = makeResult(saddle, [layPiece(saddle, 0, fan)]);
    expect(checkNets(parseFold(writeFold(result))).join('\n')).toMatch(/faces 0 and 5 overlap/);
  });

  it('a wrong sign', () => {
    const flip = (file: FoldFile) => {
      const edge = foldedEdge(file);
      net(file).edges_foldAngle[edge] = 90;
      net(file).edges_assignment[edge] = 'V';
    };
    expect(broken(flip)).toMatch(/folds by 90 instead of -90/);
  });

  it('an assignment that its angle denies', () => {
    const rename = (file: FoldFile) => {
      net(file).edges_assignment[foldedEdge(file)] = 'V';
    };
    expect(broken(rename)).toMatch(/is assigned V/);
  });

  it('a fold that is called flat', () => {
    const rename = (file: FoldFile) => {
      net(file).edges_assignment[foldedEdge(file)] = 'F';
    };
    expect(broken(rename)).toMatch(/is assigned F/);
  });

  it('a missing face', () => {
    const drop = (file: FoldFile) => {
      file.nets.splice(1, 1);
    };
    expect(broken(drop, boxAndLidResult())).toMatch(/face 2 of the model is in the nets 0 times/);
  });

  it('a doubled face', () => {
    const double = (file: FoldFile) => {
      file.nets.push({ ...file.nets[1]!, 'foldwright:piece': 2 });
    };
    expect(broken(double, boxAndLidResult())).toMatch(/face 2 of the model is in the nets 2 times/);
  });

  it('two faces with each other’s source', () => {
    const swap = (file: FoldFile) => {
      const sources = net(file)['faces_foldwright:source'];
      [sources[0], sources[5]] = [sources[5]!, sources[0]!];
    };
    expect(broken(swap)).toMatch(/share no such edge/);
  });

  it('a stretched face', () => {
    const stretch = (file: FoldFile) => {
      net(file).vertices_coords[0]![0]! += 1e-3;
    };
    expect(broken(stretch)).toMatch(/differs from its original/);
  });

  it('a net in two pieces', () => {
    const cut = (file: FoldFile) => {
      const edge = foldedEdge(file);
      net(file).edges_assignment[edge] = 'B';
      net(file).edges_foldAngle[edge] = null;
    };
    expect(broken(cut)).toMatch(/falls into 2 pieces/);
  });

  it('an edge that is missing', () => {
    const drop = (file: FoldFile) => {
      net(file).edges_vertices.pop();
      net(file).edges_assignment.pop();
      net(file).edges_foldAngle.pop();
    };
    expect(broken(drop)).toMatch(/of a face is no edge/);
  });

  it('folds that close a loop', () => {
    // Around a point with 360 degrees, opposite folds are equally sharp.
    const glue = (file: FoldFile) => {
      const opposite = net(file).edges_assignment.indexOf('M');
      glueSlit(net(file), 'V', -net(file).edges_foldAngle[opposite]!);
    };
    expect(broken(glue, beakResult())).toBe(
      'piece 0: its folds close 1 loops: it cannot be flat and folded',
    );
  });

  it('no fault in a straight fold of several edges', () => {
    const file = parseFold(writeFold(slitResult()));
    glueSlit(net(file), 'V', 90);
    expect(checkNets(file)).toEqual([]);
  });

  it.each([
    ['no face that stays', (motion) => (motion.root = 99), /no face 99/],
    ['keys out of order', (motion) => motion.t.reverse(), /its times are 1, 0/],
    ['a key too many', (motion) => motion.angles.push([]), /2 times, but 3 keys/],
    ['an angle too few', (motion) => motion.angles[1]!.pop(), /key 1 has 24 angles for 25 edges/],
    ['a start that is not flat', (motion) => (motion.angles[0]![0] = 1), /begins at 1 degrees/],
    ['an end that is not folded', (motion) => (motion.angles[1]![1] = -80), /ends at -80 instead/],
    ['an angle at a cut', (motion) => (motion.angles[0]![24] = 0), /cut edge 24 has an angle/],
    ['an unproved motion', (motion) => (motion.certified = false), /not certified/],
  ] satisfies [string, (motion: FoldMotion) => unknown, RegExp][])(
    'a motion with %s',
    (_, change, sentence) => {
      expect(broken((file) => change(net(file)['foldwright:motion']!))).toMatch(sentence);
    },
  );

  it('a motion that goes beyond its folds', () => {
    const overshoot = (file: FoldFile) => {
      const { t, angles } = net(file)['foldwright:motion']!;
      t.splice(1, 0, 0.5);
      angles.splice(
        1,
        0,
        angles[1]!.map((angle) => angle && 2 * angle),
      );
    };
    expect(broken(overshoot)).toMatch(/folded further/);
  });

  it('a wrong unit', () => {
    const rename = (file: FoldFile) => {
      net(file).frame_unit = 'cm';
    };
    expect(broken(rename)).toMatch(/not mm/);
  });
});

describe('checkKeyFrame catches', () => {
  const keyFaults = (change: (key: KeyFrame) => void): string => {
    const file = parseFold(writeFold(boxAndLidResult()));
    expect(checkKeyFrame(file)).toEqual([]);
    change(file.key);
    return checkKeyFrame(file).join('\n');
  };
  const lidFaces = (key: KeyFrame) => new Set(key.faces_vertices.slice(-2).flat());

  it('pieces that lie on each other', () => {
    const shift = (key: KeyFrame) => {
      for (const vertex of lidFaces(key)) key.vertices_coords[vertex]![0]! -= 220;
    };
    expect(keyFaults(shift)).toMatch(/^key frame: faces \d+ and \d+ overlap/);
  });

  it('a piece that is not as its own frame has it', () => {
    const stretch = (key: KeyFrame) => {
      key.vertices_coords[0]![1]! += 1e-6;
    };
    expect(keyFaults(stretch)).toMatch(/piece 0: vertex \d+ is elsewhere/);
  });

  it('a fold of another angle', () => {
    const bend = (key: KeyFrame) => {
      key.edges_foldAngle[key.edges_assignment.indexOf('M')] = -45;
    };
    expect(keyFaults(bend)).toBe('key frame: piece 0: edge 1 is another one');
  });

  it('a piece that is missing', () => {
    const drop = (key: KeyFrame) => {
      key.faces_vertices.splice(-2);
      key['faces_foldwright:source'].splice(-2);
    };
    expect(keyFaults(drop)).toMatch(/has 10 faces, the pieces have 12/);
  });

  it('an edge that is listed twice', () => {
    const double = (key: KeyFrame) => {
      key.edges_vertices.push(key.edges_vertices[0]!);
      key.edges_assignment.push(key.edges_assignment[0]!);
      key.edges_foldAngle.push(key.edges_foldAngle[0]!);
    };
    expect(keyFaults(double)).toMatch(/edge \d+ is listed twice/);
  });
});
