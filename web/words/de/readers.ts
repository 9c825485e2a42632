/** German phrases for what is told of archives and of glTF, 3MF and Pepakura files. */
import type { FileExcess } from '../../model/model-files.js';
import type { FoldEntryFault, Messages, Table } from '../messages.js';
import { shown } from '../speech.js';
import { all, choose, count, figure, some } from './numbers.js';

/** What is too much of some files, to be read after "hat". */
export function excess(fault: FileExcess): string {
  return fault.what === 'too-many'
    ? `mehr als ${figure(fault.most)} Dateien`
    : `${figure(fault.megabytes)} MB, und ${figure(fault.most)} MB lassen sich lesen`;
}

const again = 'hol die Datei noch einmal, oder exportiere sie neu';
const exportAgain = 'exportiere sie neu';

function badArchive(params: Messages['bad-archive']): string {
  const file = shown(params.file);
  switch (params.what) {
    case 'damaged':
      return `das Archiv '${file}' ist beschädigt oder abgeschnitten; lade es noch einmal herunter`;
    case 'bomb':
      return `das Archiv '${file}' würde auf das Hundertfache seiner Größe wachsen, wie kein Modell es tut; es wurde nicht entpackt`;
    case 'locked':
      return `'${shown(params.entry)}' im Archiv '${file}' ist durch ein Passwort gesperrt; entpacke es selbst und wähle das Modell`;
    case 'method':
      return `'${shown(params.entry)}' im Archiv '${file}' ist auf eine Art gepackt, die nicht gelesen wird; entpacke es selbst und wähle das Modell`;
    case 'too-many':
    case 'too-large':
      return `das Archiv '${file}' ist zu groß: Es hat ${excess(params)}; entpacke es und wähle das Modell und was dazugehört`;
  }
}

/** Was an einem Eintrag einer Liste falsch ist, nach seinem Namen zu lesen. */
function foldEntry(params: FoldEntryFault): string {
  switch (params.what) {
    case 'number':
      return 'ist keine Zahl';
    case 'letter':
      return 'ist keiner der Buchstaben B, M, V und F';
    case 'numbers':
      return `ist keine Liste von ${figure(params.width)} Zahlen`;
    case 'list':
      return `ist keine Liste von mindestens ${figure(params.least)} Zahlen`;
    case 'index':
      return `ist die Nummer ${figure(params.index)}, obwohl es nur 0 bis ${figure(params.count - 1)} gibt`;
    case 'twice':
      return `ist die Fläche ${figure(params.index)}, die schon in einem Netz ist`;
  }
}

function badFold(params: Messages['bad-fold']): string {
  const file = shown(params.file);
  const damaged = `'${file}' ist beschädigt: `;
  switch (params.what) {
    case 'pattern':
      return `in '${file}' ist nur ein flaches Faltmuster, und das gefaltete Modell fehlt; speichere es mit seiner gefalteten Form („foldedForm“)`;
    case 'flat':
      return `die gefaltete Form in '${file}' ist flach, und nur Modelle mit Höhe, Breite und Tiefe lassen sich abwickeln`;
    case 'nothing':
      return `'${file}' ist eine FOLD-Datei ohne Modell: Die gefaltete Form („foldedForm“) fehlt; ${again}`;
    case 'cut-off':
      return `'${file}' ist abgeschnitten: Das Ende fehlt; ${again}`;
    case 'no-object':
      return `'${file}' ist keine FOLD-Datei, auch wenn sie so heißt; ${again}`;
    case 'word':
      return `${damaged}In Zeile ${figure(params.line)}, Zeichen ${figure(params.character)}, steht '${shown(params.word)}', wo etwas anderes stehen müsste; ${again}`;
    case 'no-frame':
      return `${damaged}Frame ${figure(params.frame)} besteht nicht aus Feldern; ${again}`;
    case 'missing':
      return `${damaged}In Frame ${figure(params.frame)} fehlt '${params.key}'; ${again}`;
    case 'type':
      return `${damaged}In Frame ${figure(params.frame)} steht in '${params.key}' etwas anderes, als dort hingehört; ${again}`;
    case 'times':
      return `${damaged}In Frame ${figure(params.frame)} steigen die Zeiten in '${params.key}' nicht von 0 bis 1; ${again}`;
    case 'length':
      return `${damaged}In Frame ${figure(params.frame)} hat '${params.key}' ${count(params.length, 'Eintrag', 'Einträge')} statt ${figure(params.expected)}; ${again}`;
    default:
      return `${damaged}In Frame ${figure(params.frame)} gilt für Eintrag ${figure(params.entry)} von '${params.key}': Er ${foldEntry(params)}; ${again}`;
  }
}

