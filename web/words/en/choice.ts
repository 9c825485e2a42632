/** What is said in English of a model that is chosen and looked at before it is unfolded. */
import type { FileExcess } from '../../model/model-files.js';
import { count, figure, large, rounded, some } from './numbers.js';
import { excess } from './readers.js';

export const choice = {
  opening: (files: readonly string[]): string => `Opening: ${some(files)}`,
  chosen: (files: readonly string[]): string => `Chosen: ${some(files)}`,
  fileTooLarge: (file: string, fault: FileExcess): string =>
    `“${file}” is too large: it has ${excess(fault)}. Save it with fewer faces, or in a binary format.`,
  tooMuch: (fault: FileExcess): string =>
    `That is too much: it has ${excess(fault)}. Choose a model and what belongs to it.`,
  notLoaded: (file: string): string => `“${file}” cannot be loaded.`,
  notLetIn: (file: string): string =>
    `“${file}” cannot be loaded: it lies on another site, and browsers only fetch it from here if both sites allow that. Save the file on your device and drop it here.`,
  unreadable: (file: string): string =>
    `“${file}” cannot be read: it is a folder, or it was moved, or may not be opened.`,
  unreadableDrop: (file: string): string =>
    `“${file}” cannot be read: it was moved, or may not be opened.`,
  noFile:
    'That was no file. Choose a GLB, OBJ, STL, 3MF, PLY, OFF, PDO or FOLD file, or a ZIP with one.',
  empty: (file: string): string => `“${file}” is empty: there is nothing in it to unfold.`,
  noSamples: 'The samples cannot be loaded. Models of your own work all the same.',
  /** In the list of files that a browser offers. */
  sample: (name: string, faces: number): string => `${name}, ${count(faces, 'face')}`,
  effort: (level: 'easy' | 'medium' | 'hard', pieces: number): string =>
    `${{ easy: 'Easy', medium: 'Medium', hard: 'Hard' }[level]}: ${count(pieces, 'piece')}`,
  pending: (names: string): string => `Not applied yet: ${names}.`,
};

/** A length as people say it: 8 mm, 12 cm, 1.2 m. */
function length(mm: number): string {
  if (mm < 10) return `${rounded(mm)} mm`;
  if (mm < 1000) return `${rounded(mm / 10, mm < 100 ? 2 : 3)} cm`;
  return `${rounded(mm / 1000)} m`;
}

export const check = {
  length,
  triangles: (faces: number): string => `This model has ${large(faces)} triangles.`,
  fine: 'That is fine for paper.',
  proposed: (proposal: number): string =>
    `Paper models have 200 to 1500, so ${large(proposal)} are set for it: the picture shows what is left of its shape.`,
  making: (wanted: string): string => `Making a model of ${wanted} …`,
  shown: (faces: number): string => `The picture has ${large(faces)} triangles.`,
  asItIs: (faces: number): string => `as it is: ${large(faces)}`,
  all: (faces: number): string => `all ${large(faces)} triangles`,
  some: (faces: number): string => `${large(faces)} triangles`,
  tooMany: (faces: number, most: number): string =>
    `All ${large(faces)} are too many: nets of more than ${large(most)} triangles would take hours ` +
    'and be too small to fold.',
  bodies: (bodies: number): string =>
    `The model is made of ${large(bodies)} separate bodies, each with nets of its own.`,
  tiny: (bodies: number): string =>
    `${large(bodies)} of them ${bodies === 1 ? 'is' : 'are'} tiny: less than 3 % of its length. ` +
    `The picture shows ${bodies === 1 ? 'it' : 'them'} in colour.`,
  holes: (p: { count: number; small: number; smallPercent: number }): string => {
    const few = `${large(p.small)} of them ${p.small === 1 ? 'is' : 'are'} small: at most ${figure(p.smallPercent)} % of its length across.`;
    const isMixed = p.small > 0 && p.small < p.count;
    return `The model has ${count(p.count, 'hole')}. ${isMixed ? `${few} ` : ''}What closes a hole gets the colours beside it.`;
  },
  inside: (bodies: number): string =>
    bodies === 1
      ? 'A body lies inside another one, where nobody will see it. Without it there is less to cut and glue.'
      : `${large(bodies)} bodies lie inside others, where nobody will see them. Without them there is less to cut and glue.`,
  netsKept:
    'The model is cut and folded just as in its file, at the same size if the paper has room for it.',
  netsOffered: (pieces: number): string =>
    pieces === 1
      ? 'The file brings its own net. Keep it to cut and fold as its maker did, or have new nets made.'
      : `The file brings its own nets, ${large(pieces)} pieces. Keep them to cut and fold as its maker did, or have new nets made.`,
  size: (p: { height: number; width: number; depth: number; pencil: number }): string =>
    `${length(p.height)} high, ${length(p.width)} wide, ${length(p.depth)} deep, beside a pencil of ${length(p.pencil)}.`,
  fits: {
    new: 'As large as a sheet allows: how large that is shows when it is unfolded.',
    file: 'As large as in the file, or as a sheet allows: how large that is shows when it is unfolded.',
    other: 'How large it gets shows when it is unfolded.',
  },
  chooseHeight: 'Choose a height to see it beside a pencil.',
};

