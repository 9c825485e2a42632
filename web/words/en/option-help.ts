/** What help says of options in English. */
import type { Settings } from '../../model/options.js';

export const optionHelp: Record<keyof Settings, string> = {
  parts: 'number of parts',
  nets: 'file: keep the nets and flaps that the file brings along (PDO); new: search others',
  solver: 'tree: local search on spanning trees; genetic: evolution, as published',
  heuristic: 'for the learning: steepest, flat, hybrid or random',
  segment: 'merge: foldability with shape cues; spectral: foldability alone',
  runs: 'learning runs',
  proxy: 'learn on a proxy above N faces; 0: never',
  seed: 'the same seed gives the same result',
  faces: 'simplify to N triangles first',
  repair:
    'steps of the repair that are done or not, as weld=off or cracks=off; may be given several times',
  'fill-holes':
    'fill holes that are at most so many percent of the model’s longest side across; all: every hole',
  inside: 'bodies that lie inside others: keep; drop: leave them out',
  crossing: 'bodies that run through each other: keep; unite: make one of them',
  folding: 'nets without a folding motion: require: split; prefer: report; off: do not look',
  clearance: 'how far apart faces stay while folding, in mean edge lengths',
  height: 'finished height, from below to above; pieces too large for the sheet are cut again',
  width: 'finished width: along x, or along y with x up',
  depth: 'finished depth: along z, or along y with z up',
  up: 'axis of the file that points up: x, y or z; guess: z for STL, else y',
  scale: 'finished size as a factor on the size in the model’s unit',
  sheets: 'as large as goes on N sheets',
  unit: 'unit of the model: mm, cm, m or in',
  paper: 'A2 to A5, Letter, Legal, Tabloid, 12x12in, or WxH in mm',
  orientation: 'auto, portrait or landscape',
  margin: 'margin that stays free',
  flaps: 'height of flaps; lower ones where there is no room',
  'flap-angle': 'angle of their sides at the base, at most',
  'flap-style':
    'flaps along gentle bends: edge: each like any other; run: a strip with narrow notches; zigzag: pointed teeth',
  'flap-side': 'one: the side with more room; alternate: in turn; both',
  'flap-borders': 'on: open borders of the model get flaps as well',
  'glue-strips':
    'loose strips for edges without a flap: none; free: where sheets have room; all: on further sheets, too',
  ids: 'where the numbers of cut edges go: on faces (inside), flaps (flap) or both, on flaps and what is cut off (outside), or none',
  'min-piece': 'bodies of the model that are smaller are not printed, and told',
  compact: 'on: nets with room for flaps, small outlines and strong necks; off: as they were found',
  workers: 'threads; auto: one per core, at most 4; any number gives the same result',
  lang: 'language of all words: in help and messages, and on the sheets',
  'flat-fold': 'folds flatter than this are not drawn',
  style: 'how lines look: foldwright, pepakura or blender',
  'cut-width': 'width of cuts',
  'cut-colour': 'colour of cuts',
  'mountain-width': 'width of mountain folds',
  'mountain-dash': 'dashes and gaps of mountain folds',
  'mountain-colour': 'colour of mountain folds',
  'valley-width': 'width of valley folds',
  'valley-dash': 'dashes and gaps of valley folds',
  'valley-colour': 'colour of valley folds',
  'flap-colour': 'what flaps are filled with',
  'fold-ticks':
    'on: folds are marks of 3 mm at both ends, or a third of the fold, instead of lines across the picture',
  duplex:
    'on: behind each sheet a page with its folds, mirrored, to print on both sides, turned along the long edge (PDF)',
  'fold-angles': 'print beside folds how far they fold',
  thickness: 'how thick the paper is: flaps are folded where its back comes to lie',
  legend: 'print once what lines and numbers mean',
  assembly:
    'on: pages with a cover, a list of pieces and the steps to build the model (PDF, SVG, PNG)',
  measured: 'what the printed rulers of 50 mm measure, across and up: corrects the printer’s scale',
  machine:
    'for a cutting machine: lines to cut, score and draw in pure colours; none: for scissors',
  dpi: 'pixels to the inch of PNG files, and of the colours and pictures of the model in all files',
  texture:
    'print faces in the colours and pictures of the model; auto: where it has some, without --colour part',
  colour:
    'part: print each piece in the colour of its part, unless --texture on finds some in the model',
  shading:
    'on: print the light and shade of the surface, of a simplified model those of the surface before, so that small shapes are seen without folds',
  'flap-bleed': 'how much of a flap gets the colours of its face: none, half or whole',
};
