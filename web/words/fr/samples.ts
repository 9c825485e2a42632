/** French names of the sample models. */
import type { Words } from '../words.js';

export const samples: Words['samples'] = {
  whale: 'Baleine',
  duck: 'Canard',
  cat: 'Chat',
  rabbit: 'Lapin',
  fish: 'Poisson',
  heart: 'Cœur',
  knot: 'Nœud',
  star: 'Étoile',
  house: 'Maison',
  torus: 'Anneau',
  icosahedron: 'Icosaèdre',
  cube: 'Cube',
};
