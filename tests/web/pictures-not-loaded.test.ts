/** In a file of its own: where the renderer was started once it is there. */
import { expect, it } from 'vitest';
import { writeSvg } from '../../web/export/svg.js';
import { preparePrint } from '../../web/export/print.js';
import { defaultPrint } from '../../web/model/print-options.js';
import { picturedCube } from './looked-cube.js';
import { fontReader, readRenderer } from './printed.js';

it('sheets are printed in plain colours when the renderer of pictures does not come', async () => {
  let isOffline = true;
  const result = picturedCube();
  const print = () =>
    preparePrint({
      result,
      title: 'cube',
      margin: 10,
      options: { ...defaultPrint, dpi: 72 },
      loadFont: fontReader(),
      loadRenderer: (module) =>
        isOffline ? Promise.reject(new Error('offline')) : readRenderer(module),
    });
  const plain = await print();
  expect(plain.notices).toEqual([{ code: 'pictures-not-loaded', params: {} }]);
  expect(writeSvg(plain, 0)).toContain('<image');
  // What does not come at first may come later.
  isOffline = false;
  expect((await print()).notices).toEqual([]);
});