/** Labels and hints of fields that depend on others. */
export const form = {
  height: 'Height, mm',
  width: 'Width, mm',
  depth: 'Depth, mm',
  scale: 'Factor',
  sheets: 'Sheets at most',
  holesUpTo: (percent: number): string => `close up to ${figure(percent)} % of the length`,
  solver: {
    tree: 'Mends one unfolding step by step: fast.',
    genetic: 'The paper’s way: breeds nets; slow.',
  },
  folding: {
    prefer: 'Every net that folds without running into itself is proved to; others are reported.',
    require: 'A part without a net that folds is split into pieces that do.',
    off: 'Nets only have to lie flat.',
  },
};

const pens = 'Red lines are cut, blue and green ones scored, pink ones drawn with a pen.';

/** How sheets are printed. */
export const printing = {
  machine: {
    none: 'For scissors or a knife.',
    silhouette: `${pens} With the black marks the machine finds a printed sheet.`,
    cricut: `${pens} Cricut’s program adds its own marks.`,
    generic: pens,
  },
  noColours: 'This machine gets lines only.',
  noPartColours: 'This machine would cut around these colours, so they are left out.',
  noLooks: 'This model comes without colours of its own.',
  longer: (percent: string): string => `${percent} % longer`,
  shorter: (percent: string): string => `${percent} % shorter`,
  correcting: (across: string, up: string): string =>
    `Correction is on: lines are drawn ${across} across and ${up} up. Print once more: the rulers now measure 50 mm.`,
  notCorrecting: 'Print a sheet at 100 %, then enter what its rulers measure.',
  corrected: (across: number, up: number): string =>
    `PDF and SVG are corrected for your printer (${figure(across)} × ${figure(up)} mm)`,
  frame: 'Pages to print',
  /** A page of the view before printing; null: one of those that tell how to build. */
  page: (sheet: number | null, sheets: number, width: number, height: number): string => {
    const size = `${figure(width, 1)} × ${figure(height, 1)} mm`;
    return sheet === null
      ? `How to build it, ${size}`
      : `Sheet ${figure(sheet)} of ${figure(sheets)}, ${size}`;
  },
  allSheets: (sheets: number): string =>
    sheets === 1 ? 'the only sheet' : `all ${figure(sheets)} sheets`,
  someSheets: (chosen: number, sheets: number): string =>
    `${figure(chosen)} of ${count(sheets, 'sheet')}`,
  unreadableRange: 'Write numbers, like 1-3, 5',
  beyondRange: (sheets: number): string => `There are sheets 1 to ${figure(sheets)}`,
};
