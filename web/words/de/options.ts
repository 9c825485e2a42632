/** German phrases for options that cannot be as they were written, and what help says of them. */
import type { ValueFault } from '../../model/option-values.js';
import { paperSizes } from '../../model/paper.js';
import type { OptionFault } from '../messages.js';
import type { Words } from '../words.js';
import { figure } from './numbers.js';
import { stepFault } from './repair.js';

function expectation(fault: ValueFault): string {
  switch (fault.expected) {
    case 'whole':
      return `ist keine ganze Zahl von ${figure(fault.least)} bis ${figure(fault.most)}`;
    case 'decimal':
      return `ist keine Zahl von ${figure(fault.least)} bis ${figure(fault.most)}`;
    case 'words':
      return `ist nicht ${fault.words.join(' oder ')}`;
    case 'colour':
      return 'ist nicht #RRGGBB';
    case 'pair':
      return 'sind nicht zwei Werte mit einem Komma dazwischen';
    case 'dashes':
      return (
        'ist weder solid noch eine Folge von Strichen und Lücken, von ' +
        `${figure(fault.least)} bis ${figure(fault.most)}`
      );
    case 'switches':
    case 'other-step':
      return stepFault(fault);
    case 'paper': {
      const names = paperSizes.map(({ name }) => name).join(', ');
      return `ist weder ${names} noch BxH mit je ${figure(fault.least)} bis ${figure(fault.most)} mm`;
    }
  }
}

function valueFault(fault: ValueFault): string {
  const about = fault.part === undefined ? '' : `nennt keinen Abschnitt: '${fault.part}' `;
  const or = fault.or === undefined ? '' : `, und auch nicht ${fault.or}`;
  return about + expectation(fault) + or;
}

export function optionFault(fault: OptionFault): string {
  switch (fault.what) {
    case 'no-option':
      return `die Option '${fault.option}' gibt es nicht`;
    case 'value':
      return `Option '${fault.option}': '${fault.value}' ${valueFault(fault)}`;
    case 'fixed':
      return `Option '${fault.option}' lässt sich hier nicht ändern`;
    case 'second-size':
      return `Option '${fault.option}': die Größe steht schon durch '${fault.first}' fest`;
    case 'no-paper-left':
      return `Option '${fault.option}': ${figure(fault.margin_mm)} mm lassen von ${fault.paper} nichts übrig`;
    case 'pixels': {
      const sheet = `${figure(fault.width_mm, 1)} x ${figure(fault.height_mm, 1)} mm`;
      return `${figure(fault.dpi)} Punkte je Zoll sind zu viele für Blätter von ${sheet}: ${figure(fault.possible)} sind möglich`;
    }
  }
}

