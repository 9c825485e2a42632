/** Spanish words about the steps by which a file becomes a surface that can be unfolded. */
import type { NeededStep } from '../../model/repair-steps.js';
import type { Messages, Table } from '../messages.js';
import type { StepFault } from '../step-fault.js';
import type { Words } from '../words.js';
import { choose, count } from './numbers.js';

const reasons: Record<NeededStep, string> = {
  polygons: 'las plantillas están hechas de triángulos',
  degenerate: 'una cara sin superficie no tiene sitio en una plantilla',
  'non-manifold': 'un pliegue une dos caras y no más',
};

export function stepFault(fault: StepFault): string {
  if (fault.expected === 'switches') {
    return `no es una lista como weld=off; hay ${fault.steps.join(', ')}`;
  }
  return 'request' in fault
    ? `nombra '${fault.step}', que solo se hace donde lo pide --${fault.request}`
    : `nombra '${fault.step}', que no se puede desactivar: ${reasons[fault.step]}`;
}

function stepOff({ what, count: number }: Messages['step-off']): string {
  switch (what) {
    case 'weld':
      return `juntar puntos está desactivado: ${count(number, 'vértice está encima de otro y sigue separado de él', 'vértices están encima de otros y siguen separados de ellos')}`;
    case 'duplicates':
      return `quitar copias está desactivado: ${count(number, 'cara repite otra y también se imprime', 'caras repiten otras y también se imprimen')}`;
    case 'two-sided':
      return `juntar los dos lados está desactivado: ${count(number, 'cara está en el dorso de otra y también se imprime', 'caras están en el dorso de otras y también se imprimen')}`;
    case 't-junctions':
      return `cerrar huecos en las esquinas está desactivado: ${count(number, 'arista con una esquina de sus vecinas encima se queda abierta', 'aristas con una esquina de sus vecinas encima se quedan abiertas')}`;
    case 'cracks':
      return `cerrar grietas está desactivado: ${count(number, 'arista junto a una grieta se queda abierta', 'aristas junto a grietas se quedan abiertas')}`;
    case 'winding':
      return `girar caras está desactivado: ${count(number, 'cara tiene', 'caras tienen')} el lado impreso por dentro, y ${choose(number, 'se separa', 'se separan')} de las vecinas que lo tienen por fuera`;
    case 'flatten':
      return `aplanar está desactivado: ${count(number, 'cara dibujada plana se queda un poco doblada', 'caras dibujadas planas se quedan un poco dobladas')}`;
  }
}

export const repairMessages = {
  'flat-bodies': ({ count: number }) =>
    `${count(number, 'cuerpo cerrado no tiene', 'cuerpos cerrados no tienen')} volumen, porque sus capas están una encima de otra: ` +
    'cada capa se imprime, y pegadas dorso con dorso forman una hoja',
  'step-off': stepOff,
} satisfies Partial<Table>;

export const repairSteps: Words['repairSteps'] = {
  weld: 'Juntar puntos del mismo sitio',
  duplicates: 'Quitar copias de caras',
  'two-sided': 'Hacer una hoja de los dos lados',
  't-junctions': 'Cerrar huecos en las esquinas',
  cracks: 'Cerrar grietas',
  winding: 'Poner las caras del derecho',
  flatten: 'Aplanar lo dibujado plano',
};
