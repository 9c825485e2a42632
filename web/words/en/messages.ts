/** An English phrase for every message, which may be part of a line. */
import { fileMessages } from './files.js';
import { optionFault } from './options.js';
import { paperMessages } from './paper.js';
import { projectMessages } from './projects.js';
import { readerMessages } from './readers.js';
import { repairMessages } from './repair.js';
import type { Messages, Table } from '../messages.js';
import { all, choose, count, figure, fixed, parts, pieces, some } from './numbers.js';

/** What a stage does, and what helps where memory ends in it. */
const stages = {
  read: ['reading and repairing the model', 'simplify the model in the program that made it'],
  learn: ['learning from unfoldings', 'simplify the model to fewer faces'],
  cluster: ['cutting the model into parts', 'simplify the model to fewer faces'],
  search: ['searching nets', 'simplify the model to fewer faces'],
  compact: ['making room for flaps', 'simplify the model to fewer faces'],
  paper: ['placing pieces on sheets', 'choose a smaller size, smaller paper or fewer faces'],
} as const;

const units = { mm: 'millimetres', cm: 'centimetres', m: 'metres', in: 'inches' } as const;

function badEdit(params: Messages['bad-edit']): string {
  switch (params.what) {
    case 'no-part-named':
      return 'an edit must name a part';
    case 'no-part':
      return `there is no part ${figure(params.part)}: the model has ${count(params.parts, 'part')}`;
    case 'twice':
      return `part ${figure(params.part)} is named twice: one change at a time for each part`;
    case 'apart':
      return `${parts(params.parts)} do not touch, so they cannot become one`;
    case 'into':
      return (
        `${parts(params.parts)} cannot become ${count(params.into, 'part')}: from 1 to ${figure(params.most)} ` +
        'are possible, one for each flat panel'
      );
  }
}

function badOption(params: Messages['bad-option']): string {
  switch (params.what) {
    case 'height':
    case 'width':
    case 'depth':
      return `${params.what} must be above 0 and at most ${figure(params.most)} mm`;
    case 'scale':
      return `scale must be above 0 and at most ${figure(params.most)}`;
    case 'paper':
      return `paper must be between 0 and ${figure(params.most)} mm`;
    case 'pin-sheet':
      return `the sheet of a pinned piece must be one of the first ${figure(params.most)}`;
    case 'parts':
      return `parts must be auto or at least ${figure(params.least)}`;
    case 'proxy':
      return `proxy must be ${figure(params.least)} or more`;
    case 'faces':
      return `faces must be at least ${figure(params.least)}`;
    case 'margin':
      return `margin must be ${figure(params.least)} mm or more, and less than half the paper's shorter side`;
    case 'sheets':
      return `sheets must be a whole number from ${figure(params.least)} to ${figure(params.most)}`;
    case 'flaps':
      return `flaps must be from ${figure(params.least)} to ${figure(params.most)} mm`;
    case 'flap-height':
      return `the height of a flap must be from ${figure(params.least)} to ${figure(params.most)} mm`;
    case 'flap-angle':
      return `flap-angle must be from ${figure(params.least)} to ${figure(params.most)} degrees`;
    case 'runs':
    case 'clearance':
    case 'fill-holes':
      return `${params.what} must be from ${figure(params.least)} to ${figure(params.most)}`;
    case 'repair':
      return `'${params.step}' is a step of the repair that cannot be switched off`;
    case 'names-of-part':
      return 'the names of parts must be at most one for each part';
    case 'pin-piece':
      return 'a pinned piece must be named by its part and a face of it';
    case 'pin-place':
      return 'the place of a pinned piece must be a finite number';
    case 'name-control':
      return 'the name of a part must not hold control characters';
    case 'name-colon':
      return 'the name of a part must not hold a colon, which stands before the number of an edge';
    case 'name-length':
      return 'the name of a part must have 1 to 16 characters, and no space around them';
    case 'name-number':
      return 'the name of a part must not be a number: numbers name edges';
    case 'same-name':
      return `two parts cannot have the same name, "${params.name}"`;
    case 'flap-edge':
      return `a flap is chosen for the edge from vertex ${figure(params.from)} to ${figure(params.to)}, which the model does not have`;
    case 'unreadable':
    case 'written':
      return params.detail;
    default:
      return optionFault(params);
  }
}

function faceTooLarge(params: Messages['face-too-large']): string {
  const { face_width_mm, face_height_mm, width_mm, height_mm, share } = params;
  const paper = fixed(Math.ceil(10 / share) / 10, 1);
  return (
    `at this size a flat face of ${figure(face_width_mm, 0)} x ${figure(face_height_mm, 0)} mm is larger than a sheet of ` +
    `${figure(width_mm, 3)} x ${figure(height_mm, 3)} mm: it would fit at ${Math.floor(100 * share)} % of the size, ` +
    `or on paper ${paper} times as large`
  );
}

