/** The results of a project as JSON. Most nets are in many states, and so each stands there once. */
import type { SavedNet } from '../model/job.js';
import type { Message } from '../model/message.js';
import type { SavedState } from './project.js';
import {
  finite,
  isRecord,
  listOf,
  nullOr,
  oneOf,
  record,
  recordOf,
  text,
  whole,
} from './shapes.js';

/** A net without what differs from state to state. */
interface PlainNet {
  cause: SavedNet['cause'];
  faces: number[];
  folds: number[];
  foldable: SavedNet['foldable'];
  times: number[];
  shares: number[][];
}

interface PlacedNet {
  /** Of the list. */
  net: number;
  part: number;
  place?: NonNullable<SavedNet['place']>;
}

interface PlainState extends Omit<SavedState, 'start'> {
  /** Of the list. */
  labels: number;
  nets: PlacedNet[];
  paper: SavedState['start']['paper'];
}

export interface ResultsJson {
  labels: number[][];
  nets: PlainNet[];
  states: (PlainState | null)[];
}

/** Values without those that are there already. */
class Pool<Value> {
  readonly values: Value[] = [];
  private readonly known = new Map<string, number>();

  /** The place of a value in the list. */
  add(value: Value): number {
    const key = JSON.stringify(value);
    const at = this.known.get(key) ?? this.values.push(value) - 1;
    this.known.set(key, at);
    return at;
  }
}

function plainNet({ cause, faces, folds, foldable, times, shares }: SavedNet): PlainNet {
  return {
    cause,
    faces: [...faces],
    folds: [...folds],
    foldable,
    times: [...times],
    shares: shares.map((share) => [...share]),
  };
}

export function resultsToJson(states: readonly (SavedState | null)[]): ResultsJson {
  const labels = new Pool<number[]>();
  const nets = new Pool<PlainNet>();
  const plain = states.map((state): PlainState | null => {
    if (!state) return null;
    const { start, ...rest } = state;
    const placed = start.nets.map((net) => {
      const { part, place } = net;
      return { net: nets.add(plainNet(net)), part, ...(place && { place }) };
    });
    return { ...rest, labels: labels.add([...start.labels]), nets: placed, paper: start.paper };
  });
  return { labels: labels.values, nets: nets.values, states: plain };
}

const edge = { from: whole(), to: whole() };
const place = { sheet: whole(), x: finite, y: finite, angle: finite };
const message = record({ code: text, params: isRecord });

const isNet = record({
  cause: oneOf('part', 'no-net', 'no-motion', 'sheet', 'edit'),
  faces: listOf(whole()),
  folds: listOf(whole()),
  foldable: oneOf('line', 'waypoints', 'no', 'unchecked'),
  times: listOf(finite),
  shares: listOf(listOf(finite)),
});

const isStateOfRun = {
  hash: text,
  options: isRecord,
  flapEdges: listOf(
    record({ ...edge, flaps: oneOf('none', 'left', 'right', 'both', 'usual') }, { height: finite }),
  ),
  locks: listOf(record({ ...edge, as: oneOf('fold', 'cut') })),
  names: listOf(record({ part: whole(), name: text })),
  pins: listOf(record({ part: whole(), face: whole(), ...place })),
  labels: whole(),
  nets: listOf(record({ net: whole(), part: whole() }, { place: record(place) })),
  paper: nullOr(record({ scale: finite, sheets: whole(), sheetWidth: finite })),
  told: record({
    search: record({ generations: finite, moves: finite }),
    seconds: recordOf(finite),
    notices: listOf(message),
  }),
};

const isState = record(isStateOfRun, { isStopped: (value) => value === true });

/** A state with the nets and labels that it names; null if it names others than there are. */
function savedState(state: PlainState, { labels, nets }: ResultsJson): SavedState | null {
  const own = labels[state.labels];
  const placed = state.nets.map(({ net, part, place }): SavedNet | null => {
    const plain = nets[net];
    if (!plain) return null;
    return {
      part,
      cause: plain.cause,
      faces: Int32Array.from(plain.faces),
      folds: Int32Array.from(plain.folds),
      foldable: plain.foldable,
      times: Float64Array.from(plain.times),
      shares: plain.shares.map((share) => Float64Array.from(share)),
      ...(place && { place }),
    };
  });
  if (!own || !placed.every((net) => net !== null)) return null;
  const { labels: _, nets: __, paper, ...rest } = state;
  const notices = rest.told.notices.map(({ code, params }): Message => ({ code, params }));
  const start = { labels: Int32Array.from(own), nets: placed, paper };
  return { ...rest, told: { ...rest.told, notices }, start };
}

/** The states in a file, as far as they are sound: so many, in their order. */
export function statesFromJson(value: unknown, count: number): (SavedState | null)[] {
  const none = Array.from({ length: count }, () => null);
  const isList = listOf(listOf(whole()));
  if (!isRecord(value) || !isList(value['labels']) || !listOf(isNet)(value['nets'])) return none;
  const { states } = value;
  if (!Array.isArray(states)) return none;
  return none.map((_, i) =>
    isState(states[i])
      ? savedState(states[i] as PlainState, value as unknown as ResultsJson)
      : null,
  );
}