function badGltf(params: Messages['bad-gltf']): string {
  const file = shown(params.file);
  switch (params.what) {
    case 'truncated':
      return `'${file}' endet vor seinen Daten; ${again}`;
    case 'json':
      return `'${file}' hat keine lesbare Beschreibung seiner Szene (JSON); ${again}`;
    case 'structure':
      return `'${file}' ist beschädigt: Stücke der Datei verweisen auf Daten, die fehlen oder sich nicht entschlüsseln lassen; ${again}`;
    case 'cycle':
      return `die Szene von '${file}' hat Knoten, die einander ohne Ende enthalten; ${exportAgain}`;
    case 'version': {
      const version =
        params.version === '' ? 'ohne Version' : `der Version ${shown(params.version)}`;
      return `'${file}' ist glTF ${version}, und Version 2 wird gelesen; ${exportAgain}`;
    }
    case 'extension':
      return `'${file}' speichert seine Form auf eine Art, die nicht gelesen wird (${shown(params.extension)}); exportiere es ohne sie`;
    case 'short-buffer': {
      const bytes = `${figure(params.bytes)} von ${figure(params.announced)} Bytes`;
      const where =
        params.buffer === ''
          ? `'${file}' hat`
          : `'${shown(params.buffer)}', das '${file}' braucht, hat`;
      return `${where} nur ${bytes} seiner Daten; ${again}`;
    }
  }
}

function bad3mf(params: Messages['bad-3mf']): string {
  const file = shown(params.file);
  switch (params.what) {
    case 'no-model':
      return `'${file}' ist ein 3MF-Paket ohne ein Modell darin; ${again}`;
    case 'nothing':
      return `'${file}' hat nichts, was gedruckt werden soll; speichere das Projekt neu, mit einem sichtbaren Objekt darin`;
    case 'sliced':
      return `'${file}' enthält nur einen fertigen Druckauftrag (G-Code) und kein Modell mehr; speichere das Projekt selbst, nicht die Druckdatei`;
    case 'no-part':
      return `'${file}' verweist auf '${shown(params.part)}', das nicht darin ist; ${again}`;
    case 'no-object':
      return `'${file}' verweist auf das Objekt ${shown(params.object)} in '${shown(params.part)}', das es dort nicht gibt; ${again}`;
    case 'cycle':
      return `das Objekt ${shown(params.object)} in '${file}' enthält sich selbst oder viel zu viele andere; ${exportAgain}`;
    case 'xml':
      return `'${file}' ist beschädigt: '${shown(params.part)}' ist in Zeile ${figure(params.line)} kein XML; ${again}`;
    case 'word':
      return `'${file}' ist beschädigt: In Zeile ${figure(params.line)} von '${shown(params.part)}' steht '${shown(params.word)}', wo anderes erwartet wird; ${again}`;
  }
}

function badPdo(params: Messages['bad-pdo']): string {
  const file = shown(params.file);
  switch (params.what) {
    case 'locked':
      return `'${file}' ist von der Person gesperrt, die es gemacht hat; bitte sie um eine Datei ohne Sperre`;
    case 'hidden':
      return `in '${file}' sind alle Körper ausgeschaltet; schalte einen im Pepakura Designer ein und speichere es neu`;
    case 'no-faces':
      return `'${file}' ist eine Pepakura-Datei ohne eine Fläche zum Falten; ${again}`;
    case 'old':
      return `'${file}' ist vom ersten Pepakura Designer, und gelesen werden Dateien von Pepakura Designer 2 bis 6; öffne es in einem davon und speichere es neu`;
    case 'version':
      return `'${file}' ist von einer Version von Pepakura, die hier nicht bekannt ist (${figure(params.version)}); speichere es für Pepakura Designer 2 bis 6 oder als OBJ`;
    case 'damaged':
      return `'${file}' ist beschädigt oder abgeschnitten (Byte ${figure(params.at)}); hol die Datei noch einmal, oder speichere sie im Pepakura Designer neu`;
  }
}

/** Those kinds that there are: "3 Animationen und 2 Kameras". */
function kinds(counts: readonly (readonly [number, string, string])[]): string {
  const found = counts.filter(([number]) => number > 0);
  return all(found.map(([number, one, many]) => count(number, one, many)));
}

