/** The list of states: what is kept of them, and when reports are made. */
import { expect, test, vi } from 'vitest';
import { History, type HistoryStep } from '../../web/api/history.js';
import type { DocumentState } from '../../web/api/document-state.js';
import type { Report } from '../../web/export/report.js';

/** A state of which no two find room. */
function largeState(name: string): DocumentState {
  const surface = new Uint8Array(200 * 1024 * 1024);
  return { result: { name, surface, looks: null } } as unknown as DocumentState;
}

function stepTo(name: string): HistoryStep {
  const state = largeState(name);
  return { edits: [], remake: () => Promise.resolve(largeState(name)), state, saved: null };
}

function historyOf(...names: string[]): { history: History; reportOf: ReturnType<typeof vi.fn> } {
  const reportOf = vi.fn(({ result }: DocumentState) => result as unknown as Report);
  const [first, ...others] = names;
  const history = new History([stepTo(first!)], 0, { reportOf });
  for (const name of others) history.add(stepTo(name));
  return { history, reportOf };
}

test('reports are made when they are asked for, and once', () => {
  const { history, reportOf } = historyOf('first');
  expect(reportOf).not.toHaveBeenCalled();
  expect(history.report).toMatchObject({ name: 'first' });
  expect(history.report).toMatchObject({ name: 'first' });
  expect(reportOf).toHaveBeenCalledTimes(1);
});

test('a state that leaves the memory leaves its report, and is made again', async () => {
  const { history, reportOf } = historyOf('first', 'second');
  expect(reportOf).toHaveBeenCalledTimes(1);
  expect(history.before).toBeNull();
  expect(history.move(-1)).toBe(true);
  expect(history.report).toMatchObject({ name: 'first' });
  const made = await history.current({});
  expect(made.result).toMatchObject({ name: 'first' });
  // Now the other one has no room, but was the current one until then.
  expect(history.move(1)).toBe(true);
  expect(history.report).toMatchObject({ name: 'second' });
});
