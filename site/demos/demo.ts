/** What a demonstration is: some fields, some pictures, and what to do with the events of a run. */
import type { Options, TimedEvent } from '../../web/api/browser.js';

/** A number or a choice that a visitor sets before a run. */
export type Field =
  | { name: string; title: string; kind: 'number'; value: number; least: number; most: number }
  | { name: string; title: string; kind: 'choice'; choices: Readonly<Record<string, string>> };

export interface Demo {
  /** Of the button that begins a run. */
  action: string;
  fields: readonly Field[];
  /** Makes its pictures in an empty place; called once. */
  begin: (place: HTMLElement) => Show;
}

/** Shows the events of one run after the other. */
export interface Show {
  /** Options of a run by the values of the fields. */
  options: (values: Readonly<Record<string, string>>) => Options;
  /** Forgets the run before. */
  clear: () => void;
  /** @returns what to say of it, if anything; `isDone`: the rest of the run has nothing to show */
  take: (event: TimedEvent) => { words?: string; isDone?: boolean };
}
