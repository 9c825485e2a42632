/** What is said in French while a model is unfolded, and of what comes of it. */
import type { Words } from '../words.js';
import { choose, count, figure, fixed, quoted } from './numbers.js';

const parts = (number: number): string => count(number, 'partie', 'parties');
const pieces = (number: number): string => count(number, 'pièce', 'pièces');
const seams = (number: number): string => count(number, 'couture', 'coutures');
const overlaps = (number: number): string => count(number, 'chevauchement', 'chevauchements');
/** "sur 3 feuilles A4" */
const onSheets = (number: number, paper: string): string =>
  `sur ${count(number, 'feuille', 'feuilles')} ${paper}`;

export const run: Words['run'] = {
  stages: {
    read: 'Lecture du modèle',
    learn: 'Apprentissage\u202f: quelles faces se déplient bien ensemble',
    cluster: 'Choix des parties',
    search: 'Mise à plat des parties',
    compact: 'Place pour les languettes',
    paper: 'Placement des pièces sur les feuilles',
  },
  stageLines: {
    read: 'lecture du modèle',
    learn: 'apprentissage par dépliages',
    cluster: 'découpe en parties',
    search: 'recherche de patrons',
    compact: 'place pour les languettes',
    paper: 'placement sur les feuilles',
  },
  detailed: (stage, detail) => `${stage}\u202f: ${detail}`,
  learned: (runs, of) => `${count(runs, 'dépliage essayé', 'dépliages essayés')} sur ${figure(of)}`,
  partsDone: (done, all) => `${count(done, 'partie finie', 'parties finies')} sur ${figure(all)}`,
  overlapsLeft: (number) => `encore ${overlaps(number)}`,
  minutesLeft: (minutes) => `encore environ ${count(minutes, 'minute', 'minutes')}`,
  secondsLeft: (seconds) => `encore environ ${count(seconds, 'seconde', 'secondes')}`,
  goingBack: 'Retour en arrière.',
  stopping: 'Les pièces finies sont posées sur des feuilles.',

  done: (lead) => `Fini\u202f: ${lead}`,
  stopped: (lead) => `Arrêté. ${lead}`,
  undone: (lead) => `Annulé\u202f: ${lead}`,
  madeAgain: (lead) => `Rétabli\u202f: ${lead}`,
  hold: (why) => `Regarde le modèle. ${why}`,
  named: (name) => `S’appelle maintenant ${name}.`,
  nameGone: 'Le nom est enlevé.',
  editCancelled: 'Abandonné. Tout est comme avant.',
  unfoldAgain: 'Redéplier',

  farewells: { cancelled: 'Abandonné.', empty: 'Arrêté.' },
  notes: {
    cancelled: 'Abandonné. On en était là\u202f; rien n’en est gardé.',
    empty: 'Arrêté. On en était là.',
    failed: 'On en était là.',
    undrawn: 'Les patrons ont été trouvés, mais pas dessinés.',
  },
  nextSteps: {
    file: 'Choisis un autre modèle, ou répare celui-ci et réessaie.',
    job: 'Change les réglages et réessaie, ou choisis un autre modèle.',
    crash:
      'Rien d’autre n’est perdu, et le prochain essai repart de zéro. Un modèle plus petit peut marcher.',
  },
  nothingToUse: [
    'Il n’y a encore rien à garder',
    'Quand la recherche a été arrêtée, aucune partie n’avait de patron\u202f: le dernier était justement en train de changer. Laisse-la durer un peu plus la prochaine fois.',
  ],
  notUnfolded: (model) => `Impossible de déplier ${quoted(model)}`,
  stillThere: (model) => `En dessous, tu vois encore le résultat de ${quoted(model)}.`,
  notDrawn: (model) => `Impossible de dessiner les feuilles de ${quoted(model)}`,
  notWritten: (format) => `Impossible d’écrire le fichier ${format}`,
  projectNotWritten: 'Impossible d’écrire le fichier du projet',
  resultIsHere: 'Le résultat est toujours là.',
  notPrinted: 'Impossible d’imprimer les pages',
  onceMore: 'Essaie encore une fois.',
  nothingChanged: 'Rien n’a été modifié',
  nothingUnfolded: 'Rien n’a été déplié',
  noBrowser: 'Foldwright ne marche pas dans ce navigateur',
  browserLacks:
    'Il manque à ce navigateur les workers de modules ou WebAssembly avec SIMD et exceptions, dont le dépliage ' +
    'a besoin. Chrome et Edge les ont depuis la version 95, Firefox depuis la 114, Safari depuis la 16.4.',
};

