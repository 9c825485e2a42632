import type { JobResult } from '../model/job.js';
import { buildingSeconds } from '../model/verdict.js';
import type { Words } from '../words/words.js';
import { craftFacts, type Fact } from './result-words.js';

/** A figure of two results. */
export interface ComparedFact {
  label: string;
  before: string;
  now: string;
}

function factsOf(words: Words, result: JobResult, margin: number): Fact[] {
  const { building, speech } = words;
  const { facts } = words.result;
  return [
    [facts.pieces, speech.figure(result.pieces.length)],
    [facts.sheets, speech.figure(result.sheets.length)],
    [building.gluedLabel(), building.duration({ seconds: buildingSeconds(result) })],
    ...craftFacts(words, result, margin),
  ];
}

/** What a person would compare two results of one model by; `margin`: around each sheet, mm. */
export function comparedFacts(
  words: Words,
  before: JobResult,
  now: JobResult,
  margin: number,
): ComparedFact[] {
  const present = factsOf(words, now, margin);
  return factsOf(words, before, margin).map(([label, value], i) => ({
    label,
    before: value,
    now: present[i]![1],
  }));
}
