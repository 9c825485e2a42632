import { describe, expect, it } from 'vitest';
import { writeFold } from '../../web/export/fold.js';
import { boxAndLidResult, cubeResult, slitResult, tetrahedronResult } from './fixtures.js';
import { checkFold } from './fold-check.js';
import { parseFold } from './fold-file.js';
import { expectGolden } from './golden.js';

const results = {
  cube: cubeResult(),
  'box-and-lid': boxAndLidResult(),
  slit: slitResult(),
  tetrahedron: tetrahedronResult(),
};

describe('writeFold', () => {
  it.each(Object.entries(results))('writes nets of the %s that fold', (_, result) => {
    expect(checkFold(parseFold(writeFold(result)))).toEqual([]);
  });

  it('keeps the format of the files', () => {
    expectGolden('box-and-lid.fold', writeFold(results['box-and-lid']));
    expectGolden('slit.fold', writeFold(results.slit));
  });

  it('keeps every bit of the coordinates', () => {
    const file = parseFold(writeFold(results.tetrahedron));
    expect(Float64Array.from(file.model.vertices_coords.flat())).toEqual(
      results.tetrahedron.model.vertices,
    );
    expect(Float64Array.from(file.nets[0]!.vertices_coords.flat())).toEqual(
      results.tetrahedron.pieces[0]!.vertices,
    );
  });

  it('writes mountains as negative angles and cuts as null', () => {
    const [net] = parseFold(writeFold(results.tetrahedron)).nets;
    const angles = net!.edges_assignment.map((letter, i) => [letter, net!.edges_foldAngle[i]]);
    expect(angles.filter(([letter]) => letter === 'B').every(([, angle]) => angle === null)).toBe(
      true,
    );
    const mountains = angles.filter(([letter]) => letter === 'M').map(([, angle]) => Number(angle));
    expect(mountains).toHaveLength(3);
    // The dihedral angle of the regular tetrahedron is acos(1/3).
    for (const angle of mountains) expect(angle).toBeCloseTo(-180 + 70.528779365509308, 9);
  });

  it('lists every edge of the model once', () => {
    const { edges_vertices } = parseFold(writeFold(results.cube)).model;
    expect(new Set(edges_vertices.map((edge) => edge.join())).size).toBe(18);
    expect(edges_vertices).toHaveLength(18);
  });

  it('is the same text every time', () => {
    expect(writeFold(cubeResult())).toBe(writeFold(cubeResult()));
  });
});
