/** From where a picture of the model is seen, without perspective. */
import { cross, dot, times, type Vector } from '../model/vector.js';

export const viewNames = [
  'front-left',
  'back-right',
  'front-right',
  'back-left',
  'above',
  'below',
] as const;
export type ViewName = (typeof viewNames)[number];

/** Axes of a picture in the space of the model, of unit length: x, y and towards who looks. */
export interface View {
  right: Vector;
  up: Vector;
  towards: Vector;
}

/**
 * Where who looks stands: y is up, and the front is where z grows, as files with y up have it. The heights
 * show lids and the backs of animals without hiding what is in front.
 */
const places: Readonly<Record<ViewName, Vector>> = {
  'front-left': [-0.8, 0.6, 1],
  'back-right': [0.8, 0.6, -1],
  'front-right': [0.8, 0.6, 1],
  'back-left': [-0.8, 0.6, -1],
  above: [-0.45, 1.3, 0.7],
  below: [-0.8, -0.75, 1],
};

/** Not by `Math.hypot`, whose last digit differs between browsers. */
function unit(v: Vector): Vector {
  return times(v, 1 / Math.sqrt(dot(v, v)));
}

export function viewFrom(name: ViewName): View {
  const towards = unit(places[name]);
  const right = unit(cross([0, 1, 0], towards));
  return { right, up: cross(towards, right), towards };
}
