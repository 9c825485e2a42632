/** What `<foldwright-viewer>` says in French. */
import type { ViewerWords } from '../en/viewer.js';
import { count, figure } from './numbers.js';

export const viewer: ViewerWords = {
  unfold: 'Déplier',
  show: 'Montrer le modèle',
  cancel: 'Abandonner',
  play: 'Lecture',
  pause: 'Arrêter',
  slider: 'À quel point il est plié',
  percent: ({ share }) => `${figure(Math.floor(100 * share))}\u202f%`,
  flat: 'à plat',
  folded: 'plié',
  foldedBy: ({ time }) => `plié à ${figure(Math.floor(100 * time))}\u202f%`,
  downloads: 'Télécharger',
  model: ({ name, pieces }) =>
    `${name} en modèle de papier de ${count(pieces, 'pièce', 'pièces')}. Les touches fléchées le tournent`,
  nets: ({ name, pieces }) =>
    `Patrons de ${name}\u202f: ${count(pieces, 'pièce', 'pièces')} à découper`,
  sheet: ({ sheet, sheets }) => `Feuille ${figure(sheet)} sur ${figure(sheets)}`,
  noPicture: 'Ce navigateur ne peut pas dessiner le modèle en 3D.',
  faults: {
    'no-model': 'Il n’y a pas encore de modèle à déplier.',
    'not-loaded': 'Impossible de charger le modèle.',
    'not-fold':
      'Ce fichier FOLD ne contient pas de modèle avec ses patrons comme Foldwright les écrit.',
    'not-unfolded': 'Le modèle n’a pas encore été déplié.',
    'not-written': 'Impossible à partir d’un fichier FOLD\u202f: pour cela, déplie le modèle.',
    removed: 'La visionneuse n’est plus sur la page.',
  },
};