function missingLooks({ what, files }: Messages['missing-looks']): string {
  const [is, them] = [choose(files.length, 'fehlt', 'fehlen'), choose(files.length, 'es', 'sie')];
  const names = some(files);
  const those =
    what === 'pictures'
      ? `${choose(files.length, 'das Bild', 'die Bilder')} ${names}`
      : `${choose(files.length, 'die Datei', 'die Dateien')} mit Farben und Bildern des Modells, ${names},`;
  return (
    `${those} ${is}, also bleiben diese Flächen einfarbig; ` +
    `wähle ${what === 'pictures' ? them : 'sie'} mit aus, oder wähle den ganzen Ordner`
  );
}

function unreadPictures({ files, kinds: found }: Messages['unread-pictures']): string {
  const are = choose(files.length, 'ist', 'sind');
  const what =
    found.length > 0
      ? `${are} von einer Art, die nicht gelesen wird (${all(found)})`
      : `${are} ${choose(files.length, 'kein Bild, das', 'keine Bilder, die')} sich lesen ${choose(files.length, 'lässt', 'lassen')}`;
  const saved = choose(files.length, 'es', 'sie');
  return `${some(files)} ${what}; speichere ${saved} als PNG oder JPEG, und nenne ${saved} im Modell ebenso`;
}

const lostNets = {
  none: 'die Datei bringt keine eigenen Netze mit',
  simplified: 'die Netze der Datei passen nicht zu einem Modell mit anderen Dreiecken',
  repaired:
    'die Netze der Datei ließen sich nicht behalten, weil ihre Flächen repariert werden mussten',
  flat: 'die Netze der Datei ließen sich nicht behalten, weil sie durch ebene Flächen gehen',
} as const;

