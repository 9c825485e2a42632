import { areCompanions, joinedBy } from './late-companions.js';
import type { ChosenModel } from './model-file.js';

/** The model that the button unfolds. A file is chosen once the engine could read it, and not before. */
export class Choice {
  private readable: ChosenModel | null = null;
  /** Not read yet. */
  private candidate: ChosenModel | null = null;
  /** Could not be read as files that belong to it are missing, which may come yet. */
  private incomplete: ChosenModel | null = null;
  private isOpening = false;

  /** Null if there is none. */
  get model(): ChosenModel | null {
    return this.candidate ?? this.readable;
  }

  /** Whether it is being read for the first time. */
  get opening(): boolean {
    return this.isOpening;
  }

  /** Takes files that may be one, or belong to the one that was chosen before. */
  take(model: ChosenModel): void {
    const before = this.candidate ?? this.incomplete ?? this.readable;
    this.candidate = before && areCompanions(model) ? joinedBy(before, model) : model;
    this.incomplete = null;
  }

  /** The file is being read. */
  open(): void {
    this.isOpening = this.candidate !== null;
  }

  /** It is a model, of this file. */
  accept(name: string): void {
    this.readable = this.model && { ...this.model, name };
    this.drop();
  }

  /** Another one that was read before is chosen again. */
  comeBack(model: ChosenModel): void {
    this.readable = model;
    this.drop();
  }

  /** It is none, and is dropped: the one before is chosen again, if there is one. @param code why it is none */
  drop(code = ''): void {
    if (code === 'missing-files') this.incomplete = this.candidate;
    this.candidate = null;
    this.leave();
  }

  /** Nobody knows, as it was not read to its end. */
  leave(): void {
    this.isOpening = false;
  }
}