function locked(params: Messages['locked']): string {
  switch (params.what) {
    case 'fold':
      return 'this edge is locked: it is never cut';
    case 'cut':
      return 'this edge is locked: it is always cut';
    case 'faces':
      return 'a locked fold holds the faces where they are';
    case 'loop':
      return 'the loop cannot be opened elsewhere: its folds are locked';
    case 'parts':
      return `locked folds hold the faces together: ${figure(params.parts)} parts cannot be made of them`;
  }
}

function filesIgnored({ files }: Messages['files-ignored']): string {
  const were = choose(files.length, 'was', 'were');
  return `${count(files.length, 'other file')} ${were} not needed: ${some(files)}`;
}

/** A time that is only estimated; nothing of one that nobody would mind. */
function roughTime(seconds: number): string {
  if (seconds < 12) return '';
  const time =
    seconds < 90 ? `${Math.round(seconds / 5) * 5} seconds` : `${Math.round(seconds / 60)} minutes`;
  return `nets for them take about ${time}, and `;
}

function largeModel({ faces, seconds, proposed }: Messages['large-model']): string {
  return (
    `the model has ${figure(faces)} faces: ${roughTime(seconds)}most of them will be too small ` +
    `to fold; paper models have a few hundred (--faces ${proposed} makes a simpler model)`
  );
}

function partsRaised(params: Messages['parts-raised']): string {
  if (params.what === 'bodies') {
    const bodies = count(params.bodies, 'separate body', 'separate bodies');
    return `the model has ${bodies}, so it needs at least as many parts`;
  }
  return (
    `in ${figure(params.parts)} parts it would come to ${figure(params.pieces)} pieces, so it was cut into ` +
    `${figure(params.instead)} parts instead, each in one piece`
  );
}

function uncheckedPieces({ what, pieces: names }: Messages['unchecked-pieces']): string {
  const help = 'more parts, or fewer faces, would help';
  if (what === 'large') {
    return `turning all folds evenly does not fold up ${pieces(names)}, and with so many faces no other way was looked for; ${help}`;
  }
  const reasons = {
    off: 'folding is switched off',
    cancelled: 'the run was cancelled before',
    kept: 'the earlier result, which is kept, had none',
    huge: `so many faces take too long; ${help}`,
  };
  return `no way to fold up ${pieces(names)} was looked for: ${reasons[what]}`;
}

