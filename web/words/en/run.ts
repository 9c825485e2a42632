/** What is said in English while a model is unfolded, and of what comes of it. */
import { count, figure, fixed } from './numbers.js';

export const run = {
  /** What happens now, as a headline and within a line. */
  stages: {
    read: 'Reading the model',
    learn: 'Learning which faces unfold well together',
    cluster: 'Choosing the parts',
    search: 'Laying the parts flat',
    compact: 'Making room for flaps',
    paper: 'Placing the pieces on sheets',
  },
  stageLines: {
    read: 'reading the model',
    learn: 'learning from unfoldings',
    cluster: 'cutting into parts',
    search: 'searching nets',
    compact: 'making room for flaps',
    paper: 'placing on sheets',
  },
  detailed: (stage: string, detail: string): string => `${stage}: ${detail}`,
  learned: (runs: number, of: number): string =>
    `${figure(runs)} of ${figure(of)} unfoldings tried`,
  partsDone: (done: number, parts: number): string =>
    `${figure(done)} of ${count(parts, 'part')} done`,
  overlapsLeft: (overlaps: number): string => `${count(overlaps, 'overlap')} left`,
  minutesLeft: (minutes: number): string => `about ${figure(minutes)} minutes left`,
  secondsLeft: (seconds: number): string => `about ${figure(seconds)} seconds left`,
  goingBack: 'Going back.',
  stopping: 'Laying the finished pieces on sheets.',

  /** How it ended, before a sentence about the result. */
  done: (lead: string): string => `Done: ${lead}`,
  stopped: (lead: string): string => `Stopped. ${lead}`,
  undone: (lead: string): string => `Undone: ${lead}`,
  madeAgain: (lead: string): string => `Made again: ${lead}`,
  hold: (why: string): string => `Check the model. ${why}`,
  named: (name: string): string => `Named ${name}.`,
  nameGone: 'The name is gone.',
  editCancelled: 'Cancelled. All is as it was.',
  unfoldAgain: 'Unfold again',

  /** What is said aloud when work has come to nothing because a person ended it. */
  farewells: { cancelled: 'Cancelled.', empty: 'Stopped.' },
  /** What is said of the pictures of a run that has no result. */
  notes: {
    cancelled: 'Cancelled. This is how far it came; nothing of it is kept.',
    empty: 'Stopped. This is how far it came.',
    failed: 'This is how far it came.',
    undrawn: 'The nets were found, but not drawn.',
  },
  /** What a person can do about a failure. */
  nextSteps: {
    file: 'Choose another model, or repair this one and try again.',
    job: 'Change the settings and try again, or choose another model.',
    crash: 'Nothing else is lost, and the next run starts afresh. A smaller model may work.',
  },
  nothingToUse: [
    'There is nothing to use yet',
    'When the search was stopped, no part had a net: the last one was being changed again. Let it run a little longer next time.',
  ] as [string, string],
  notUnfolded: (model: string): string => `“${model}” could not be unfolded`,
  stillThere: (model: string): string => `What is below is still the result of “${model}”.`,
  notDrawn: (model: string): string => `The sheets of “${model}” could not be drawn`,
  notWritten: (format: string): string => `The ${format} file could not be written`,
  projectNotWritten: 'The project file could not be written',
  resultIsHere: 'The result is still here.',
  notPrinted: 'The pages could not be printed',
  onceMore: 'Try it once more.',
  nothingChanged: 'Nothing was changed',
  nothingUnfolded: 'Nothing was unfolded',
  noBrowser: 'Foldwright cannot run in this browser',
  browserLacks:
    'This browser lacks module workers or WebAssembly with SIMD and exceptions, which the unfolding ' +
    'needs. Chrome and Edge have them since version 95, Firefox since 114, Safari since 16.4.',
};

