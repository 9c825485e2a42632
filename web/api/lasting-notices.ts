/** What is told of how a document began, and so of all that is made of it. */
import { sizings, type Settings } from '../model/options.js';
import type { Message } from '../model/message.js';
import type { Code } from '../words/messages.js';
import type { DocumentState } from './document-state.js';

const lasting: ReadonlySet<string> = new Set<Code>([
  'run-stopped',
  'file-nets-kept',
  'file-nets-lost',
  'file-nets-unused',
  'parts-unused',
]);

/** That a run or an edit was ended before it had come as far as it could. */
export const stopped: Message = { code: 'run-stopped', params: {} };

function haveSameSize(a: Settings, b: Settings): boolean {
  return sizings.every((name) => a[name] === b[name]);
}

/** Notices of a state, with those of the state before that hold for it as well. */
export function withLasting(
  notices: readonly Message[],
  before: DocumentState,
  settings: Settings,
): Message[] {
  const isSized = haveSameSize(before.wishes.settings, settings);
  const told = new Set(notices.map(({ code }) => code));
  const kept = before.result.notices.filter(({ code }) => lasting.has(code) && !told.has(code));
  const still = kept.map((notice): Message =>
    notice.code === 'file-nets-kept' && !isSized
      ? { ...notice, params: { ...notice.params, size: 'other' } }
      : notice,
  );
  return [...still, ...notices];
}
