import type { JobEvent } from './job.js';
import { NetsSoFar } from './nets-so-far.js';

/** How far the parts of a model are, from what a run tells; both numbers only ever change for the better. */
export class PartsProgress {
  /** How many there are; 0 until that is known. */
  parts = 0;
  /** By part: overlaps of the best net that it had so far. */
  private readonly overlapsOf = new Map<number, number>();
  private readonly found = new Set<number>();
  private readonly nets = new NetsSoFar();
  private labels: Int32Array = new Int32Array();

  /** How many parts have nets of all their faces: one that was cut has several. */
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
      this.labels = event.labels;
      this.parts = event.labels.reduce((most, label) => Math.max(most, label + 1), 0);
    } else if (event.type === 'generation') this.note(event.part, event.overlaps);
    else if (event.type === 'net') this.note(event.part, 0);
    if (this.nets.follow(event)) this.count();
  }

  /** Where no shape is told, the word that there is a net is all that there is. */
  private count(): void {
    const { nets } = this.nets;
    const faces = new Set(nets.flatMap(({ net }) => (net ? [...net.sources] : [])));
    const open = new Set<number>();
    this.labels.forEach((part, face) => {
      if (!faces.has(face)) open.add(part);
    });
    for (const { part, net } of nets) if (!net || !open.has(part)) this.found.add(part);
  }

  private note(part: number, overlaps: number): void {
    this.overlapsOf.set(part, Math.min(overlaps, this.overlapsOf.get(part) ?? Infinity));
  }
}
