/** English words about the steps by which a file becomes a surface that can be unfolded. */
import type { NeededStep } from '../../model/repair-steps.js';
import type { Messages, Table } from '../messages.js';
import type { StepFault } from '../step-fault.js';
import { choose, count } from './numbers.js';

const reasons: Record<NeededStep, string> = {
  polygons: 'nets are made of triangles',
  degenerate: 'a face without an area has no place in a net',
  'non-manifold': 'a fold joins two faces and no more',
};

/** What is wrong with a step that is named in an option, to be read after it. */
export function stepFault(fault: StepFault): string {
  if (fault.expected === 'switches') {
    return `is no list such as weld=off; there are ${fault.steps.join(', ')}`;
  }
  return 'request' in fault
    ? `names '${fault.step}', which is done only where --${fault.request} asks for it`
    : `names '${fault.step}', which cannot be switched off: ${reasons[fault.step]}`;
}

function stepOff({ what, count: number }: Messages['step-off']): string {
  const faces = count(number, 'face');
  const edges = count(number, 'edge');
  switch (what) {
    case 'weld':
      return `welding was switched off: ${count(number, 'vertex', 'vertices')} ${choose(number, 'lies', 'lie')} on others and ${choose(number, 'stays', 'stay')} apart from them`;
    case 'duplicates':
      return `dropping copies was switched off: ${faces} ${choose(number, 'repeats another one and is', 'repeat others and are')} printed as well`;
    case 'two-sided':
      return `joining two sides was switched off: ${faces} ${choose(number, 'lies on the back of another one and is', 'lie on the backs of others and are')} printed as well`;
    case 't-junctions':
      return `closing gaps at corners was switched off: ${edges} with a corner of the neighbours on ${choose(number, 'it stays', 'them stay')} open`;
    case 'cracks':
      return `closing cracks was switched off: ${edges} beside cracks ${choose(number, 'stays', 'stay')} open`;
    case 'winding':
      return `turning faces over was switched off: ${faces} ${choose(number, 'has its', 'have their')} printed side inside, and ${choose(number, 'comes', 'come')} apart from neighbours that have it outside`;
    case 'flatten':
      return `flattening was switched off: ${faces} that ${choose(number, 'was', 'were')} drawn flat ${choose(number, 'stays', 'stay')} slightly bent`;
  }
}

export const repairMessages = {
  'flat-bodies': ({ count: number }) =>
    `${count(number, 'closed body has', 'closed bodies have')} no volume, since ${choose(number, 'its', 'their')} layers lie on each other: ` +
    'each layer is printed, to be glued back to back into one sheet',
  'step-off': stepOff,
} satisfies Partial<Table>;

/** What the steps do, as a person would switch it on or off. */
export const repairSteps = {
  weld: 'Join points at the same place',
  duplicates: 'Leave out copies of faces',
  'two-sided': 'Make one sheet of front and back',
  't-junctions': 'Close gaps at corners',
  cracks: 'Close cracks',
  winding: 'Turn faces right side out',
  flatten: 'Flatten what was drawn flat',
};