export const messages: Table = {
  ...fileMessages,
  ...repairMessages,
  ...paperMessages,
  ...projectMessages,
  ...readerMessages,

  'bad-edit': badEdit,
  'bad-margin': () => 'margins leave nothing of the sheet: paper and margin do not fit',
  'bad-option': badOption,
  'bad-pin': (params) =>
    params.what === 'outside'
      ? `piece ${params.piece} is pinned partly outside the printable area of sheet ${figure(params.sheet)}`
      : `pieces ${params.pieces.join(' and ')} are pinned on top of each other on sheet ${figure(params.sheet)}`,
  'bad-start': () => 'the earlier result does not belong to this model',
  'face-too-large': faceTooLarge,
  internal: ({ what, detail }) => `internal error while ${stages[what][0]}: ${detail}`,
  'no-depth': () => 'the model has no depth that could be scaled',
  'no-height': () => 'the model has no height that could be scaled',
  'no-width': () => 'the model has no width that could be scaled',
  'out-of-memory': ({ what }) =>
    what === 'file'
      ? 'there is not enough memory for the file of the model'
      : `there is not enough memory for ${stages[what].join(': ')}`,
  'too-many-faces': ({ faces, most, proposed }) =>
    `the model has ${figure(faces)} flat faces, and nets for more than ${figure(most)} would take hours and be far too small to fold: --faces ${proposed} makes a simpler model that can be folded`,
  'too-few-sheets': () => 'the pieces do not go on so few sheets at any size',

  'edit-place-gone': ({ what }) =>
    ({
      edge: 'there is no such edge there any more',
      faces: 'there are no such faces there any more',
      part: 'there is no such part there any more',
      piece: 'there is no such piece there any more',
    })[what],
  'already-cut': () => 'this edge is cut already',
  'already-joined': () => 'this edge is a fold already',
  locked,
  'inside-panel': () => 'this edge lies within a flat face, which stays whole',
  'no-edge': ({ from, to }) =>
    `the model has no edge between corners ${figure(from)} and ${figure(to)}`,
  'no-face': (params) =>
    params.what === 'none'
      ? 'no face was named'
      : `the model has faces from 0 to ${figure(params.most)}`,
  'no-net': () => 'a face beside this edge has no net yet',
  'no-part': ({ part, parts: all }) =>
    `there is no part ${figure(part)}: the model has ${figure(all)}`,
  'not-in-loop': () => 'cutting there would not open the loop',
  'not-touching': () => 'the faces do not touch that part',
  overlap: ({ what }) =>
    what === 'pieces'
      ? 'the two pieces would overlap there'
      : 'faces of the piece would overlap, wherever it is opened instead',
  'would-fall-apart': ({ what, part }) =>
    `without ${what === 'fold' ? 'this fold' : 'these faces'} part ${figure(part)} would fall apart`,

  'files-ignored': filesIgnored,
  'faces-above-wish': ({ faces }) =>
    `simplifying stopped at ${figure(faces)} faces: fewer would break the surface`,
  joints: ({ what, count: number }) =>
    `${count(number, 'edge')} ${choose(number, 'is', 'are')} glued to faces that ${choose(number, 'it does', 'they do')} ` +
    `not continue${what === 'numbered' ? ': look for the same number there' : ''}`,
  'joints-lost': ({ count: number }) =>
    `${count(number, 'edge')} that stood on other faces came loose when the model was simplified: glue by sight`,
  'large-model': largeModel,
  'colour-numbers': () =>
    'the file gives its faces numbers instead of colours, and does not say which colours these are: they are not printed',
  'meets-itself': ({ part }) =>
    `part ${figure(part)} has faces that run through each other in the model, so no folding of it is free of collisions`,
  'no-motion': ({ part }) =>
    `no way was found to fold up part ${figure(part)} in one go without faces running into each other`,
  'part-split': ({ what, part, pieces: number }) =>
    `part ${figure(part)} ${what === 'no-motion' ? 'does not fold up' : 'has no net'} in one piece and became ` +
    `${figure(number)} pieces`,
  'parts-lowered': ({ panels }) =>
    `the model has only ${count(panels, 'flat panel')}, so it cannot have more parts`,
  'parts-raised': partsRaised,
  'pin-lost': ({ count: number }) =>
    `${figure(number)} pinned ${choose(number, 'piece is', 'pieces are')} no longer there as they were, ` +
    'and were laid out anew',
  'small-bodies': ({ count: number, limit_mm }) =>
    `${count(number, 'body', 'bodies')} of the model ${choose(number, 'is', 'are')} smaller than ${figure(limit_mm)} mm and ` +
    `${choose(number, 'was', 'were')} left out`,
  'smaller-saves-sheets': ({ what, size_mm, instead_mm, sheets, of }) =>
    `with a ${what} of ${figure(size_mm)} mm instead of ${figure(Math.round(instead_mm))} it should go on ` +
    `${count(sheets, 'sheet')} instead of ${figure(of)}`,
  'sheet-split': ({ part, pieces: number }) =>
    `part ${figure(part)} is too large for the sheet and was cut into ${figure(number)} pieces`,
  'run-stopped': () =>
    'the search was stopped before its end, and what was found until then is here; unfold again to let it finish',
  'unchecked-pieces': uncheckedPieces,
  'unit-guessed': ({ unit }) => `the model's unit is not known; ${units[unit]} were assumed`,
  'up-guessed': () =>
    'the file does not say which way is up; the z axis was taken, as in most files of this format',
  'weak-necks': ({ pieces: names }) =>
    'folds under 5 mm hold many faces on both sides and may tear: strengthen them with tape on the back; ' +
    pieces(names),

  'engine-died': ({ reason, times }) =>
    times === undefined
      ? `The engine stopped unexpectedly: ${reason}`
      : `The engine stopped unexpectedly ${figure(times)} times at the same task: ${reason}`,
  overtaken: () => 'another step was taken back or made again meanwhile',
  'no-piece': ({ piece, pieces: all }) =>
    `there is no piece ${figure(piece)}: there are ${figure(all)}`,
  'not-pinned': ({ piece }) => `piece ${figure(piece)} is not pinned`,
  'not-together': () =>
    'only edits of flaps alone, or edits that split and merge parts, can be made in one go',
  'no-legend': () => 'no sheet has room for the legend',
  'beyond-page': ({ by_mm, margin_mm }) =>
    `corrected for this printer, lines run ${fixed(by_mm, 1)} mm over the edge of the page; with a margin of ${figure(margin_mm)} mm (--margin ${margin_mm}) they stay on it`,
  'missing-glyphs': ({ letters }) =>
    `no font has ${letters.join(' ')}: a box is printed in its place`,
  'fonts-not-loaded': () =>
    'the fonts for some letters could not be loaded: they look as the reader’s fonts have them',
  'marks-not-free': ({ pieces: names, margin_mm }) =>
    'the machine looks for its marks where something is cut: ' +
    `a margin of ${figure(margin_mm)} mm keeps them free; ${pieces(names)}`,
  'cricut-area': ({ sheets, width_mm, height_mm, margin_mm }) =>
    `Cricut prints and then cuts ${Math.floor(width_mm)} x ${Math.floor(height_mm)} mm of this paper at most, and ` +
    `${choose(sheets.length, 'sheet', 'sheets')} ${all(sheets.map((sheet) => figure(sheet)))} ` +
    `${choose(sheets.length, 'needs', 'need')} more: cut without printing, or choose a margin of ${figure(margin_mm)} mm`,
};
