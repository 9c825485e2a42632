import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { wantedLength } from '../../web/model/seam-measures.js';
import { bandHeight, unprinted } from '../../web/model/sheet-room.js';
import { capHeight } from '../../web/export/text-line.js';

/** The number that a constant has in the engine's source. */
function engineConstant(file: string, name: string): number {
  const path = new URL(`../../cpp/${file}`, import.meta.url);
  const value = new RegExp(`constexpr double ${name} = ([\\d.]+);`).exec(
    readFileSync(path, 'utf8'),
  );
  expect(value, `${name} in ${file}`).not.toBeNull();
  return Number(value![1]);
}

describe('what engine and exporters both must know', () => {
  it.each([
    ['paper/flaps.h', 'kWantedLength', wantedLength],
    ['paper/sheets.cpp', 'kUnprinted', unprinted],
    ['paper/sheets.cpp', 'kRuledBand', bandHeight],
    ['paper/text_box.h', 'kCapHeight', capHeight],
  ])('is the same in %s: %s', (file, name, value) => {
    expect(value).toBe(engineConstant(file, name));
  });
});
