/** Writes archives and 3MF packages for tests of their readers. */
import { zipSync } from 'fflate';
import type { ModelFile } from '../../web/model/model-files.js';
import type { Triangles } from './read-model.js';

export type Contents = Record<string, string | Uint8Array>;

export function zip(name: string, contents: Contents): ModelFile {
  const encode = new TextEncoder();
  const entries = Object.entries(contents).map(([path, content]) => {
    return [path, typeof content === 'string' ? encode.encode(content) : content] as const;
  });
  return { name, bytes: zipSync(Object.fromEntries(entries)) };
}

const relationships = (target: string): string =>
  '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">' +
  `<Relationship Target="${target}" Id="r" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>` +
  '</Relationships>';

/** A package whose first part is at `start`. */
export function threeMf(
  model: string,
  more: Contents = {},
  start = '/3D/3dmodel.model',
): ModelFile {
  const contents = { '_rels/.rels': relationships(start), [start.slice(1)]: model, ...more };
  return zip('model.3mf', contents);
}

const names =
  'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" ' +
  'xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06"';

/** A part of a package. */
export function modelPart(resources: string, items = '', attributes = ''): string {
  return `<model ${names} ${attributes}><resources>${resources}</resources><build>${items}</build></model>`;
}

/** An object with a mesh. */
export function meshObject(id: number, { positions, corners }: Triangles, type = 'model'): string {
  const rows = (values: number[], row: (three: number[]) => string): string =>
    Array.from({ length: values.length / 3 }, (_, i) => row(values.slice(3 * i, 3 * i + 3))).join(
      '',
    );
  const vertices = rows(positions, ([x, y, z]) => `<vertex x="${x}" y="${y}" z="${z}"/>`);
  const triangles = rows(corners, ([a, b, c]) => `<triangle v1="${a}" v2="${b}" v3="${c}"/>`);
  return (
    `<object id="${id}" type="${type}"><mesh><vertices>${vertices}</vertices>` +
    `<triangles>${triangles}</triangles></mesh></object>`
  );
}