function keptNets({ pieces, uncut, size }: Messages['file-nets-kept']): string {
  const words = [
    pieces === 1 ? 'das Netz der Datei blieb' : `die ${figure(pieces)} Netze der Datei blieben`,
  ];
  if (size === 'file') words.push('in der Größe der Datei');
  if (uncut > 0) {
    words.push(
      `aber ${count(uncut, 'Schnitt', 'Schnitte')} in ebenen Flächen ${choose(uncut, 'fiel', 'fielen')} weg`,
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
    `'${shown(file)}' braucht ${some(missing)}, und das fehlt; ` +
    `wähle ${choose(missing.length, 'es', 'sie')} mit aus, oder wähle den ganzen Ordner`,
  'no-model-in-archive': ({ file, files }) =>
    files.length === 0
      ? `im Archiv '${shown(file)}' ist nichts`
      : `keine Datei im Archiv '${shown(file)}' ist ein Modell, das gelesen wird; darin ist ${some(files)}`,
  'reader-not-loaded': () =>
    'was dieses Format liest, ließ sich nicht laden; sieh nach der Verbindung, und versuche es noch einmal',
  'uniter-not-loaded': () =>
    'was Körper vereint, ließ sich nicht laden; sieh nach der Verbindung, und versuche es noch einmal',
  'too-many-triangles': ({ most }) =>
    `das Modell hat mehr als ${figure(most)} Dreiecke, und das sind mehr, als sich lesen lassen; ` +
    'vereinfache es in dem Programm, das es gemacht hat',

  'broken-faces': ({ count: number }) =>
    number === 1
      ? '1 Fläche fiel weg: Ihr fehlen Ecken, oder sie nennt Ecken, die nicht in der Datei sind'
      : `${figure(number)} Flächen fielen weg: Ihnen fehlen Ecken, oder sie nennen Ecken, die nicht in der Datei sind`,
  'damaged-extras': () =>
    'hinter ihrer Form ist die Datei beschädigt: Einige Farben, Bilder und die Netze der Datei sind verloren; speichere sie im Pepakura Designer neu',
  'damaged-looks': () =>
    'die Farben und Bilder in der Datei sind beschädigt: Nur ihre Form wurde gelesen; exportiere sie neu',
  'large-pictures': ({ files, most, most_mb, most_pixels }) =>
    `${some(files)} ${choose(files.length, 'fiel', 'fielen')} weg: Benutzt werden bis zu ${figure(most)} Bilder mit zusammen ` +
    `${figure(most_mb)} MB, jedes mit höchstens ${figure(most_pixels / 1e6, 0)} Millionen Pixeln; ` +
    `mach ${choose(files.length, 'es', 'sie')} in einem Bildprogramm kleiner`,
  'lost-looks': ({ count: number }) =>
    `${count(number, 'Farbe oder Bild', 'Farben oder Bilder')}, auf die das Modell verweist, ${choose(number, 'ist', 'sind')} ` +
    'nicht in der Datei, also bleiben diese Flächen weiß; exportiere sie neu',
  'missing-looks': missingLooks,
  'picture-guessed': ({ file }) =>
    `das Modell nennt kein Bild, also kam ${shown(file)} darauf, das einzige daneben`,
  'simplified-looks': () =>
    'wo die Datei Farben oder Bilder übereinander legt oder mischt, gilt das oberste Bild, ' +
    'oder sonst die wichtigste Farbe',
  'unknown-materials': ({ names }) =>
    `${choose(names.length, 'das Material', 'die Materialien')} ${some(names)} des Modells ${choose(names.length, 'steht', 'stehen')} ` +
    'in keiner seiner MTL-Dateien, also bleibt weiß, was daraus ist',
  'unread-libraries': ({ files }) =>
    `${some(files)} ${choose(files.length, 'sollte', 'sollten')} die Farben und Bilder des Modells beschreiben, ${choose(files.length, 'ist', 'sind')} aber beschädigt ` +
    `oder ${choose(files.length, 'keine MTL-Datei', 'keine MTL-Dateien')}; exportiere das Modell neu`,
  'unread-pictures': unreadPictures,

  'archive-choice': ({ file, others }) =>
    `das Archiv hat ${figure(others.length + 1)} Modelle; genommen wurde '${shown(file)}', und nicht ${some(others)}`,
  'not-for-printing': ({ supports, modifiers, negatives, unprinted }) =>
    `weggelassen, weil die Datei sagt, dass es nicht gedruckt wird: ${kinds([
      [supports, 'Stütze', 'Stützen'],
      [modifiers, 'Modifikator', 'Modifikatoren'],
      [negatives, 'negatives Stück', 'negative Stücke'],
      [unprinted, 'ausgeschaltetes Objekt', 'ausgeschaltete Objekte'],
    ])}`,
  'file-nets-kept': keptNets,
  'file-nets-lost': ({ what }) => `${lostNets[what]}, darum wurden neue gemacht`,
  'file-nets-unused': ({ pieces }) =>
    `die Datei bringt ${count(pieces, 'eigenes Netz', 'eigene Netze')} mit; neue wurden gemacht; um ${choose(pieces, 'es', 'sie')} zu behalten, wähle das, wenn du das Modell ansiehst (--nets file)`,
  'fold-nets-unused': ({ pieces }) =>
    `die Datei bringt ${count(pieces, 'eigenes Netz', 'eigene Netze')} mit, ${choose(pieces, 'das nicht benutzt wurde', 'die nicht benutzt wurden')}: Ihr gefaltetes Modell wurde neu abgewickelt`,
  'parts-unused': ({ parts }) =>
    `es ${choose(parts, 'war', 'waren')} ${count(parts, 'Abschnitt', 'Abschnitte')} gewünscht, aber die Netze der Datei haben ihre eigenen, und die blieben`,
  'pdo-unused': ({ hidden, texts, images }) =>
    `nicht benutzt: ${kinds([
      [hidden, 'ausgeschalteter Körper', 'ausgeschaltete Körper'],
      [texts, 'Text auf den Blättern', 'Texte auf den Blättern'],
      [images, 'Bild auf den Blättern', 'Bilder auf den Blättern'],
    ])}`,
  'posed-skins': ({ count: number }) =>
    `${count(number, 'Netzmodell mit Skelett steht', 'Netzmodelle mit Skelett stehen')} in der Haltung, mit der die Datei beginnt`,
  'unknown-extensions': ({ names }) =>
    `die Datei benutzt ${some(names)}, was hier nicht bekannt ist; etwas kann fehlen oder anders aussehen`,
  'unused-content': ({ animations, morphs, uvs, cameras, instances }) =>
    `nicht benutzt: ${kinds([
      [animations, 'Animation', 'Animationen'],
      [morphs, 'Verformung', 'Verformungen'],
      [uvs, 'zweiter Satz von Bildkoordinaten', 'zweite Sätze von Bildkoordinaten'],
      [cameras, 'Kamera', 'Kameras'],
      [instances, 'Gruppe von Kopien', 'Gruppen von Kopien'],
    ])}`,
} satisfies Partial<Table>;
