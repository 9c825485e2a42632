/** Renders a page of a PDF and measures on the picture. */
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { inFolder } from './command.js';

const resolution = 600;

/** A dark stretch of a row or column; mm from the left or the lower edge. */
export interface Stretch {
  from: number;
  to: number;
}

/** A page as dots, dark or not. */
export class Pixels {
  private constructor(
    private readonly width: number,
    private readonly height: number,
    private readonly grey: Uint8Array,
  ) {}

  /** Renders with poppler, which shares nothing with what wrote or read the file so far. */
  static render(pdf: Uint8Array, page: number): Promise<Pixels> {
    return inFolder((folder) => {
      const [file, picture] = [join(folder, 'page.pdf'), join(folder, 'page')];
      writeFileSync(file, pdf);
      const pages = ['-f', String(page), '-l', String(page), '-singlefile'];
      execFileSync('pdftoppm', ['-gray', '-r', String(resolution), ...pages, file, picture]);
      const bytes = readFileSync(`${picture}.pgm`);
      const head = /^P5\s+(\d+)\s+(\d+)\s+255\s/.exec(bytes.toString('latin1', 0, 40))!;
      const [width, height] = [Number(head[1]), Number(head[2])];
      return Promise.resolve(new Pixels(width, height, bytes.subarray(head[0].length)));
    });
  }

  /** Dark stretches of the row at this height. */
  across(y: number): Stretch[] {
    const row = this.height - 1 - this.dot(y);
    return this.stretches(this.width, (x) => this.grey[row * this.width + x]!);
  }

  /** Dark stretches of the column this far from the left. */
  up(x: number): Stretch[] {
    const column = this.dot(x);
    return this.stretches(
      this.height,
      (y) => this.grey[(this.height - 1 - y) * this.width + column]!,
    );
  }

  private dot(length: number): number {
    return Math.floor((length / 25.4) * resolution);
  }

  private stretches(count: number, at: (dot: number) => number): Stretch[] {
    const found: Stretch[] = [];
    const millimetres = (dot: number): number => (dot / resolution) * 25.4;
    for (let dot = 0; dot < count; ++dot) {
      if (at(dot) > 128) continue;
      const last = found.at(-1);
      if (last?.to === millimetres(dot)) last.to = millimetres(dot + 1);
      else found.push({ from: millimetres(dot), to: millimetres(dot + 1) });
    }
    return found;
  }
}
