/** What a batch says in French, on its page and in a terminal. */
import type { Words } from '../words.js';
import { building } from './building.js';
import { count, figure } from './numbers.js';

export const batch: Words['batch'] = {
  help: {
    about:
      'Déplie beaucoup de modèles. Arrêté puis relancé, il reprend là où il en était\u202f; ce qui a changé depuis est refait.',
    usage: '[options] <source...>',
    source:
      'dossier de modèles, à toute profondeur\u202f; ou fichier texte avec un chemin par ligne\u202f; ou - pour une telle liste sur l’entrée standard\u202f; ou modèles',
    out: 'dossier pour tout ce qui est écrit, avec une page qui le montre',
    format: (names) => `certains de ${names}, séparés par des virgules`,
    shard: 'seulement cette part des modèles, de 1/N à N/N\u202f: une pour chacun de N ordinateurs',
    workers:
      'Avec beaucoup de modèles, --workers est le nombre de modèles à la fois\u202f; auto\u202f: un par cœur.',
  },
  noFolder: (option) => `l’option '${option}' n’est pas un dossier`,
  noModels:
    'il n’y a aucun modèle\u202f: aucun fichier OBJ, STL, OFF, PLY, GLB, glTF, 3MF, PDO ou ZIP, et aucun projet',
  about: (name, text) => `${name}\u202f: ${text}`,
  models: (models) => count(models, 'modèle', 'modèles'),
  outcomes: {
    done: (models) => count(models, 'fait', 'faits'),
    skipped: (models) => count(models, 'déjà fait', 'déjà faits'),
    refused: (models) => count(models, 'inutilisable', 'inutilisables'),
    failed: (models) => count(models, 'raté', 'ratés'),
    left: (models) => count(models, 'pas encore fait', 'pas encore faits'),
  },
  died: (reason) => `le programme n’a pas pu continuer avec ce modèle\u202f: ${reason}`,
  ended: (status) => `le fil s’est terminé avec l’état ${figure(status)}`,
  goOn: 'la même commande reprend ici',

  pageTitle: 'Modèles en papier',
  amount: ({ pieces, sheets }) =>
    `${count(pieces, 'pièce', 'pièces')} sur ${count(sheets, 'feuille', 'feuilles')}`,
  building: (seconds) => `${building.duration({ seconds })} pour le construire`,
  picture: (name) => `${name}, plié`,
  notices: (notices) => count(notices, 'remarque', 'remarques'),
  faults: 'Ceux-ci n’ont donné aucun modèle en papier',
  missing: 'pas encore fait',
  failed: 'le programme a échoué ici et réessaiera la prochaine fois',
};
