/** What is said about a model before it is unfolded. */
import type { Settings } from '../model/options.js';
import { mostFaces, usualFaces } from '../model/face-numbers.js';
import type { Message } from '../model/message.js';
import { phraseOf } from '../words/phrase.js';
import { sentence } from './sentence.js';

/** What stays wrong, so that a person should mend it elsewhere or know that pieces will collide. */
const unmended: readonly string[] = ['crossing-bodies', 'self-crossing-bodies'];

/** What stays as it is, and may well be meant. */
const left: readonly string[] = ['open-border', 'crossings-unchecked'];

const grouped = new Intl.NumberFormat('en');

/** 1500, but 69,451 with marks: it is to be grasped and not to be typed. */
export function large(number: number): string {
  return number < 10_000 ? String(number) : grouped.format(number);
}

/** Whether a message is about something wrong that nobody repairs. */
export function isUnmended({ code }: Message): boolean {
  return unmended.includes(code);
}

/** Sentences about what was repaired, and about what was not. */
export function repairWords(repairs: readonly Message[]): {
  repaired: string[];
  remaining: string[];
} {
  const remains = ({ code }: Message): boolean => unmended.includes(code) || left.includes(code);
  const words = (messages: Message[]): string[] =>
    messages.map((message) => sentence(phraseOf(message)));
  return {
    repaired: words(repairs.filter((repair) => !remains(repair))),
    remaining: words(repairs.filter(remains)),
  };
}

/** Why fewer triangles are proposed, or that none have to be. */
export function triangleWords(faces: number, proposal: number | null): string {
  const has = `This model has ${large(faces)} triangles.`;
  if (proposal === null) return faces > usualFaces ? has : `${has} That is fine for paper.`;
  return `${has} Paper models have 200 to 1500, so ${large(proposal)} are set for it: the picture shows what is left of its shape.`;
}

/** What the picture shows. */
export function lookWords(faces: number | null, isWorking: boolean, wanted: string): string {
  if (isWorking) return `Making a model of ${wanted} …`;
  return faces === null ? '' : `The picture has ${large(faces)} triangles.`;
}

/** Why a model cannot be taken as it is. */
export function boundWords(faces: number): string {
  return (
    `All ${large(faces)} are too many: nets of more than ${large(mostFaces)} triangles would take hours ` +
    'and be too small to fold.'
  );
}

/** What there is to know of separate bodies; empty for one. */
export function bodyWords(bodies: number, tiny: number): string {
  if (bodies < 2) return '';
  const separate = `The model is made of ${large(bodies)} separate bodies, each with nets of its own.`;
  if (tiny === 0) return separate;
  const [are, them] = tiny === 1 ? ['is', 'it'] : ['are', 'them'];
  return (
    `${separate} ${large(tiny)} of them ${are} tiny: less than 3 % of its length. ` +
    `The picture shows ${them} in colour.`
  );
}

/** What becomes of the nets that a file brings along. */
export function netsWords(pieces: number, nets: Settings['nets']): string {
  if (nets === 'file') {
    return 'The model is cut and folded just as in its file, at the same size if the paper has room for it.';
  }
  const [own, them] =
    pieces === 1 ? ['its own net', 'it'] : [`its own nets, ${large(pieces)} pieces`, 'them'];
  return `The file brings ${own}. Keep ${them} to cut and fold as its maker did, or have new nets made.`;
}

/** A length as people say it: 8 mm, 12 cm, 1.2 m. */
export function lengthWords(mm: number): string {
  if (mm < 10) return `${Number(mm.toPrecision(2))} mm`;
  if (mm < 1000) return `${Number((mm / 10).toPrecision(mm < 100 ? 2 : 3))} cm`;
  return `${Number((mm / 1000).toPrecision(2))} m`;
}