export const result: Words['result'] = {
  onePiece: (sheets, paper) => `Tout en une seule pièce, ${onSheets(sheets, paper)}.`,
  eachInOne: (all, sheets, paper) =>
    `${parts(all)}, ${choose(all, 'en une seule pièce', 'chacune en une pièce')}, ${onSheets(sheets, paper)}.`,
  inPieces: (all, number, sheets, paper) =>
    `${parts(all)} en ${pieces(number)} ${onSheets(sheets, paper)}.`,
  withHoles: (p) => {
    const whole =
      p.finished === 0
        ? `Aucune partie sur ${figure(p.parts)} n’est entière`
        : `Seulement ${parts(p.finished)} sur ${figure(p.parts)} ${choose(p.finished, 'est entière', 'sont entières')}`;
    const missing = p.parts - p.finished;
    const others =
      missing === 1 ? 'L’autre partie manque' : `Les ${figure(missing)} autres parties manquent`;
    return (
      `${whole}\u202f: ${pieces(p.pieces)} ${onSheets(p.sheets, p.paper)}. ` +
      `${others}, alors le modèle aura des trous. Déplie-le encore une fois pour les avoir toutes.`
    );
  },
  facts: {
    pieces: 'Pièces',
    sheets: 'Feuilles',
    size: 'Taille finie',
    smallest: 'Plus petite pièce',
    glue: 'À coller',
    flaps: 'Languettes',
    numbers: 'Numéros',
    scale: 'Échelle',
    paper: 'Papier utilisé',
    triangles: 'Triangles',
    time: 'Calculé en',
  },
  none: 'rien',
  smallest: (name, width, height) => `${name}, ${figure(width)} × ${figure(height)} mm`,
  glue: (metres, number) => `${fixed(metres, 1)} m sur ${seams(number)}`,
  flaps: (p) => {
    const words: string[] = [];
    if (p.wanted > 0) words.push(`pour ${seams(p.flaps)} sur ${figure(p.wanted)}`);
    if (p.shrunk > 0)
      words.push(`dont ${count(p.shrunk, 'languette étroite', 'languettes étroites')}`);
    if (p.strips > 0) words.push(count(p.strips, 'bande séparée', 'bandes séparées'));
    if (p.taped > 0) words.push(`${seams(p.taped)} à l’adhésif`);
    return words.join(', ');
  },
  numbers: (printed, all) => `pour ${seams(printed)} sur ${figure(all)}`,
  scale: (mm) => `1 unité fait ${figure(mm)} mm`,
  percent: (percent) => `${figure(percent)}\u202f%`,
  seconds: (seconds, digits) => `${fixed(seconds, digits)} s`,
  minutes: (minutes, seconds) => `${figure(minutes)} min ${figure(seconds)} s`,
  repaired: 'Réparé avant de déplier',
  worthKnowing: 'Bon à savoir',
  sheet: (sheet, of) => `Feuille ${figure(sheet)} sur ${figure(of)}`,
  caption: (sheet, of, names) =>
    `Feuille ${figure(sheet)} sur ${figure(of)}\u202f: ${choose(names.length, 'pièce', 'pièces')} ${names.join(', ')}`,
  forModel: (percent) => `${figure(percent)}\u202f% pour le modèle`,
};

export const pictures: Words['pictures'] = {
  matrixToCome: 'chaque paire de faces est un point',
  nothingLearned: 'pour ces parties, il n’y avait rien à apprendre',
  blocks: 'chaque cadre est une partie',
  darker: 'plus foncé\u202f: plus souvent ensemble',
  netToCome: 'vient quand les parties sont choisies',
  netBegins: 'commence tout de suite',
  generation: (part, generation, number) =>
    `partie ${figure(part)}, génération ${figure(generation)}\u202f: ${overlaps(number)}`,
  netDone: (part) => `partie ${figure(part)}, sans chevauchements`,
  couldBePrinted: (sheets) =>
    `${sheets === 1 ? 'cette feuille peut déjà être imprimée' : `ces ${count(sheets, 'feuille', 'feuilles')} peuvent déjà être imprimées`}\u202f; les patrons deviennent encore plus faciles à monter`,
  netsToCome: 'chacun arrive ici dès qu’il tient à plat',
  netsFound: (nets) =>
    `${count(nets, 'patron trouvé', 'patrons trouvés')} jusqu’ici\u202f; les lettres et les feuilles viennent à la fin`,
  noWebGl: 'Ce navigateur n’affiche pas de vue 3D, car il n’a pas WebGL 2. Tout le reste marche.',
  broken: 'La vue 3D ne marche pas ici. Tout le reste, si.',
};
