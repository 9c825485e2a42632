/** French phrases for what is told of archives and of glTF, 3MF and Pepakura files. */
import type { FileExcess } from '../../model/model-files.js';
import type { FoldEntryFault, Messages, Table } from '../messages.js';
import { shown } from '../speech.js';
import { all, choose, count, figure, some } from './numbers.js';

/** What is too much of some files, to be read after "il y a". */
export function excess(fault: FileExcess): string {
  return fault.what === 'too-many'
    ? `plus de ${count(fault.most, 'fichier', 'fichiers')}`
    : `${figure(fault.megabytes)} Mo, et on peut en lire ${figure(fault.most)}`;
}

const exportAgain = 'exporte-le à nouveau';
const again = 'récupère le fichier encore une fois, ou exporte-le à nouveau';
const unpack = 'décompresse-la toi-même et choisis le modèle';

function badArchive(params: Messages['bad-archive']): string {
  const file = shown(params.file);
  switch (params.what) {
    case 'damaged':
      return `l’archive '${file}' est abîmée ou incomplète\u202f; télécharge-la à nouveau`;
    case 'bomb':
      return `l’archive '${file}' deviendrait des centaines de fois plus grosse une fois décompressée, ce qu’aucun modèle ne fait\u202f; elle n’a pas été décompressée`;
    case 'locked':
      return `'${shown(params.entry)}' dans l’archive '${file}' est protégé par un mot de passe\u202f; ${unpack}`;
    case 'method':
      return `'${shown(params.entry)}' dans l’archive '${file}' est compressé d’une façon qui n’est pas lue\u202f; ${unpack}`;
    case 'too-many':
    case 'too-large':
      return `l’archive '${file}' est trop grosse\u202f: il y a ${excess(params)}\u202f; décompresse-la et choisis le modèle et ce qui va avec`;
  }
}

/** Ce qui ne va pas dans une entrée d’une liste, à lire après son nom. */
function foldEntry(params: FoldEntryFault): string {
  switch (params.what) {
    case 'number':
      return 'n’est pas un nombre';
    case 'letter':
      return 'n’est aucune des lettres B, M, V et F';
    case 'numbers':
      return `n’est pas une liste de ${figure(params.width)} nombres`;
    case 'list':
      return `n’est pas une liste de ${figure(params.least)} nombres ou plus`;
    case 'index':
      return `est le numéro ${figure(params.index)}, alors qu’il n’y a que ceux de 0 à ${figure(params.count - 1)}`;
    case 'twice':
      return `est la face ${figure(params.index)}, qui est déjà dans un patron`;
  }
}

function badFold(params: Messages['bad-fold']): string {
  const file = shown(params.file);
  const damaged = `'${file}' est abîmé\u202f: `;
  switch (params.what) {
    case 'pattern':
      return `'${file}' n’a qu’un tracé de plis à plat, et le modèle plié manque\u202f; enregistre-le avec sa forme pliée («\u202ffoldedForm\u202f»)`;
    case 'flat':
      return `la forme pliée dans '${file}' est plate, et on ne déplie que des modèles avec une hauteur, une largeur et une profondeur`;
    case 'nothing':
      return `'${file}' est un fichier FOLD sans modèle\u202f: la forme pliée («\u202ffoldedForm\u202f») manque\u202f; ${again}`;
    case 'cut-off':
      return `'${file}' est coupé\u202f: la fin manque\u202f; ${again}`;
    case 'no-object':
      return `'${file}' n’est pas un fichier FOLD, malgré son nom\u202f; ${again}`;
    case 'word':
      return `${damaged}à la ligne ${figure(params.line)}, caractère ${figure(params.character)}, il y a '${shown(params.word)}' à la place d’autre chose\u202f; ${again}`;
    case 'no-frame':
      return `${damaged}la frame ${figure(params.frame)} n’est pas faite de champs\u202f; ${again}`;
    case 'missing':
      return `${damaged}dans la frame ${figure(params.frame)}, '${params.key}' manque\u202f; ${again}`;
    case 'type':
      return `${damaged}dans la frame ${figure(params.frame)}, '${params.key}' contient autre chose que ce qu’il faudrait\u202f; ${again}`;
    case 'times':
      return `${damaged}dans la frame ${figure(params.frame)}, les temps de '${params.key}' ne montent pas de 0 à 1\u202f; ${again}`;
    case 'length':
      return `${damaged}dans la frame ${figure(params.frame)}, '${params.key}' a ${count(params.length, 'entrée', 'entrées')} au lieu de ${figure(params.expected)}\u202f; ${again}`;
    default:
      return `${damaged}dans la frame ${figure(params.frame)}, l’entrée ${figure(params.entry)} de '${params.key}' ${foldEntry(params)}\u202f; ${again}`;
  }
}

