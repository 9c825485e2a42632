/** A French phrase for every message, which may be part of a line. */
import type { Messages, Table } from '../messages.js';
import { fileMessages } from './files.js';
import { all, choose, count, figure, fixed, parts, pieces, quoted, some } from './numbers.js';
import { optionFault } from './options.js';
import { paperMessages } from './paper.js';
import { projectMessages } from './projects.js';
import { readerMessages } from './readers.js';
import { repairMessages } from './repair.js';

const simplify = 'simplifie le modèle à moins de faces';

/** What a stage does, to be read after "pendant" or "pour", and what helps where memory ends in it. */
const stages = {
  read: [
    'la lecture et la réparation du modèle',
    'simplifie le modèle dans le programme qui l’a fait',
  ],
  learn: ['l’apprentissage par dépliages', simplify],
  cluster: ['la découpe du modèle en parties', simplify],
  search: ['la recherche de patrons', simplify],
  compact: ['l’ajout de place pour les languettes', simplify],
  paper: [
    'le placement des pièces sur les feuilles',
    'choisis une taille plus petite, du papier plus petit ou moins de faces',
  ],
} as const;

const units = {
  mm: 'des millimètres',
  cm: 'des centimètres',
  m: 'des mètres',
  in: 'des pouces',
} as const;
const lengths = { height: 'hauteur', width: 'largeur', depth: 'profondeur' } as const;
const faces = (number: number): string => count(number, 'face', 'faces');

function badEdit(params: Messages['bad-edit']): string {
  switch (params.what) {
    case 'no-part-named':
      return 'une modification doit nommer une partie';
    case 'no-part':
      return `il n’y a pas de partie ${figure(params.part)}\u202f: le modèle a ${count(params.parts, 'partie', 'parties')}`;
    case 'twice':
      return `la partie ${figure(params.part)} est nommée deux fois\u202f: une seule modification à la fois pour chaque partie`;
    case 'apart':
      return `${parts(params.parts)} ne se touchent pas, elles ne peuvent donc pas en devenir une seule`;
    case 'into':
      return (
        `impossible de faire ${count(params.into, 'partie', 'parties')} avec ${parts(params.parts)}\u202f: ` +
        `il peut y en avoir de 1 à ${figure(params.most)}, une par face plane`
      );
  }
}

function badOption(params: Messages['bad-option']): string {
  switch (params.what) {
    case 'height':
    case 'width':
    case 'depth':
      return `la ${lengths[params.what]} doit être supérieure à 0 et ne pas dépasser ${figure(params.most)} mm`;
    case 'scale':
      return `le facteur doit être supérieur à 0 et ne pas dépasser ${figure(params.most)}`;
    case 'paper':
      return `le papier doit mesurer entre 0 et ${figure(params.most)} mm`;
    case 'pin-sheet':
      return `la feuille d’une pièce fixée doit être l’une des ${figure(params.most)} premières`;
    case 'parts':
      return `le nombre de parties doit être auto ou au moins ${figure(params.least)}`;
    case 'proxy':
      return `proxy doit être ${figure(params.least)} ou plus`;
    case 'faces':
      return `le nombre de faces doit être au moins ${figure(params.least)}`;
    case 'margin':
      return `la marge doit être de ${figure(params.least)} mm ou plus, et de moins que la moitié du petit côté du papier`;
    case 'sheets':
      return `le nombre de feuilles doit être un nombre entier de ${figure(params.least)} à ${figure(params.most)}`;
    case 'flaps':
    case 'flap-height':
      return `la hauteur d’une languette doit être de ${figure(params.least)} à ${figure(params.most)} mm`;
    case 'flap-angle':
      return `l’angle des languettes doit être de ${figure(params.least)} à ${figure(params.most)} degrés`;
    case 'runs':
    case 'clearance':
    case 'fill-holes':
      return `${params.what} doit être de ${figure(params.least)} à ${figure(params.most)}`;
    case 'repair':
      return `'${params.step}' est une étape de la réparation qui ne peut pas être désactivée`;
    case 'names-of-part':
      return 'chaque partie peut avoir un nom au maximum';
    case 'pin-piece':
      return 'une pièce fixée doit être nommée par sa partie et une face de celle-ci';
    case 'pin-place':
      return 'la place d’une pièce fixée doit être un nombre fini';
    case 'name-control':
      return 'le nom d’une partie ne doit pas contenir de caractères de contrôle';
    case 'name-colon':
      return 'le nom d’une partie ne doit pas contenir de deux-points, car ils sont placés devant le numéro d’une arête';
    case 'name-length':
      return 'le nom d’une partie doit avoir de 1 à 16 caractères, sans espace au début ni à la fin';
    case 'name-number':
      return 'le nom d’une partie ne doit pas être un nombre\u202f: les nombres désignent des arêtes';
    case 'same-name':
      return `deux parties ne peuvent pas avoir le même nom, ${quoted(params.name)}`;
    case 'flap-edge':
      return `une languette est choisie pour l’arête du sommet ${figure(params.from)} au sommet ${figure(params.to)}, que le modèle n’a pas`;
    case 'unreadable':
    case 'written':
      return params.detail;
    default:
      return optionFault(params);
  }
}

