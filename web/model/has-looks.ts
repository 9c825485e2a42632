import type { JobResult } from './job.js';

/** Whether a model has colours or pictures that white paper does not show anyway. */
export function hasLooks({ looks }: Pick<JobResult, 'looks'>): boolean {
  if (!looks) return false;
  const { materials, surface } = looks;
  return (
    surface.colours !== null ||
    materials.some(
      ({ colour, picture }) => picture !== null || colour.some((channel) => channel < 255),
    )
  );
}
