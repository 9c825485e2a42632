/** What is said in French of a model that is chosen and looked at before it is unfolded. */
import type { Words } from '../words.js';
import { choose, count, figure, large, quoted, rounded, some } from './numbers.js';
import { excess } from './readers.js';

const levels = { easy: 'Facile', medium: 'Moyen', hard: 'Difficile' } as const;

export const choice: Words['choice'] = {
  opening: (files) => `Ouverture\u202f: ${some(files)}`,
  chosen: (files) => `Choisi\u202f: ${some(files)}`,
  fileTooLarge: (file, fault) =>
    `${quoted(file)} est trop gros\u202f: il y a ${excess(fault)}. Enregistre-le avec moins de faces, ou dans un format binaire.`,
  tooMuch: (fault) =>
    `C’est trop\u202f: il y a ${excess(fault)}. Choisis un modèle et ce qui va avec.`,
  notLoaded: (file) => `Impossible de charger ${quoted(file)}.`,
  notLetIn: (file) =>
    `Impossible de charger ${quoted(file)}\u202f: il se trouve sur un autre site, et les navigateurs ne vont le chercher que si les deux sites le permettent. Enregistre-le sur ton appareil et dépose-le ici.`,
  unreadable: (file) =>
    `Impossible de lire ${quoted(file)}\u202f: c’est un dossier, ou bien il a été déplacé, ou il est interdit de l’ouvrir.`,
  unreadableDrop: (file) =>
    `Impossible de lire ${quoted(file)}\u202f: il a été déplacé, ou il est interdit de l’ouvrir.`,
  noFile:
    'Ce n’était pas un fichier. Choisis un fichier GLB, OBJ, STL, 3MF, PLY, OFF, PDO ou FOLD, ou un ZIP qui en contient un.',
  empty: (file) => `${quoted(file)} est vide\u202f: il n’y a rien à déplier dedans.`,
  noSamples: 'Impossible de charger les exemples. Tes propres modèles marchent quand même.',
  sample: (name, faces) => `${name}, ${count(faces, 'face', 'faces')}`,
  effort: (level, pieces) => `${levels[level]}\u202f: ${count(pieces, 'pièce', 'pièces')}`,
  pending: (names) => `Pas encore appliqué\u202f: ${names}.`,
};

function length(mm: number): string {
  if (mm < 10) return `${rounded(mm)} mm`;
  if (mm < 1000) return `${rounded(mm / 10, mm < 100 ? 2 : 3)} cm`;
  return `${rounded(mm / 1000)} m`;
}

export const check: Words['check'] = {
  length,
  triangles: (faces) => `Ce modèle a ${large(faces)} ${choose(faces, 'triangle', 'triangles')}.`,
  fine: 'C’est bien pour du papier.',
  proposed: (proposal) =>
    `Les modèles en papier en ont 200 à 1500, le réglage est donc de ${large(proposal)}\u202f: l’image montre ce qui reste de sa forme.`,
  making: (wanted) => `Préparation du modèle\u202f: ${wanted} …`,
  shown: (faces) => `L’image a ${large(faces)} ${choose(faces, 'triangle', 'triangles')}.`,
  asItIs: (faces) => `comme il est\u202f: ${large(faces)}`,
  all: (faces) => `les ${large(faces)} triangles`,
  some: (faces) => `${large(faces)} ${choose(faces, 'triangle', 'triangles')}`,
  tooMany: (faces, most) =>
    `${large(faces)}, c’est trop\u202f: des patrons de plus de ${large(most)} triangles prendraient des heures ` +
    'et seraient trop petits pour être pliés.',
  bodies: (bodies) =>
    `Le modèle est fait de ${large(bodies)} corps séparés, chacun avec ses propres patrons.`,
  tiny: (bodies) =>
    bodies === 1
      ? 'L’un d’eux est minuscule\u202f: moins de 3\u202f% de la longueur du modèle. L’image le montre en couleur.'
      : `${large(bodies)} d’entre eux sont minuscules\u202f: moins de 3\u202f% de la longueur du modèle. L’image les montre en couleur.`,
  holes: ({ count: number, small, smallPercent }) => {
    const few = `${large(small)} d’entre eux ${small > 1 ? 'sont petits' : 'est petit'}\u202f: au plus ${figure(smallPercent)}\u202f% de la longueur du modèle.`;
    const isMixed = small > 0 && small < number;
    return `Le modèle a ${count(number, 'trou', 'trous')}. ${isMixed ? `${few} ` : ''}Ce qui bouche un trou prend les couleurs d’à côté.`;
  },
  inside: (bodies) =>
    bodies === 1
      ? 'Un corps est à l’intérieur d’un autre, où personne ne le verra. Sans lui, il y a moins à couper et à coller.'
      : `${large(bodies)} corps sont à l’intérieur d’autres, où personne ne les verra. Sans eux, il y a moins à couper et à coller.`,
  netsKept:
    'Le modèle est coupé et plié exactement comme dans son fichier, à la même taille si le papier a la place.',
  netsOffered: (pieces) =>
    pieces === 1
      ? 'Le fichier apporte son propre patron. Garde-le pour couper et plier comme son auteur, ou fais faire de nouveaux patrons.'
      : `Le fichier apporte ses propres patrons, ${large(pieces)} pièces. Garde-les pour couper et plier comme leur auteur, ou fais faire de nouveaux patrons.`,
  size: (p) =>
    `${length(p.height)} de haut, ${length(p.width)} de large, ${length(p.depth)} de profondeur, à côté d’un crayon de ${length(p.pencil)}.`,
  fits: {
    new: 'Aussi grand que la feuille le permet\u202f: tu verras sa taille quand il sera déplié.',
    file: 'Aussi grand que dans le fichier, ou que la feuille le permet\u202f: tu verras sa taille quand il sera déplié.',
    other: 'Tu verras sa taille quand il sera déplié.',
  },
  chooseHeight: 'Choisis une hauteur pour le voir à côté d’un crayon.',
};

