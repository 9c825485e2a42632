import { partColour } from '../model/part-colours.js';
import type { FitnessHistory, FitnessPoint } from './fitness-history.js';

const svgNamespace = 'http://www.w3.org/2000/svg';

/** Room for the labels, in pixels. */
const edges = { left: 34, right: 12, top: 12, bottom: 22 };

interface Scales {
  x: (generation: number) => number;
  y: (best: number) => number;
  lastGeneration: number;
  worst: number;
}

type Attributes = Record<string, string | number>;

function shape(name: string, attributes: Attributes, text = ''): SVGElement {
  const element = document.createElementNS(svgNamespace, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  element.textContent = text;
  return element;
}

function scalesOf(history: FitnessHistory, width: number, height: number): Scales {
  const points = [...history.parts.values()].flat();
  const lastGeneration = points.reduce((most, { generation }) => Math.max(most, generation), 1);
  const worst = points.reduce((least, { best }) => Math.min(least, best), -1);
  const [across, down] = [width - edges.left - edges.right, height - edges.top - edges.bottom];
  return {
    lastGeneration,
    worst,
    x: (generation) => edges.left + (across * generation) / lastGeneration,
    // The last few overlaps take longest: a square root gives them room.
    y: (best) => edges.top + down * Math.sqrt(Math.max(0, -best) / -worst),
  };
}

/** The best so far is a stair: it stays until something better is found. */
function stair(points: readonly FitnessPoint[], { x, y }: Scales): string {
  return points
    .map(({ generation, best }, index) => {
      const [right, down] = [x(generation).toFixed(1), y(best).toFixed(1)];
      return index === 0 ? `M${right} ${down}` : `H${right}V${down}`;
    })
    .join('');
}

function curve(part: number, points: readonly FitnessPoint[], scales: Scales, now: boolean): Node {
  const group = shape('g', { class: now ? 'curve curve--now' : 'curve' });
  const { generation, best } = points.at(-1)!;
  group.append(
    shape('path', { d: stair(points, scales) }),
    shape('circle', {
      cx: scales.x(generation).toFixed(1),
      cy: scales.y(best).toFixed(1),
      r: now ? 5 : 3.5,
      fill: partColour(part),
    }),
  );
  return group;
}

function axes({ x, y, worst, lastGeneration }: Scales, width: number, height: number): Node[] {
  const label = (text: string, attributes: Attributes): Node => shape('text', attributes, text);
  const left = edges.left - 6;
  return [
    shape('path', { class: 'goal', d: `M${edges.left} ${y(0)}H${width - edges.right}` }),
    shape('path', {
      class: 'axis',
      d: `M${edges.left} ${edges.top}V${height - edges.bottom}H${width - edges.right}`,
    }),
    label('0', { x: left, y: y(0) + 4, 'text-anchor': 'end' }),
    label(String(Math.round(worst)), { x: left, y: y(worst), 'text-anchor': 'end' }),
    label('0', { x: x(0), y: height - 6 }),
    label(String(lastGeneration), { x: x(lastGeneration), y: height - 6, 'text-anchor': 'end' }),
  ];
}

/** Draws the curves of all parts into `svg`, the current one above the others. */
export function drawFitness(svg: SVGSVGElement, history: FitnessHistory): void {
  const { clientWidth: width, clientHeight: height } = svg;
  if (width === 0 || height === 0) return;
  svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
  if (history.parts.size === 0) {
    svg.replaceChildren();
    return;
  }
  const scales = scalesOf(history, width, height);
  const others = [...history.parts].filter(([part]) => part !== history.current);
  const current = history.parts.get(history.current) ?? [];
  svg.replaceChildren(
    ...axes(scales, width, height),
    ...others.map(([part, points]) => curve(part, points, scales, false)),
    curve(history.current, current, scales, true),
  );
}
