/** Which part of a sheet is for pieces. As the engine has it: `ruled_margin` and `room_on` in cpp/paper/sheets.cpp. */
import type { Sheet } from './job.js';

/** An upright box on a sheet; mm from its lower left, y up. */
export interface Area {
  left: number;
  bottom: number;
  right: number;
  top: number;
}

/** What printers leave white, unless the margin says that this one does not; mm. */
export const unprinted = 4;

/** Height of the bands for rulers and title along the left and the lower edge; mm. */
export const bandHeight = 5.5;

/**
 * Where the bands begin, and where pieces do, from the left and the lower edge; mm.
 *
 * @param inset what the bands shall keep from the edge, as far as that leaves the pieces where they are
 */
export function bandOf(margin: number, inset = 0): { from: number; to: number } {
  const usual = Math.min(margin, unprinted);
  const to = Math.max(margin, usual + bandHeight);
  return { from: Math.max(usual, Math.min(inset, to - bandHeight)), to };
}

/**
 * Where pieces may lie on a sheet.
 *
 * @param margin that is asked for, mm
 */
export function roomOn({ width, height }: Sheet, margin: number): Area {
  const { to } = bandOf(margin);
  return { left: to, bottom: to, right: width - margin, top: height - margin };
}