function faceTooLarge(params: Messages['face-too-large']): string {
  const { face_width_mm, face_height_mm, width_mm, height_mm, share } = params;
  const paper = fixed(Math.ceil(10 / share) / 10, 1);
  return (
    `à cette taille, une face plane de ${figure(face_width_mm, 0)} x ${figure(face_height_mm, 0)} mm est plus grande qu’une feuille de ` +
    `${figure(width_mm, 3)} x ${figure(height_mm, 3)} mm\u202f: elle tiendrait à ${Math.floor(100 * share)}\u202f% de la taille, ` +
    `ou sur du papier ${paper} fois plus grand`
  );
}

function locked(params: Messages['locked']): string {
  switch (params.what) {
    case 'fold':
      return 'cette arête est verrouillée\u202f: elle n’est jamais coupée';
    case 'cut':
      return 'cette arête est verrouillée\u202f: elle est toujours coupée';
    case 'faces':
      return 'un pli verrouillé tient les faces à leur place';
    case 'loop':
      return 'la boucle ne peut pas s’ouvrir ailleurs\u202f: ses plis sont verrouillés';
    case 'parts':
      return `des plis verrouillés tiennent les faces ensemble\u202f: impossible d’en faire ${count(params.parts, 'partie', 'parties')}`;
  }
}

/** A time that is only estimated; nothing of one that nobody would mind. */
function roughTime(seconds: number): string {
  if (seconds < 12) return '';
  const time =
    seconds < 90
      ? `${Math.round(seconds / 5) * 5} secondes`
      : `${Math.round(seconds / 60)} minutes`;
  return `leurs patrons prennent environ ${time}, et `;
}

function partsRaised(params: Messages['parts-raised']): string {
  if (params.what === 'bodies') {
    const bodies = count(params.bodies, 'corps séparé', 'corps séparés');
    return `le modèle a ${bodies}, il lui faut donc au moins autant de parties`;
  }
  return (
    `en ${count(params.parts, 'partie', 'parties')}, il donnerait ${count(params.pieces, 'pièce', 'pièces')}, il a donc été découpé en ` +
    `${count(params.instead, 'partie', 'parties')} à la place, chacune en une pièce`
  );
}

function uncheckedPieces({ what, pieces: names }: Messages['unchecked-pieces']): string {
  const help = 'plus de parties, ou moins de faces, aideraient';
  if (what === 'large') {
    return `tourner tous les plis de façon égale ne suffit pas à plier ${pieces(names)}, et avec autant de faces on n’a pas cherché d’autre façon\u202f; ${help}`;
  }
  const reasons = {
    off: 'cette recherche est désactivée',
    cancelled: 'le calcul a été abandonné avant',
    kept: 'le résultat d’avant, qui est gardé, n’en avait pas',
    huge: `autant de faces prennent trop de temps\u202f; ${help}`,
  };
  return `on n’a pas cherché de façon de plier ${pieces(names)}\u202f: ${reasons[what]}`;
}

