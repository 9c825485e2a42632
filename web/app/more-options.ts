import { defaultOptions } from '../model/default-options.js';
import type { FoldingMode, Heuristic, Segmenter, Solver } from '../model/job-options.js';
import type { Settings } from '../model/options.js';
import { FacesField } from './faces-field.js';
import { MendFields } from './mend-fields.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

/** What this part of the form decides. */
export type Method = Pick<
  Settings,
  | 'solver'
  | 'seed'
  | 'segment'
  | 'heuristic'
  | 'runs'
  | 'faces'
  | 'repair'
  | 'fill-holes'
  | 'inside'
  | 'crossing'
  | 'proxy'
  | 'folding'
>;

const solvers: readonly Solver[] = ['tree', 'genetic'];
const segmenters: readonly Segmenter[] = ['merge', 'spectral'];
const heuristics: readonly Heuristic[] = ['steepest', 'flat', 'hybrid', 'random'];
const foldingModes: readonly FoldingMode[] = ['prefer', 'require', 'off'];

/** The value of a list; the default where a browser has kept one that exists no more. */
function chosen<Value extends string>(
  list: HTMLSelectElement,
  values: readonly Value[],
  fallback: Value,
): Value {
  return values.find((value) => value === list.value) ?? fallback;
}

/** The number in a field, or the default where the field is empty. */
function amount(field: HTMLInputElement, fallback: number): number {
  return field.value === '' ? fallback : field.valueAsNumber;
}

/** The fields for how parts and nets are found. */
export class MoreOptions extends Panel {
  private readonly solver = this.find('#solver', HTMLSelectElement);
  private readonly hint = this.find('#solver-hint', HTMLElement);
  readonly seed = this.find('#seed', HTMLInputElement);
  private readonly segment = this.find('#segment', HTMLSelectElement);
  private readonly heuristic = this.find('#heuristic', HTMLSelectElement);
  private readonly runs = this.find('#runs', HTMLInputElement);
  readonly faces = new FacesField(this.place);
  readonly mending = new MendFields(this.place);
  private readonly proxy = this.find('#proxy', HTMLInputElement);
  private readonly folding = this.find('#folding-mode', HTMLSelectElement);
  private readonly foldingHint = this.find('#folding-hint', HTMLElement);

  constructor(place: StudioPlace) {
    super(place);
    this.seed.placeholder = String(defaultOptions.seed);
    this.runs.placeholder = String(defaultOptions.runs);
    this.proxy.placeholder = String(defaultOptions.proxy);
    for (const list of [this.solver, this.folding]) {
      list.addEventListener('change', () => this.explain());
    }
    this.explain();
    // A field that makes no sense cannot be pointed at while it is folded away.
    const more = this.find('#more', HTMLDetailsElement);
    more.addEventListener('invalid', () => (more.open = true), true);
  }

  /** What the fields say now. */
  read(): Method {
    return {
      solver: this.chosenSolver(),
      seed: amount(this.seed, defaultOptions.seed),
      segment: chosen(this.segment, segmenters, defaultOptions.segment),
      heuristic: chosen(this.heuristic, heuristics, defaultOptions.heuristic),
      runs: amount(this.runs, defaultOptions.runs),
      faces: this.faces.value,
      ...this.mending.value,
      proxy: amount(this.proxy, defaultOptions.proxy),
      folding: this.chosenFolding(),
    };
  }

  private chosenSolver(): Solver {
    return chosen(this.solver, solvers, defaultOptions.solver);
  }

  private chosenFolding(): FoldingMode {
    return chosen(this.folding, foldingModes, defaultOptions.folding);
  }

  private explain(): void {
    const { folding, solver } = this.told.form;
    this.hint.textContent = solver[this.chosenSolver()];
    this.foldingHint.textContent = folding[this.chosenFolding()];
  }
}