function badGltf(params: Messages['bad-gltf']): string {
  const file = shown(params.file);
  switch (params.what) {
    case 'truncated':
      return `'${file}' se termine avant ses données\u202f; ${again}`;
    case 'json':
      return `'${file}' n’a pas de description lisible de sa scène (JSON)\u202f; ${again}`;
    case 'structure':
      return `'${file}' est abîmé\u202f: des éléments renvoient à des données absentes ou impossibles à décoder\u202f; ${again}`;
    case 'cycle':
      return `la scène de '${file}' a des nœuds qui se contiennent les uns les autres sans fin\u202f; ${exportAgain}`;
    case 'version': {
      const version =
        params.version === '' ? 'sans version' : `de version ${shown(params.version)}`;
      return `'${file}' est du glTF ${version}, et c’est la version 2 qui est lue\u202f; ${exportAgain}`;
    }
    case 'extension':
      return `'${file}' enregistre sa forme d’une façon qui n’est pas lue (${shown(params.extension)})\u202f; exporte-le sans cela`;
    case 'short-buffer': {
      const bytes = `${count(params.bytes, 'octet', 'octets')} sur ${figure(params.announced)}`;
      const where =
        params.buffer === ''
          ? `'${file}' n’a`
          : `'${shown(params.buffer)}', dont '${file}' a besoin, n’a`;
      return `${where} que ${bytes} de ses données\u202f; ${again}`;
    }
  }
}

function bad3mf(params: Messages['bad-3mf']): string {
  const file = shown(params.file);
  switch (params.what) {
    case 'no-model':
      return `'${file}' est un paquet 3MF sans modèle dedans\u202f; ${again}`;
    case 'nothing':
      return `'${file}' n’a rien à imprimer\u202f; enregistre à nouveau le projet avec un objet visible dedans`;
    case 'sliced':
      return `'${file}' ne contient qu’une impression déjà tranchée (G-code) et plus de modèle\u202f; enregistre le projet lui-même, pas le fichier tranché`;
    case 'no-part':
      return `'${file}' renvoie à '${shown(params.part)}', qui n’est pas dedans\u202f; ${again}`;
    case 'no-object':
      return `'${file}' renvoie à l’objet ${shown(params.object)} dans '${shown(params.part)}', qui n’y est pas\u202f; ${again}`;
    case 'cycle':
      return `l’objet ${shown(params.object)} dans '${file}' se contient lui-même, ou en contient beaucoup trop d’autres\u202f; exporte le fichier à nouveau`;
    case 'xml':
      return `'${file}' est abîmé\u202f: '${shown(params.part)}' n’est pas du XML à la ligne ${figure(params.line)}\u202f; ${again}`;
    case 'word':
      return `'${file}' est abîmé\u202f: à la ligne ${figure(params.line)} de '${shown(params.part)}', il y a '${shown(params.word)}' là où autre chose est attendu\u202f; ${again}`;
  }
}

function badPdo(params: Messages['bad-pdo']): string {
  const file = shown(params.file);
  switch (params.what) {
    case 'locked':
      return `'${file}' est verrouillé par la personne qui l’a fait\u202f; demande-lui un fichier sans verrou`;
    case 'hidden':
      return `dans '${file}', tous les corps sont désactivés\u202f; actives-en un dans Pepakura Designer et enregistre-le à nouveau`;
    case 'no-faces':
      return `'${file}' est un fichier Pepakura sans aucune face à plier\u202f; ${again}`;
    case 'old':
      return `'${file}' vient du premier Pepakura Designer, et ce sont les fichiers de Pepakura Designer 2 à 6 qui sont lus\u202f; ouvre-le dans l’un d’eux et enregistre-le à nouveau`;
    case 'version':
      return `'${file}' vient d’une version de Pepakura inconnue ici (${figure(params.version)})\u202f; enregistre-le pour Pepakura Designer 2 à 6, ou en OBJ`;
    case 'damaged':
      return `'${file}' est abîmé ou incomplet (octet ${figure(params.at)})\u202f; récupère le fichier encore une fois, ou enregistre-le à nouveau dans Pepakura Designer`;
  }
}

