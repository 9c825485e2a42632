import type { JobEvent } from './job.js';

/** How far the parts of a model are, from what a run tells; both numbers only ever change for the better. */
export class PartsProgress {
  /** How many there are; 0 until that is known. */
  parts = 0;
  /** By part: overlaps of the best net that it had so far. */
  private readonly overlapsOf = new Map<number, number>();
  private readonly found = new Set<number>();

  /** How many parts have a net. */
  get done(): number {
    return this.found.size;
  }

  /**
   * Overlaps of the best nets of all parts together; null as long as a part was not heard of, which would let the
   * sum rise when its search begins.
   */
  get overlaps(): number | null {
    if (this.parts === 0 || this.overlapsOf.size < this.parts) return null;
    return [...this.overlapsOf.values()].reduce((sum, overlaps) => sum + overlaps, 0);
  }

  follow(event: JobEvent): void {
    if (event.type === 'segmented') {
      this.parts = event.labels.reduce((most, label) => Math.max(most, label + 1), 0);
    } else if (event.type === 'generation') this.note(event.part, event.overlaps);
    else if (event.type === 'net') {
      this.found.add(event.part);
      this.note(event.part, 0);
    }
  }

  private note(part: number, overlaps: number): void {
    this.overlapsOf.set(part, Math.min(overlaps, this.overlapsOf.get(part) ?? Infinity));
  }
}
