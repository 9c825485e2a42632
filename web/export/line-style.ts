import type { LineKind, LineStyle, PrintOptions, PrintStyle } from '../model/print-options.js';

/** How everything on a sheet looks. */
export interface Look {
  lines: Readonly<Record<LineKind, LineStyle>>;
  /** Colour that flaps are filled with, or 'none'. */
  flaps: string;
  /** Of all text, and of rulers. */
  text: string;
}

const black = '#000000';

/**
 * The kinds tell apart by their dashes, so that a black and white print is enough.
 *
 * foldwright: folds are thin and grey because they stay visible on the finished model.
 * pepakura: all lines thin and black, as Pepakura Designer draws them.
 * blender: the defaults of Blender's Export Paper Model: a base width of 0.1 mm, of which cuts have
 * three and folds two; dashes of four and nine base widths, shorter than their gaps; grey flaps.
 */
const looks: Readonly<Record<PrintStyle, Look>> = {
  foldwright: {
    lines: {
      cut: { width: 0.25, colour: black, dash: [] },
      mountain: { width: 0.18, colour: '#555555', dash: [1.5, 0.8] },
      valley: { width: 0.18, colour: '#555555', dash: [2.4, 0.6, 0.3, 0.6] },
    },
    flaps: 'none',
    text: '#333333',
  },
  pepakura: {
    lines: {
      cut: { width: 0.15, colour: black, dash: [] },
      mountain: { width: 0.15, colour: black, dash: [1, 1] },
      valley: { width: 0.15, colour: black, dash: [3, 0.8, 0.5, 0.8] },
    },
    flaps: 'none',
    text: black,
  },
  blender: {
    lines: {
      cut: { width: 0.3, colour: black, dash: [] },
      mountain: { width: 0.2, colour: black, dash: [0.4, 0.9] },
      valley: { width: 0.2, colour: black, dash: [0.9, 0.4, 0.1, 0.4] },
    },
    flaps: '#e6e6e6',
    text: black,
  },
};

/** The look of a style with what was asked for besides. */
export function lookOf({ style, lines, flaps }: PrintOptions): Look {
  const base = looks[style];
  const line = (kind: LineKind): LineStyle => ({ ...base.lines[kind], ...lines[kind] });
  return {
    ...base,
    lines: { cut: line('cut'), mountain: line('mountain'), valley: line('valley') },
    flaps: flaps ?? base.flaps,
  };
}

/** Of lines from numbers to their edges, and of marks for tape: thinner than any fold. */
export function leaderStyle({ text }: Look): LineStyle {
  return { width: 0.1, colour: text, dash: [] };
}

/** Of rulers, and of boxes that are no cuts. */
export function guideStyle({ text }: Look): LineStyle {
  return { width: 0.18, colour: text, dash: [] };
}
