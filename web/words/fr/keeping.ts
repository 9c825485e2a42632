/** What the studio says in French of the work that a browser keeps. */
import type { Words } from '../words.js';
import { figure, quoted } from './numbers.js';

const relative = new Intl.RelativeTimeFormat('fr', { numeric: 'auto' });

export const keeping: Words['keeping'] = {
  goOn: (name, isPending) =>
    isPending ? `Déplier ${quoted(name)} à nouveau` : `Continuer avec ${quoted(name)}`,
  ago: (number, unit) => relative.format(-number, unit),
  justNow: 'à l’instant',
  showAll: (number) => `Tout afficher (${figure(number)})`,
  rename: 'Renommer',
  copy: 'Copier',
  remove: 'Supprimer',
  about: (word, name) => `${word} ${quoted(name)}`,
  newName: (name) => `Nouveau nom de ${quoted(name)}`,
  kept: 'Gardé dans ce navigateur. Pour l’avoir ailleurs aussi, télécharge le projet.',
  none: 'Ce navigateur ne garde rien pour cette page. Télécharge le projet avant de partir.',
  scarce:
    'Il reste peu de place sur cet appareil. Supprime d’anciens travaux, ou télécharge le projet avant de partir.',
  unfinished: 'pas fini',
  deleted: (name) => `${quoted(name)} a été supprimé.`,
  copyOf: (name) => `Copie de ${name}`,
  full: [
    'Tes dernières modifications ne sont pas gardées',
    'Il n’y a plus de place sur cet appareil. Supprime d’anciens travaux sur la page d’accueil, ou télécharge le projet, pour ne rien perdre.',
  ],
  lost: [
    'Ton travail n’est pas gardé',
    'Ce navigateur ne garde rien pour cette page. Télécharge le projet avant de partir, pour ne rien perdre.',
  ],
  copied: (name) => [
    'Ce travail a aussi été modifié sur une autre page',
    `Les deux sont gardés\u202f: ce que tu vois ici continue sous le nom ${quoted(name)}.`,
  ],
  deletedElsewhere: (name) => [
    `${quoted(name)} a été supprimé sur une autre page`,
    'Ce que tu vois ici n’est plus gardé. Garde-le pour que rien ne se perde.',
  ],
  keepIt: 'Le garder',
  gone: (name) => `${quoted(name)} n’est plus là.`,
};