export const messages: Table = {
  ...fileMessages,
  ...repairMessages,
  ...paperMessages,
  ...projectMessages,
  ...readerMessages,

  'bad-edit': badEdit,
  'bad-margin': () =>
    'les marges ne laissent rien de la feuille\u202f: le papier et la marge ne vont pas ensemble',
  'bad-option': badOption,
  'bad-pin': (params) =>
    params.what === 'outside'
      ? `la pièce ${params.piece} est fixée en partie hors de la zone imprimable de la feuille ${figure(params.sheet)}`
      : `les pièces ${params.pieces.join(' et ')} sont fixées l’une sur l’autre sur la feuille ${figure(params.sheet)}`,
  'bad-start': () => 'le résultat d’avant ne va pas avec ce modèle',
  'face-too-large': faceTooLarge,
  internal: ({ what, detail }) => `erreur interne pendant ${stages[what][0]}\u202f: ${detail}`,
  'no-depth': () => 'le modèle n’a pas de profondeur à agrandir ou à réduire',
  'no-height': () => 'le modèle n’a pas de hauteur à agrandir ou à réduire',
  'no-width': () => 'le modèle n’a pas de largeur à agrandir ou à réduire',
  'out-of-memory': ({ what }) =>
    what === 'file'
      ? 'il n’y a pas assez de mémoire pour le fichier du modèle'
      : `il n’y a pas assez de mémoire pour ${stages[what].join('\u202f: ')}`,
  'too-many-faces': ({ faces: number, most, proposed }) =>
    `le modèle a ${count(number, 'face plane', 'faces planes')}, et des patrons de plus de ${figure(most)} prendraient des heures et seraient bien trop petits pour être pliés\u202f: --faces ${proposed} donne un modèle plus simple qu’on peut plier`,
  'too-few-sheets': () => 'les pièces ne tiennent à aucune taille sur si peu de feuilles',

  'edit-place-gone': ({ what }) =>
    ({
      edge: 'il n’y a plus d’arête comme celle-là à cet endroit',
      faces: 'il n’y a plus de faces comme celles-là à cet endroit',
      part: 'il n’y a plus de partie comme celle-là à cet endroit',
      piece: 'il n’y a plus de pièce comme celle-là à cet endroit',
    })[what],
  'already-cut': () => 'cette arête est déjà coupée',
  'already-joined': () => 'cette arête est déjà un pli',
  locked,
  'inside-panel': () => 'cette arête est à l’intérieur d’une face plane, qui reste entière',
  'no-edge': ({ from, to }) =>
    `le modèle n’a pas d’arête entre les sommets ${figure(from)} et ${figure(to)}`,
  'no-face': (params) =>
    params.what === 'none'
      ? 'aucune face n’a été nommée'
      : `le modèle a les faces de 0 à ${figure(params.most)}`,
  'no-net': () => 'une face voisine de cette arête n’a pas encore de patron',
  'no-part': ({ part, parts: number }) =>
    `il n’y a pas de partie ${figure(part)}\u202f: le modèle en a ${figure(number)}`,
  'not-in-loop': () => 'couper là n’ouvrirait pas la boucle',
  'not-touching': () => 'les faces ne touchent pas cette partie',
  overlap: ({ what }) =>
    what === 'pieces'
      ? 'les deux pièces se chevaucheraient là'
      : 'des faces de la pièce se chevaucheraient, où qu’elle s’ouvre à la place',
  'would-fall-apart': ({ what, part }) =>
    `sans ${what === 'fold' ? 'ce pli' : 'ces faces'}, la partie ${figure(part)} tomberait en morceaux`,

  'files-ignored': ({ files }) =>
    `${count(files.length, 'autre fichier n’a pas servi', 'autres fichiers n’ont pas servi')}\u202f: ${some(files)}`,
  'faces-above-wish': ({ faces: number }) =>
    `la simplification s’est arrêtée à ${faces(number)}\u202f: moins que cela déchirerait la surface`,
  joints: ({ what, count: number }) =>
    count(
      number,
      'arête est collée sur des faces qu’elle ne prolonge pas',
      'arêtes sont collées sur des faces qu’elles ne prolongent pas',
    ) + (what === 'numbered' ? '\u202f: cherche là le même numéro' : ''),
  'joints-lost': ({ count: number }) =>
    `${count(number, 'arête posée sur d’autres faces s’est détachée', 'arêtes posées sur d’autres faces se sont détachées')} quand le modèle a été simplifié\u202f: colle à vue d’œil`,
  'large-model': ({ faces: number, seconds, proposed }) =>
    `le modèle a ${faces(number)}\u202f: ${roughTime(seconds)}la plupart des faces seront trop petites ` +
    `pour être pliées\u202f; les modèles en papier en ont quelques centaines (--faces ${proposed} donne un modèle plus simple)`,
  'colour-numbers': () =>
    'le fichier donne à ses faces des numéros au lieu de couleurs, et ne dit pas quelles couleurs ce sont\u202f: elles ne sont pas imprimées',
  'meets-itself': ({ part }) =>
    `la partie ${figure(part)} a des faces qui se traversent dans le modèle, on ne peut donc pas la plier sans collisions`,
  'no-motion': ({ part }) =>
    `on n’a trouvé aucune façon de plier la partie ${figure(part)} d’un seul coup sans que des faces se heurtent`,
  'part-split': ({ what, part, pieces: number }) =>
    `la partie ${figure(part)} ${what === 'no-motion' ? 'ne se plie pas' : 'n’a pas de patron'} en une seule pièce et est devenue ` +
    count(number, 'pièce', 'pièces'),
  'parts-lowered': ({ panels }) =>
    `le modèle n’a que ${count(panels, 'face plane', 'faces planes')}, il ne peut donc pas avoir plus de parties`,
  'parts-raised': partsRaised,
  'pin-lost': ({ count: number }) =>
    count(
      number,
      'pièce fixée n’est plus là comme avant et a été placée à nouveau',
      'pièces fixées ne sont plus là comme avant et ont été placées à nouveau',
    ),
  'small-bodies': ({ count: number, limit_mm }) =>
    `${figure(number)} corps du modèle ${choose(number, 'fait', 'font')} moins de ${figure(limit_mm)} mm et ` +
    `${choose(number, 'a été laissé', 'ont été laissés')} de côté`,
  'smaller-saves-sheets': ({ what, size_mm, instead_mm, sheets, of }) =>
    `avec une ${lengths[what]} de ${figure(size_mm)} mm au lieu de ${figure(Math.round(instead_mm))}, il devrait tenir sur ` +
    `${count(sheets, 'feuille', 'feuilles')} au lieu de ${figure(of)}`,
  'sheet-split': ({ part, pieces: number }) =>
    `la partie ${figure(part)} est trop grande pour la feuille et a été coupée en ${count(number, 'pièce', 'pièces')}`,
  'run-stopped': () =>
    'la recherche a été arrêtée avant la fin, et voici ce qui était déjà trouvé\u202f; redéplie pour qu’elle aille au bout',
  'unchecked-pieces': uncheckedPieces,
  'unit-guessed': ({ unit }) =>
    `l’unité du modèle n’est pas connue\u202f; on a supposé ${units[unit]}`,
  'up-guessed': () =>
    'le fichier ne dit pas où est le haut\u202f; on a pris l’axe z, comme dans la plupart des fichiers de ce format',
  'weak-necks': ({ pieces: names }) =>
    'des plis de moins de 5 mm tiennent beaucoup de faces des deux côtés et peuvent se déchirer\u202f: renforce-les au dos avec de l’adhésif\u202f; ' +
    pieces(names),

  'engine-died': ({ reason, times }) =>
    times === undefined
      ? `Le moteur de calcul s’est arrêté de façon inattendue\u202f: ${reason}`
      : `Le moteur de calcul s’est arrêté ${figure(times)} fois de façon inattendue sur la même tâche\u202f: ${reason}`,
  overtaken: () => 'entre-temps, une autre étape a été annulée ou refaite',
  'no-piece': ({ piece, pieces: number }) =>
    `il n’y a pas de pièce ${figure(piece)}\u202f: il y en a ${figure(number)}`,
  'not-pinned': ({ piece }) => `la pièce ${figure(piece)} n’est pas fixée`,
  'not-together': () =>
    'seules les modifications de languettes, ou celles qui divisent et réunissent des parties, peuvent se faire d’un seul coup',
  'no-legend': () => 'aucune feuille n’a de place pour la légende',
  'beyond-page': ({ by_mm, margin_mm }) =>
    `avec la correction pour cette imprimante, des lignes dépassent le bord de la page de ${fixed(by_mm, 1)} mm\u202f; avec une marge de ${figure(margin_mm)} mm (--margin ${margin_mm}), elles y restent`,
  'missing-glyphs': ({ letters }) =>
    `aucune police n’a ${letters.join(' ')}\u202f: un carré est imprimé à la place`,
  'fonts-not-loaded': () =>
    'les polices de certaines lettres n’ont pas pu être chargées\u202f: ces lettres ont l’aspect que leur donnent les polices du lecteur',
  'marks-not-free': ({ pieces: names, margin_mm }) =>
    'la machine cherche ses repères là où quelque chose est coupé\u202f: ' +
    `une marge de ${figure(margin_mm)} mm les garde libres\u202f; ${pieces(names)}`,
  'cricut-area': ({ sheets, width_mm, height_mm, margin_mm }) =>
    `Cricut imprime puis découpe au plus ${Math.floor(width_mm)} x ${Math.floor(height_mm)} mm de ce papier, et ` +
    `${choose(sheets.length, 'la feuille', 'les feuilles')} ${all(sheets.map((sheet) => figure(sheet)))} en ` +
    `${choose(sheets.length, 'demande', 'demandent')} plus\u202f: découpe sans imprimer, ou choisis une marge de ${figure(margin_mm)} mm`,
};
