/** German words about the steps by which a file becomes a surface that can be unfolded. */
import type { NeededStep } from '../../model/repair-steps.js';
import type { Messages, Table } from '../messages.js';
import type { Words } from '../words.js';
import type { StepFault } from '../step-fault.js';
import { choose, count } from './numbers.js';

const reasons: Record<NeededStep, string> = {
  polygons: 'Netze bestehen aus Dreiecken',
  degenerate: 'eine Fläche ohne Inhalt hat in einem Netz keinen Platz',
  'non-manifold': 'ein Falz verbindet zwei Flächen und nicht mehr',
};

export function stepFault(fault: StepFault): string {
  if (fault.expected === 'switches') {
    return `ist keine Liste wie weld=off; es gibt ${fault.steps.join(', ')}`;
  }
  return 'request' in fault
    ? `nennt '${fault.step}', was nur geschieht, wo --${fault.request} es verlangt`
    : `nennt '${fault.step}', was sich nicht abschalten lässt: ${reasons[fault.step]}`;
}

function stepOff({ what, count: number }: Messages['step-off']): string {
  const faces = count(number, 'Fläche', 'Flächen');
  const edges = count(number, 'Kante', 'Kanten');
  switch (what) {
    case 'weld':
      return `Ecken zu vereinen war abgeschaltet: ${count(number, 'Ecke liegt auf einer anderen und bleibt', 'Ecken liegen auf anderen und bleiben')} von ihr getrennt`;
    case 'duplicates':
      return `Doppeltes wegzulassen war abgeschaltet: ${faces} ${choose(number, 'ist', 'sind')} doppelt da und ${choose(number, 'wird', 'werden')} mitgedruckt`;
    case 'two-sided':
      return `zwei Seiten zu vereinen war abgeschaltet: ${faces} ${choose(number, 'liegt auf der Rückseite einer anderen und wird', 'liegen auf der Rückseite von anderen und werden')} mitgedruckt`;
    case 't-junctions':
      return `Lücken an Ecken zu schließen war abgeschaltet: ${edges}, auf ${choose(number, 'der', 'denen')} eine Ecke der Nachbarn liegt, ${choose(number, 'bleibt', 'bleiben')} offen`;
    case 'cracks':
      return `Risse zu schließen war abgeschaltet: ${edges} an Rissen ${choose(number, 'bleibt', 'bleiben')} offen`;
    case 'winding':
      return `Flächen umzudrehen war abgeschaltet: ${faces} ${choose(number, 'hat', 'haben')} die bedruckte Seite innen und ${choose(number, 'löst', 'lösen')} sich von Nachbarn, die sie außen haben`;
    case 'flatten':
      return `Ebnen war abgeschaltet: ${faces}, die eben gezeichnet ${choose(number, 'wurde, bleibt', 'wurden, bleiben')} leicht krumm`;
  }
}

export const repairMessages = {
  'flat-bodies': ({ count: number }) =>
    `${count(number, 'geschlossener Körper hat', 'geschlossene Körper haben')} kein Volumen, weil die Schichten aufeinander liegen: ` +
    'Jede Schicht wird gedruckt, und Rücken an Rücken geklebt werden sie ein Blatt',
  'step-off': stepOff,
} satisfies Partial<Table>;

export const repairSteps: Words['repairSteps'] = {
  weld: 'Punkte an derselben Stelle vereinen',
  duplicates: 'Doppelte Flächen weglassen',
  'two-sided': 'Aus Vorder- und Rückseite ein Blatt machen',
  't-junctions': 'Lücken an Ecken schließen',
  cracks: 'Risse schließen',
  winding: 'Flächen richtig herum drehen',
  flatten: 'Eben machen, was eben gezeichnet ist',
};
