/** How a PDO model looks. */
import { zlibSync } from 'fflate';
import type { LookedFiles, Material } from '../../model/looks.js';
import { isTooLarge } from '../../model/picture-header.js';
import { pngAround, remainder } from '../../model/png-file.js';
import { white } from '../colours.js';
import { inflated } from '../inflate.js';
import { Pictures } from '../pictures.js';
import type { PdoMaterial, PdoPicture } from './pdo-materials.js';

/** The pixels are packed once more within the reader's time: the fastest way is good enough. */
const level = 1;

/** Of all pictures that are unpacked: some seconds of work. */
const mostPixels = 2 ** 27;

/** A PNG file of a picture. @throws Error for one that is damaged */
function pngOf({ width, height, packed }: PdoPicture): Uint8Array {
  const stride = 3 * width;
  const rgb = inflated(packed, stride * height, 'zlib');
  // Before each row stands the number of its filter, 0 for none.
  const rows = new Uint8Array((stride + 1) * height);
  for (let row = 0; row < height; ++row) {
    rows.set(rgb.subarray(stride * row, stride * (row + 1)), (stride + 1) * row + 1);
  }
  return pngAround({ width, height, channels: 3 }, zlibSync(rows, { level }));
}

/** Materials with their pictures, each picture once. */
export class PdoLooks {
  private readonly pictures = new Pictures();
  private pixels = 0;
  private readonly materials: Material[];

  constructor(materials: readonly PdoMaterial[]) {
    this.materials = materials.map((material, i) => this.materialOf(material, i));
  }

  get files(): LookedFiles {
    return { materials: this.materials, pictures: this.pictures.files };
  }

  get notices(): Pictures['notices'] {
    return this.pictures.notices;
  }

  private materialOf({ name, colour, picture }: PdoMaterial, index: number): Material {
    const number = picture && this.numberOf(picture, name || `picture ${index + 1}`);
    return {
      name,
      colour: number === null ? colour : white,
      picture: number,
      wrap: ['repeat', 'repeat'],
      scale: [1, 1],
      offset: [0, 0],
    };
  }

  private numberOf(picture: PdoPicture, name: string): number | null {
    const { width, height, packed } = picture;
    const key = `${width} ${height} ${packed.length} ${remainder(packed)}`;
    return this.pictures.add(key, name, () => {
      this.pixels += width * height;
      if (isTooLarge(picture) || this.pixels > mostPixels) return 'large';
      try {
        return { name, bytes: pngOf(picture) };
      } catch {
        return { name, bytes: new Uint8Array() };
      }
    });
  }
}
