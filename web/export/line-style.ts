/** How a kind of line looks on paper; lengths in mm. */
export interface LineStyle {
  width: number;
  /** Six hexadecimal digits after '#'. */
  colour: string;
  /** Lengths of dashes and gaps in turn; empty: solid. */
  dash: readonly number[];
}

export type LineKind = 'cut' | 'mountain' | 'valley' | 'guide';

/**
 * The kinds tell apart by their dashes, so that a black and white print is enough; folds are thin
 * and grey because they stay visible on the finished model.
 */
export const lineStyles: Readonly<Record<LineKind, LineStyle>> = {
  cut: { width: 0.25, colour: '#000000', dash: [] },
  mountain: { width: 0.18, colour: '#555555', dash: [1.5, 0.8] },
  guide: { width: 0.1, colour: '#555555', dash: [] },
  valley: { width: 0.18, colour: '#555555', dash: [2.4, 0.6, 0.3, 0.6] },
};

/** Colour of text on paper. */
export const textColour = '#333333';
