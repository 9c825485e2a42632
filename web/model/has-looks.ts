import type { JobResult } from './job.js';

/** Whether a model has colours or pictures that paper can show. */
export function hasLooks({ looks }: Pick<JobResult, 'looks'>): boolean {
  return looks !== undefined && (looks.materials.length > 0 || looks.surface.colours !== null);
}
