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

/** Of flaps: grey as light as a printer can make it evenly, so that black numbers stay readable on it. */
export const flapShade = '#e6e6e6';

/**
 * Mountains are of a dark orange and valleys blue, which people with any colour vision tell apart. In grey both are
 * as dark as each other, and as #555555.
 */
const mountainColour = '#a84300';
export const valleyColour = '#0072b2';

/**
 * The kinds tell apart by their dashes, so that a black and white print is enough.
 *
 * foldwright: folds are thin because they stay visible on the finished model; flaps are grey, so that
 * one sees what is glued.
 * pepakura: all lines thin and black, as Pepakura Designer draws them.
 * blender: the defaults of Blender's Export Paper Model: a base width of 0.1 mm, of which cuts have
 * three and folds two; dashes of four and nine base widths, shorter than their gaps; grey flaps.
 */
const looks: Readonly<Record<PrintStyle, Look>> = {
  foldwright: {
    lines: {
      cut: { width: 0.25, colour: black, dash: [] },
      mountain: { width: 0.18, colour: mountainColour, dash: [1.5, 0.8] },
      valley: { width: 0.18, colour: valleyColour, dash: [2.4, 0.6, 0.3, 0.6] },
    },
    flaps: flapShade,
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
    flaps: flapShade,
    text: black,
  },
};

// Thin, but still seen on a print. Programs cut along the middle, however wide a line is.
const machineLine = (colour: string): LineStyle => ({ width: 0.1, colour, dash: [] });

/**
 * For machines: one pure colour for each thing that is done, because their programs tell by the colour
 * of a line what to do with it. Red is cut, blue and green are scored, magenta is for a pen.
 */
const machineLook: Look = {
  lines: {
    cut: machineLine('#ff0000'),
    mountain: machineLine('#0000ff'),
    valley: machineLine('#00ff00'),
  },
  flaps: 'none',
  text: '#ff00ff',
};

/** The look of a style, or of lines for a machine, with what was asked for besides. */
export function lookOf({ machine, style, lines, flaps }: PrintOptions): Look {
  const base = machine === 'none' ? looks[style] : machineLook;
  const line = (kind: LineKind): LineStyle => ({ ...base.lines[kind], ...lines[kind] });
  return {
    ...base,
    lines: { cut: line('cut'), mountain: line('mountain'), valley: line('valley') },
    flaps: machine === 'none' ? (flaps ?? base.flaps) : 'none',
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

/** Of texts that a machine draws with a pen. */
export function penStyle({ text }: Look): LineStyle {
  return machineLine(text);
}