/** Those kinds that there are: "3 animations et 2 caméras". */
function kinds(counts: readonly (readonly [number, string, string])[]): string {
  const found = counts.filter(([number]) => number > 0);
  return all(found.map(([number, one, many]) => count(number, one, many)));
}

function missingLooks({ what, files }: Messages['missing-looks']): string {
  const number = files.length;
  const names = some(files);
  const are =
    what === 'pictures'
      ? `il manque ${choose(number, 'l’image', 'les images')} ${names}`
      : `il manque ${choose(number, 'le fichier', 'les fichiers')} avec les couleurs et les images du modèle, ${names}`;
  const them = what === 'pictures' ? choose(number, 'la', 'les') : choose(number, 'le', 'les');
  return `${are}, alors ces faces restent unies\u202f; choisis-${them} aussi, ou choisis tout le dossier`;
}

function unreadPictures({ files, kinds: found }: Messages['unread-pictures']): string {
  const number = files.length;
  const what =
    found.length > 0
      ? `${choose(number, 'est dans un format qui n’est pas lu', 'sont dans un format qui n’est pas lu')} (${all(found)})`
      : choose(number, 'n’est pas une image lisible', 'ne sont pas des images lisibles');
  const them = choose(number, 'le', 'les');
  return `${some(files)} ${what}\u202f; enregistre-${them} en PNG ou JPEG, et nomme-${them} ainsi dans le modèle`;
}

const lostNets = {
  none: 'le fichier n’apporte pas de patrons à lui',
  simplified: 'les patrons du fichier ne vont pas avec un modèle qui a d’autres triangles',
  repaired: 'les patrons du fichier n’ont pas pu être gardés, car ses faces ont dû être réparées',
  flat: 'les patrons du fichier n’ont pas pu être gardés, car ils traversent des faces planes',
} as const;

function keptNets({ pieces, uncut, size }: Messages['file-nets-kept']): string {
  const words = [
    pieces === 1
      ? 'le patron du fichier a été gardé'
      : `les ${figure(pieces)} patrons du fichier ont été gardés`,
  ];
  if (size === 'file') words.push('à la taille du fichier');
  if (uncut > 0) {
    words.push(
      `mais ${count(uncut, 'coupe dans des faces planes a été laissée', 'coupes dans des faces planes ont été laissées')} de côté`,
    );
  }
  return words.join(', ');
}

