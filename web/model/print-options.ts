/** How sheets are drawn: nothing here changes the nets, so a change needs no new search. */
import { usualLanguage, type Language } from './languages.js';

export type LineKind = 'cut' | 'mountain' | 'valley';

/** How a kind of line looks on paper; lengths in mm. */
export interface LineStyle {
  width: number;
  /** Six hexadecimal digits after '#'. */
  colour: string;
  /** Lengths of dashes and gaps in turn; empty: solid. */
  dash: readonly number[];
}

/** A look as a whole: ours, or that of a program that people know. */
export type PrintStyle = 'foldwright' | 'pepakura' | 'blender';

/** Who cuts: a person with scissors, or a cutting machine with the program that comes with it. */
export type Machine = 'none' | 'silhouette' | 'cricut' | 'generic';

/** How much of a flap is coloured as the face that it hangs at. */
export type FlapBleed = 'none' | 'half' | 'whole';

export interface PrintOptions {
  /** Of all words on the sheets, and of the pages that come with them. */
  language: Language;
  style: PrintStyle;
  /** What differs from the style. */
  lines: Readonly<Partial<Record<LineKind, Partial<LineStyle>>>>;
  /** Colour that flaps are filled with, or 'none'; without it the style decides. */
  flaps?: string;
  /** Folds flatter than this many degrees are not drawn. */
  flatFold: number;
  /** Whether folds are short marks at both ends instead of lines; machines score them whole. */
  foldTicks: boolean;
  /** Whether PDF files have the folds on the backs of their sheets, too; none for machines. */
  duplex: boolean;
  /** Whether folds are told by how many degrees they are folded. */
  foldAngles: boolean;
  /** Of the paper, mm; flaps are folded where its back comes to lie. */
  thickness: number;
  /** Whether a legend is printed, once. */
  legend: boolean;
  /** Whether a cover, a list of pieces and the steps to build the model come with the sheets. */
  assembly: boolean;
  /** What the rulers of 50 mm measure on paper, across and up, when nothing is corrected. */
  measured: readonly [across: number, up: number];
  machine: Machine;
  /** Pixels to the inch of PNG files, and of what faces look like. */
  dpi: number;
  /**
   * Whether faces are printed in the colours and pictures of the model; auto: where it has some, and
   * pieces shall not have the colours of their parts.
   */
  texture: 'auto' | 'on' | 'off';
  /** Whether pieces are printed in the colours of their parts, unless those of the model are printed. */
  colour: 'part' | 'none';
  /** Whether the light is printed that the surface has, of a simplified model that of the surface before. */
  shading: boolean;
  flapBleed: FlapBleed;
}

/** Nominal length of the rulers; mm. */
export const rulerLength = 50;

/** What a person can have measured; anything else is no printer's error. */
export const measurable = { least: 45, most: 55 } as const;

/** Of paper, mm: below, nobody would see what changes; above, nothing folds. */
export const thicknessRange = { least: 0.05, most: 3 } as const;

/** Below, lines are coarser than a pen's; above, no printer prints. */
export const dpiRange = { least: 72, most: 1200 } as const;

export const defaultPrint: Readonly<PrintOptions> = {
  language: usualLanguage,
  style: 'foldwright',
  lines: {},
  flatFold: 3,
  foldTicks: false,
  duplex: false,
  foldAngles: false,
  thickness: 0,
  legend: true,
  assembly: false,
  measured: [rulerLength, rulerLength],
  machine: 'none',
  dpi: 300,
  texture: 'auto',
  colour: 'none',
  shading: false,
  flapBleed: 'half',
};

/** Whether sheets are corrected for a printer. Machines cut true to size, whatever printers do. */
export function isCalibrated({
  machine,
  measured,
}: Pick<PrintOptions, 'machine' | 'measured'>): boolean {
  return machine === 'none' && measured.some((length) => length !== rulerLength);
}

/** Whether sheets are printed on both sides. */
export function printsBacks({ duplex, machine }: PrintOptions): boolean {
  return duplex && machine === 'none';
}

/**
 * Whether sheets may have images. Silhouette's machines find the printed sheet by their marks and cut along the
 * lines upon it; that Cricut's program takes pictures in files is not known, and others would burn them.
 */
function takesImages(machine: Machine): boolean {
  return machine === 'none' || machine === 'silhouette';
}

/** Whether faces may have the model's looks. */
export function printsTexture({ colour, machine, texture }: PrintOptions): boolean {
  if (!takesImages(machine)) return false;
  return texture === 'on' || (texture === 'auto' && colour === 'none');
}

/** Whether faces may have the light of the model's surface. */
export function printsShading({ machine, shading }: PrintOptions): boolean {
  return shading && takesImages(machine);
}

/** Whether pieces may have the colours of their parts: machines would cut along the edges of areas. */
export function printsPartColours({ machine, colour }: PrintOptions): boolean {
  return colour === 'part' && machine === 'none';
}
