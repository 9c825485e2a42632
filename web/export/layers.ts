/** What a sheet consists of, from below to above; SVG groups have these ids. */
export const layerTitles = {
  texture: 'Textures',
  // A name that the Inkscape driver for Silhouette machines leaves out of what it cuts.
  registration: 'Regmarks',
  guide: 'Guide',
  flap: 'Flaps',
  'fold-mountain': 'Mountain folds',
  'fold-valley': 'Valley folds',
  id: 'Numbers',
  cut: 'Cuts',
} as const;

export type Layer = keyof typeof layerTitles;

export const layers = Object.keys(layerTitles) as readonly Layer[];