/** How a result is told. */
export const result = {
  onePiece: (sheets: number, paper: string): string =>
    `All in one piece, on ${count(sheets, 'sheet')} of ${paper}.`,
  eachInOne: (parts: number, sheets: number, paper: string): string =>
    `${count(parts, 'part')}, each in one piece, on ${count(sheets, 'sheet')} of ${paper}.`,
  inPieces: (parts: number, pieces: number, sheets: number, paper: string): string =>
    `${count(parts, 'part')} in ${count(pieces, 'piece')} on ${count(sheets, 'sheet')} of ${paper}.`,
  /** That some parts lack faces, and so the model has holes. */
  withHoles: (p: {
    finished: number;
    parts: number;
    pieces: number;
    sheets: number;
    paper: string;
  }): string => {
    const parts = count(p.parts, 'part');
    const whole =
      p.finished === 0
        ? `None of ${parts} is whole`
        : `Only ${figure(p.finished)} of ${parts} ${p.finished === 1 ? 'is' : 'are'} whole`;
    const missing = p.parts - p.finished;
    const others = missing === 1 ? 'The other part is' : `The other ${figure(missing)} parts are`;
    return (
      `${whole}: ${count(p.pieces, 'piece')} on ${count(p.sheets, 'sheet')} of ${p.paper}. ` +
      `${others} missing, so the model will have holes. Unfold again to get them all.`
    );
  },
  /** Labels of what is worth knowing before printing. */
  facts: {
    pieces: 'Pieces',
    sheets: 'Sheets',
    size: 'Finished size',
    smallest: 'Smallest piece',
    glue: 'To glue',
    flaps: 'Flaps',
    numbers: 'Edge numbers',
    scale: 'Scale',
    paper: 'Paper used',
    triangles: 'Triangles',
    time: 'Computed in',
  },
  none: 'none',
  smallest: (name: string, width: number, height: number): string =>
    `${name}, ${figure(width)} × ${figure(height)} mm`,
  glue: (metres: number, seams: number): string =>
    `${fixed(metres, 1)} m on ${count(seams, 'seam')}`,
  /** How many seams have a flap, and what joins the others; none of what there is none of. */
  flaps: (p: {
    wanted: number;
    flaps: number;
    shrunk: number;
    strips: number;
    taped: number;
  }): string => {
    const words: string[] = [];
    if (p.wanted > 0) words.push(`on ${figure(p.flaps)} of ${count(p.wanted, 'seam')}`);
    if (p.shrunk > 0) words.push(`${figure(p.shrunk)} of them narrow`);
    if (p.strips > 0) words.push(count(p.strips, 'loose strip'));
    if (p.taped > 0) words.push(`${figure(p.taped)} to be taped`);
    return words.join(', ');
  },
  numbers: (printed: number, seams: number): string =>
    `on ${figure(printed)} of ${count(seams, 'seam')}`,
  scale: (mm: number): string => `1 unit is ${figure(mm)} mm`,
  percent: (percent: number): string => `${figure(percent)} %`,
  seconds: (seconds: number, digits: number): string => `${fixed(seconds, digits)} s`,
  minutes: (minutes: number, seconds: number): string =>
    `${figure(minutes)} min ${figure(seconds)} s`,
  repaired: 'Repaired before unfolding',
  worthKnowing: 'Worth knowing',
  sheet: (sheet: number, sheets: number): string => `Sheet ${figure(sheet)} of ${figure(sheets)}`,
  /** The caption of a sheet. */
  caption: (sheet: number, sheets: number, names: readonly string[]): string =>
    `Sheet ${figure(sheet)} of ${figure(sheets)}: ${names.length === 1 ? 'piece' : 'pieces'} ${names.join(', ')}`,
  forModel: (percent: number): string => `${figure(percent)} % for the model`,
};

/** Beside the pictures of a run. */
export const pictures = {
  matrixToCome: 'every pair of faces is a dot',
  nothingLearned: 'nothing had to be learned for these parts',
  blocks: 'each frame is a part',
  darker: 'darker: more often together',
  netToCome: 'comes after the parts are chosen',
  netBegins: 'begins at once',
  generation: (part: number, generation: number, overlaps: number): string =>
    `part ${figure(part)}, generation ${figure(generation)}: ${count(overlaps, 'overlap')}`,
  netDone: (part: number): string => `part ${figure(part)}, without overlaps`,
  couldBePrinted: (sheets: number): string =>
    `${sheets === 1 ? 'this sheet' : `these ${count(sheets, 'sheet')}`} could be printed now; the nets are being made easier to build`,
  netsToCome: 'each comes here as soon as it lies flat',
  netsFound: (nets: number): string =>
    `${count(nets, 'net')} found so far; letters and sheets come at the end`,
  noWebGl: 'This browser draws no 3D view, because it has no WebGL 2. All else works.',
  broken: 'The 3D view does not work here. All else does.',
};