export const optionHelp: Words['optionHelp'] = {
  parts: 'Zahl der Abschnitte',
  nets: 'file: Netze und Laschen behalten, die die Datei mitbringt (PDO); new: andere suchen',
  solver: 'tree: lokale Suche auf Spannbäumen; genetic: Evolution, wie veröffentlicht',
  heuristic:
    'für das Lernen: steepest (steilste Kanten), flat (flach), hybrid (beides) oder random (Zufall)',
  segment: 'merge: Faltbarkeit und Form; spectral: Faltbarkeit allein',
  runs: 'Läufe zum Lernen',
  proxy: 'über N Flächen an einer einfacheren Kopie lernen; 0: nie',
  seed: 'dieselbe Startzahl gibt dasselbe Ergebnis',
  faces: 'zuerst auf N Dreiecke vereinfachen',
  repair:
    'welche Schritte der Reparatur getan werden, etwa weld=off oder cracks=off; mehrmals möglich',
  'fill-holes':
    'Löcher füllen, die höchstens so viele Prozent der längsten Seite des Modells breit sind; all: alle',
  inside: 'Körper, die in anderen liegen: keep: behalten; drop: weglassen',
  crossing: 'Körper, die durcheinander gehen: keep: behalten; unite: vereinen',
  folding: 'Netze ohne Weg zum Falten: require: zerlegen; prefer: melden; off: nicht danach suchen',
  clearance: 'wie weit Flächen beim Falten voneinander bleiben, in mittleren Kantenlängen',
  height:
    'fertige Höhe, von unten nach oben; Teile, die nicht auf das Blatt passen, werden neu geschnitten',
  width: 'fertige Breite: entlang x, oder entlang y, wenn x oben ist',
  depth: 'fertige Tiefe: entlang z, oder entlang y, wenn z oben ist',
  up: 'Achse der Datei, die nach oben zeigt: x, y oder z; guess: z bei STL, sonst y',
  scale: 'fertige Größe als Faktor auf die Größe in der Einheit des Modells',
  sheets: 'so groß, wie es auf N Blätter geht',
  unit: 'Einheit des Modells: mm, cm, m oder in',
  paper: 'A2 bis A5, Letter, Legal, Tabloid, 12x12in oder BxH in mm',
  orientation: 'auto, portrait (hochkant) oder landscape (quer)',
  margin: 'Rand, der frei bleibt',
  flaps: 'Höhe der Laschen; niedriger, wo kein Platz ist',
  'flap-angle': 'Winkel ihrer Seiten am Fuß, höchstens',
  'flap-style':
    'Laschen an sanften Biegungen: edge: jede wie alle anderen; run: ein Streifen mit schmalen Kerben; zigzag: spitze Zacken',
  'flap-side': 'one: die Seite mit mehr Platz; alternate: abwechselnd; both: beide',
  'flap-borders': 'on: auch offene Ränder des Modells bekommen Laschen',
  'glue-strips':
    'lose Streifen für Kanten ohne Lasche: none: keine; free: wo Blätter Platz haben; all: auch auf weiteren Blättern',
  ids: 'wo die Nummern der Schnittkanten stehen: auf Flächen (inside), Laschen (flap) oder beidem (both), auf Laschen und Abfall (outside) oder nirgends (none)',
  'min-piece': 'kleinere Körper des Modells werden nicht gedruckt, aber gemeldet',
  compact:
    'on: Netze mit Platz für Laschen, kleinem Umriss und festen Engstellen; off: wie sie gefunden wurden',
  workers: 'Threads; auto: einer je Kern, höchstens 4; jede Zahl gibt dasselbe Ergebnis',
  lang: 'Sprache aller Wörter: in Hilfe und Meldungen und auf den Blättern',
  'flat-fold': 'flachere Falten werden nicht gezeichnet',
  style: 'wie Linien aussehen: foldwright, pepakura oder blender',
  'cut-width': 'Breite der Schnitte',
  'cut-colour': 'Farbe der Schnitte',
  'mountain-width': 'Breite der Bergfalten',
  'mountain-dash': 'Striche und Lücken der Bergfalten',
  'mountain-colour': 'Farbe der Bergfalten',
  'valley-width': 'Breite der Talfalten',
  'valley-dash': 'Striche und Lücken der Talfalten',
  'valley-colour': 'Farbe der Talfalten',
  'flap-colour': 'womit Laschen gefüllt sind',
  'fold-ticks':
    'on: Falten sind Marken von 3 mm an beiden Enden, oder ein Drittel der Falte, statt Linien über das Bild',
  duplex:
    'on: hinter jedem Blatt eine Seite mit seinen Falten, gespiegelt, zum beidseitigen Drucken, an der langen Kante gewendet (PDF)',
  'fold-angles': 'neben Falten drucken, wie weit sie gefaltet werden',
  thickness: 'wie dick das Papier ist: Laschen werden gefaltet, wo seine Rückseite zu liegen kommt',
  legend: 'einmal drucken, was Linien und Zahlen bedeuten',
  assembly: 'on: Seiten mit Deckblatt, Liste der Teile und Bauanleitung (PDF, SVG, PNG)',
  measured:
    'was die gedruckten Lineale von 50 mm messen, quer und hoch: korrigiert den Maßstab des Druckers',
  machine:
    'für eine Schneidemaschine: Linien zum Schneiden, Ritzen und Zeichnen in reinen Farben; none: für die Schere',
  dpi: 'Pixel je Zoll von PNG-Dateien und der Farben und Bilder des Modells in allen Dateien',
  texture:
    'Flächen in den Farben und Bildern des Modells drucken; auto: wo es welche hat, ohne --colour part',
  colour:
    'part: jedes Teil in der Farbe seines Abschnitts drucken, wenn nicht --texture on im Modell welche findet',
  shading:
    'on: Licht und Schatten der Oberfläche drucken, bei vereinfachten Modellen die von vorher, sodass kleine Formen auch ohne Falten zu sehen sind',
  'flap-bleed': 'wie viel einer Lasche die Farben ihrer Fläche bekommt: none, half oder whole',
};
