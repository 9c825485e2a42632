/** French words about the steps by which a file becomes a surface that can be unfolded. */
import type { NeededStep } from '../../model/repair-steps.js';
import type { Messages, Table } from '../messages.js';
import type { StepFault } from '../step-fault.js';
import type { Words } from '../words.js';
import { count } from './numbers.js';

const reasons: Record<NeededStep, string> = {
  polygons: 'les patrons sont faits de triangles',
  degenerate: 'une face sans surface n’a pas de place dans un patron',
  'non-manifold': 'un pli joint deux faces et pas plus',
};

export function stepFault(fault: StepFault): string {
  if (fault.expected === 'switches') {
    return `n’est pas une liste comme weld=off\u202f; il y a ${fault.steps.join(', ')}`;
  }
  return 'request' in fault
    ? `nomme '${fault.step}', qui n’est fait que là où --${fault.request} le demande`
    : `nomme '${fault.step}', qui ne peut pas être désactivé\u202f: ${reasons[fault.step]}`;
}

function stepOff({ what, count: number }: Messages['step-off']): string {
  switch (what) {
    case 'weld':
      return `la réunion des points est désactivée\u202f: ${count(number, 'sommet est sur un autre et en reste séparé', 'sommets sont sur d’autres et en restent séparés')}`;
    case 'duplicates':
      return `l’élimination des copies est désactivée\u202f: ${count(number, 'face en répète une autre et est imprimée aussi', 'faces en répètent d’autres et sont imprimées aussi')}`;
    case 'two-sided':
      return `la réunion des deux côtés est désactivée\u202f: ${count(number, 'face est au dos d’une autre et est imprimée aussi', 'faces sont au dos d’autres et sont imprimées aussi')}`;
    case 't-junctions':
      return `la fermeture des fentes aux coins est désactivée\u202f: ${count(number, 'arête qui porte un coin de ses voisines reste ouverte', 'arêtes qui portent un coin de leurs voisines restent ouvertes')}`;
    case 'cracks':
      return `la fermeture des fissures est désactivée\u202f: ${count(number, 'arête au bord d’une fissure reste ouverte', 'arêtes au bord de fissures restent ouvertes')}`;
    case 'winding':
      return `le retournement des faces est désactivé\u202f: ${count(number, 'face a son côté imprimé à l’intérieur, et se sépare des voisines', 'faces ont leur côté imprimé à l’intérieur, et se séparent des voisines')} qui l’ont à l’extérieur`;
    case 'flatten':
      return `l’aplatissement est désactivé\u202f: ${count(number, 'face dessinée plane reste un peu gauchie', 'faces dessinées planes restent un peu gauchies')}`;
  }
}

export const repairMessages = {
  'flat-bodies': ({ count: number }) =>
    `${count(number, 'corps fermé n’a pas de volume, car ses', 'corps fermés n’ont pas de volume, car leurs')} couches sont l’une sur l’autre\u202f: ` +
    'chaque couche est imprimée, et collées dos à dos elles font une feuille',
  'step-off': stepOff,
} satisfies Partial<Table>;

export const repairSteps: Words['repairSteps'] = {
  weld: 'Réunir les points au même endroit',
  duplicates: 'Enlever les copies de faces',
  'two-sided': 'Faire une feuille des deux côtés',
  't-junctions': 'Fermer les fentes aux coins',
  cracks: 'Fermer les fissures',
  winding: 'Mettre les faces à l’endroit',
  flatten: 'Aplatir ce qui est dessiné plat',
};
