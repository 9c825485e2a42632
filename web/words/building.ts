/**
 * What the cover and the pages with the steps say: one function per sentence, from its parameters to a line of
 * text, so that another language is another table of this type: `en/building.ts` is the English one.
 */
type Numbers = readonly string[];

/** Edges that are joined one after the other: what is printed at them, and how many lack a number. */
export interface EdgeList {
  /** Numbers and ranges of them, in the order of work. */
  runs: Numbers;
  first: string | null;
  last: string | null;
  /** How many edges there are, and how many without a readable number. */
  edges: number;
  unnumbered: number;
}

export interface BuildingWords {
  pageNote: (p: { page: number; pages: number }) => string;
  view: (p: {
    name: 'front-left' | 'back-right' | 'front-right' | 'back-left' | 'above' | 'below';
  }) => string;
  sizeLabel: () => string;
  size: (p: { width: string; height: string; depth: string }) => string;
  amountLabel: () => string;
  amount: (p: { pieces: number; sheets: number; width: string; height: string }) => string;
  foldsLabel: () => string;
  folds: (p: { mountains: number; valleys: number }) => string;
  seamsLabel: () => string;
  seams: (p: { seams: number }) => string;
  gluedLabel: () => string;
  tapedLabel: () => string;
  duration: (p: { seconds: number }) => string;
  mountain: () => string;
  valley: () => string;
  /** `names`: none if there are too many to be listed. */
  valleyPieces: (p: { names: Numbers; pieces: number; all: boolean }) => string;
  howTitle: () => string;
  how: () => string[];
  piecesTitle: () => string;
  sheet: (p: { sheet: number }) => string;
  faces: (p: { faces: number; flaps: number }) => string;
  pieceFolds: (p: { folds: number; valleys: number }) => string;
  hidden: () => string;
  strips: (p: { runs: Numbers; strips: number }) => string;
  stepsTitle: () => string;
  marks: (p: {
    mark: 'close-first' | 'close-last' | 'glue-first' | 'glue-last' | 'valley' | 'border';
  }) => string;
  stepTitle: (p: { step: number; name: string }) => string;
  fold: (p: { folds: number; crease: 'mountain' | 'valley'; turn: number }) => string;
  close: (p: EdgeList) => string;
  glue: (p: EdgeList & { groups: { name: string; runs: Numbers }[] }) => string;
  apart: () => string;
  finish: (p: { last: string | null }) => string;
}