export const form: Words['form'] = {
  height: 'Hauteur, mm',
  width: 'Largeur, mm',
  depth: 'Profondeur, mm',
  scale: 'Facteur',
  sheets: 'Feuilles au maximum',
  holesUpTo: (percent) => `boucher jusqu’à ${figure(percent)}\u202f% de la longueur`,
  solver: {
    tree: 'Améliore un dépliage pas à pas\u202f: rapide.',
    genetic: 'Comme dans l’article scientifique\u202f: fait évoluer des patrons\u202f; lent.',
  },
  folding: {
    prefer:
      'Pour chaque patron qui se plie sans se heurter lui-même, c’est prouvé\u202f; les autres sont signalés.',
    require: 'Une partie sans patron qui se plie est divisée en pièces qui se plient.',
    off: 'Les patrons doivent seulement tenir à plat.',
  },
};

const pens =
  'Les lignes rouges sont coupées, les bleues et les vertes rainées pour le pli, les roses dessinées au stylo.';

export const printing: Words['printing'] = {
  machine: {
    none: 'Pour des ciseaux ou un cutter.',
    silhouette: `${pens} Les repères noirs aident la machine à trouver une feuille imprimée.`,
    cricut: `${pens} Le programme de Cricut ajoute ses propres repères.`,
    generic: pens,
  },
  noColours: 'Cette machine ne reçoit que des lignes.',
  noPartColours: 'Cette machine découperait autour de ces couleurs, alors on les laisse de côté.',
  noLooks: 'Ce modèle n’a pas de couleurs à lui.',
  longer: (percent) => `${percent}\u202f% plus longues`,
  shorter: (percent) => `${percent}\u202f% plus courtes`,
  correcting: (across, up) =>
    `La correction est active\u202f: les lignes sont dessinées ${across} en largeur et ${up} en hauteur. Imprime encore une fois\u202f: les règles mesurent maintenant 50 mm.`,
  notCorrecting: 'Imprime une feuille à 100\u202f%, puis indique ce que mesurent ses règles.',
  corrected: (across, up) =>
    `Le PDF et le SVG sont corrigés pour ton imprimante (${figure(across)} × ${figure(up)} mm)`,
  frame: 'Pages à imprimer',
  page: (sheet, sheets, width, height) => {
    const size = `${figure(width, 1)} × ${figure(height, 1)} mm`;
    return sheet === null
      ? `Comment le construire, ${size}`
      : `Feuille ${figure(sheet)} sur ${figure(sheets)}, ${size}`;
  },
  allSheets: (sheets) => (sheets === 1 ? 'la seule feuille' : `les ${figure(sheets)} feuilles`),
  someSheets: (chosen, sheets) => `${count(chosen, 'feuille', 'feuilles')} sur ${figure(sheets)}`,
  unreadableRange: 'Écris des nombres, comme 1-3, 5',
  beyondRange: (sheets) => `Il y a les feuilles 1 à ${figure(sheets)}`,
};