export const readerMessages = {
  'bad-3mf': bad3mf,
  'bad-archive': badArchive,
  'bad-fold': badFold,
  'bad-gltf': badGltf,
  'bad-pdo': badPdo,
  'missing-files': ({ file, missing }) =>
    `'${shown(file)}' a besoin de ${some(missing)}, ${choose(missing.length, 'qui manque', 'qui manquent')}\u202f; ` +
    `choisis-${choose(missing.length, 'le', 'les')} aussi, ou choisis tout le dossier`,
  'no-model-in-archive': ({ file, files }) =>
    files.length === 0
      ? `il n’y a rien dans l’archive '${shown(file)}'`
      : `aucun fichier de l’archive '${shown(file)}' n’est un modèle qui peut être lu\u202f; elle contient ${some(files)}`,
  'reader-not-loaded': () =>
    'ce qui lit ce format n’a pas pu être chargé\u202f; vérifie la connexion, et essaie encore une fois',
  'uniter-not-loaded': () =>
    'ce qui réunit les corps n’a pas pu être chargé\u202f; vérifie la connexion et réessaie',
  'too-many-triangles': ({ most }) =>
    `le modèle a plus de ${figure(most)} triangles, et c’est plus qu’on ne peut en lire\u202f; ` +
    'simplifie-le dans le programme qui l’a fait',

  'broken-faces': ({ count: number }) =>
    `${count(
      number,
      'face laissée de côté\u202f: il lui manque des coins, ou elle nomme',
      'faces laissées de côté\u202f: il leur manque des coins, ou elles nomment',
    )} des sommets qui ne sont pas dans le fichier`,
  'damaged-extras': () =>
    'après sa forme, le fichier est abîmé\u202f: des couleurs, des images et les patrons du fichier sont perdus\u202f; enregistre-le à nouveau dans Pepakura Designer',
  'damaged-looks': () =>
    `les couleurs et les images du fichier sont abîmées\u202f: seule sa forme a été lue\u202f; ${exportAgain}`,
  'large-pictures': ({ files, most, most_mb, most_pixels }) =>
    `${some(files)} ${choose(files.length, 'a été laissé', 'ont été laissés')} de côté\u202f: on peut utiliser jusqu’à ${figure(most)} images de ` +
    `${figure(most_mb)} Mo en tout, chacune de ${figure(most_pixels / 1e6, 0)} millions de pixels au maximum\u202f; ` +
    `réduis-${choose(files.length, 'le', 'les')} dans un programme de retouche d’images`,
  'lost-looks': ({ count: number }) =>
    `${count(number, 'couleur ou image', 'couleurs ou images')} que le modèle utilise ${choose(number, 'n’est', 'ne sont')} ` +
    `pas dans le fichier, alors ces faces restent blanches\u202f; ${exportAgain}`,
  'missing-looks': missingLooks,
  'picture-guessed': ({ file }) =>
    `le modèle ne nomme aucune image, alors ${shown(file)} a été posé dessus, la seule à côté de lui`,
  'simplified-looks': () =>
    'là où le fichier superpose ou mélange des couleurs ou des images, on prend l’image du dessus, ' +
    'ou sinon la couleur principale',
  'unknown-materials': ({ names }) =>
    `${choose(names.length, 'le matériau', 'les matériaux')} ${some(names)} du modèle ${choose(names.length, 'n’est', 'ne sont')} ` +
    'dans aucun de ses fichiers MTL, alors ce qui en est fait reste blanc',
  'unread-libraries': ({ files }) =>
    `${some(files)}, ${choose(files.length, 'qui devrait', 'qui devraient')} décrire les couleurs et les images du modèle, ` +
    `${choose(files.length, 'est abîmé ou n’est pas un fichier MTL', 'sont abîmés ou ne sont pas des fichiers MTL')}\u202f; exporte le modèle à nouveau`,
  'unread-pictures': unreadPictures,

  'archive-choice': ({ file, others }) =>
    `l’archive a ${figure(others.length + 1)} modèles\u202f; '${shown(file)}' a été pris, et pas ${some(others)}`,
  'not-for-printing': ({ supports, modifiers, negatives, unprinted }) =>
    `laissé de côté, car le fichier dit que ce n’est pas imprimé\u202f: ${kinds([
      [supports, 'support', 'supports'],
      [modifiers, 'modificateur', 'modificateurs'],
      [negatives, 'élément en négatif', 'éléments en négatif'],
      [unprinted, 'objet désactivé', 'objets désactivés'],
    ])}`,
  'file-nets-kept': keptNets,
  'file-nets-lost': ({ what }) => `${lostNets[what]}, alors de nouveaux ont été faits`,
  'file-nets-unused': ({ pieces }) =>
    `le fichier apporte ${choose(pieces, 'son propre patron', `${figure(pieces)} patrons à lui`)}\u202f; de nouveaux ont été faits\u202f; pour ${choose(pieces, 'le', 'les')} garder, fais ce choix quand tu regardes le modèle (--nets file)`,
  'fold-nets-unused': ({ pieces }) =>
    `le fichier apporte ${choose(pieces, 'son propre patron, qui n’a pas servi', `${figure(pieces)} patrons à lui, qui n’ont pas servi`)}\u202f: son modèle plié a été déplié à nouveau`,
  'parts-unused': ({ parts }) =>
    `${count(parts, 'partie', 'parties')} ${parts > 1 ? 'étaient demandées' : 'était demandée'}, mais les patrons du fichier ont les leurs, qui ont été gardées`,
  'pdo-unused': ({ hidden, texts, images }) =>
    `non utilisé\u202f: ${kinds([
      [hidden, 'corps désactivé', 'corps désactivés'],
      [texts, 'texte sur les feuilles', 'textes sur les feuilles'],
      [images, 'image sur les feuilles', 'images sur les feuilles'],
    ])}`,
  'posed-skins': ({ count: number }) =>
    `${count(number, 'maillage avec squelette est', 'maillages avec squelette sont')} dans la pose du début du fichier`,
  'unknown-extensions': ({ names }) =>
    `le fichier utilise ${some(names)}, ${choose(names.length, 'qui est inconnu', 'qui sont inconnus')} ici\u202f; quelque chose peut manquer ou avoir l’air différent`,
  'unused-content': ({ animations, morphs, uvs, cameras, instances }) =>
    `non utilisé\u202f: ${kinds([
      [animations, 'animation', 'animations'],
      [morphs, 'déformation', 'déformations'],
      [uvs, 'deuxième jeu de coordonnées d’image', 'deuxièmes jeux de coordonnées d’image'],
      [cameras, 'caméra', 'caméras'],
      [instances, 'groupe de copies', 'groupes de copies'],
    ])}`,
} satisfies Partial<Table>;
