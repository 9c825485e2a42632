import { flapShade, lookOf } from '../export/line-style.js';
import {
  defaultPrint,
  dpiRange,
  isCalibrated,
  measurable,
  rulerLength,
  thicknessRange,
  type LineKind,
  type LineStyle,
  type Machine,
  type PrintOptions,
  type PrintStyle,
} from '../model/print-options.js';
import { printOptions, type Settings } from '../model/options.js';
import { ColourFields } from './colour-fields.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';

const styles: readonly PrintStyle[] = ['foldwright', 'pepakura', 'blender'];
const machines: readonly Machine[] = ['none', 'silhouette', 'cricut', 'generic'];
const kinds: readonly LineKind[] = ['cut', 'mountain', 'valley'];

/** Where the lengths that were measured are kept from one visit to the next. */
const memory = 'foldwright.measured';

/** The fields of one kind of line. */
interface LineFields {
  width: HTMLInputElement;
  colour: HTMLInputElement;
  /** Folds only: cuts are solid. */
  dash: HTMLInputElement | null;
  /** Shows what they come to. */
  sample: SVGPathElement;
}

/** '1.5 0.8' as lengths; null if it is none, or not a dash and a gap in turn. */
function parseDash(text: string): number[] | null {
  const words = text.split(/[\s,;]+/).filter((word) => word !== '');
  const lengths = words.map(Number);
  const makesSense = lengths.every((length) => length >= 0.05 && length <= 50);
  return makesSense && lengths.length % 2 === 0 ? lengths : null;
}

function number(field: HTMLInputElement, fallback: number): number {
  return field.value !== '' && field.validity.valid ? field.valueAsNumber : fallback;
}

/** The fields beside the sheets, for how they are drawn: every change shows at once. */
export class PrintPanel extends Panel {
  /** Called while something is changed. */
  onPreview: () => void = () => undefined;
  /** Called when a change is complete. */
  onChange: () => void = () => undefined;

  private readonly panel = this.find('#print', HTMLElement);
  private readonly colours = new ColourFields(this.place);
  private readonly style = this.find('#print-style', HTMLSelectElement);
  private readonly shaded = this.find('#print-flaps', HTMLInputElement);
  private readonly flatFold = this.find('#print-flat-fold', HTMLInputElement);
  private readonly thickness = this.find('#print-thickness', HTMLInputElement);
  private readonly ticks = this.find('#print-ticks', HTMLInputElement);
  private readonly backs = this.find('#print-backs', HTMLInputElement);
  private readonly angles = this.find('#print-angles', HTMLInputElement);
  private readonly legend = this.find('#print-legend', HTMLInputElement);
  private readonly assembly = this.find('#print-assembly', HTMLInputElement);
  private readonly machine = this.find('#print-machine', HTMLSelectElement);
  private readonly machineHint = this.find('#machine-hint', HTMLElement);
  private readonly dpi = this.find('#print-dpi', HTMLInputElement);
  private readonly printer = this.find('#measured', HTMLFieldSetElement);
  private readonly across = this.find('#measured-across', HTMLInputElement);
  private readonly up = this.find('#measured-up', HTMLInputElement);
  private readonly state = this.find('#measured-state', HTMLElement);
  private readonly badge = this.find('#measured-badge', HTMLElement);
  private readonly lines: Readonly<Record<LineKind, LineFields>>;

  constructor(place: StudioPlace) {
    super(place);
    const fields = (kind: LineKind): LineFields => ({
      width: this.find(`#${kind}-width`, HTMLInputElement),
      colour: this.find(`#${kind}-colour`, HTMLInputElement),
      dash: kind === 'cut' ? null : this.find(`#${kind}-dash`, HTMLInputElement),
      sample: this.find(`#${kind}-sample`, SVGPathElement),
    });
    this.lines = { cut: fields('cut'), mountain: fields('mountain'), valley: fields('valley') };
    Object.assign(this.dpi, {
      min: dpiRange.least,
      max: dpiRange.most,
      placeholder: defaultPrint.dpi,
    });
    this.flatFold.placeholder = String(defaultPrint.flatFold);
    Object.assign(this.thickness, { min: thicknessRange.least, max: thicknessRange.most });
    for (const field of [this.across, this.up]) {
      Object.assign(field, {
        min: measurable.least,
        max: measurable.most,
        placeholder: rulerLength,
      });
    }
    this.recall();
    this.fillIn();
    this.explain();
    this.style.addEventListener('input', () => this.fillIn());
    // What comes with a file stands where it is downloaded.
    for (const place of [this.panel, this.assembly]) {
      place.addEventListener('input', () => this.preview());
      place.addEventListener('change', () => this.onChange());
    }
    this.find('#measured-reset', HTMLButtonElement).addEventListener('click', () => {
      this.across.value = this.up.value = '';
      this.preview();
    });
  }

  /** What the rulers measure: a printer's, and so of no document. */
  get measured(): PrintOptions['measured'] {
    return [number(this.across, rulerLength), number(this.up, rulerLength)];
  }

  /**
   * Shows how the sheets of a document look.
   *
   * @param hasLooks whether the model has colours or pictures
   */
  fill(settings: Settings, hasLooks: boolean): void {
    const options = printOptions(settings);
    // The fields are those of a print for scissors: lines for machines are as they are.
    const look = lookOf({ ...options, machine: 'none' });
    this.style.value = options.style;
    for (const kind of kinds) this.fillLines(kind, look.lines[kind]);
    this.shaded.checked = look.flaps !== 'none';
    const { flatFold, thickness } = options;
    this.flatFold.value = flatFold === defaultPrint.flatFold ? '' : String(flatFold);
    this.thickness.value = thickness === defaultPrint.thickness ? '' : String(thickness);
    this.ticks.checked = options.foldTicks;
    this.backs.checked = options.duplex;
    this.angles.checked = options.foldAngles;
    this.legend.checked = options.legend;
    this.assembly.checked = options.assembly;
    this.machine.value = options.machine;
    this.colours.fill(options, hasLooks);
    this.dpi.value = options.dpi === defaultPrint.dpi ? '' : String(options.dpi);
    this.check();
    this.explain();
  }

  /** What the fields say now; the default where one makes no sense. */
  read(): PrintOptions {
    const style = this.chosenStyle();
    const look = lookOf({ ...defaultPrint, style });
    const lines: Partial<Record<LineKind, Partial<LineStyle>>> = {};
    for (const kind of kinds) lines[kind] = this.differing(kind, look.lines[kind]);
    return {
      language: this.told.code,
      style,
      lines,
      ...(this.shaded.checked !== (look.flaps !== 'none') && {
        flaps: this.shaded.checked ? flapShade : 'none',
      }),
      flatFold: number(this.flatFold, defaultPrint.flatFold),
      thickness: number(this.thickness, defaultPrint.thickness),
      foldTicks: this.ticks.checked,
      duplex: this.backs.checked,
      foldAngles: this.angles.checked,
      legend: this.legend.checked,
      assembly: this.assembly.checked,
      measured: this.measured,
      machine: machines.find((name) => name === this.machine.value) ?? defaultPrint.machine,
      dpi: number(this.dpi, defaultPrint.dpi),
      ...this.colours.read(),
    };
  }

  private chosenStyle(): PrintStyle {
    return styles.find((name) => name === this.style.value) ?? defaultPrint.style;
  }

  /** What the fields of a kind say that its style does not. */
  private differing(kind: LineKind, base: LineStyle): Partial<LineStyle> {
    const { width, colour, dash } = this.lines[kind];
    const wished: LineStyle = {
      width: number(width, base.width),
      colour: colour.value,
      dash: (dash && parseDash(dash.value)) ?? base.dash,
    };
    return {
      ...(wished.width !== base.width && { width: wished.width }),
      ...(wished.colour !== base.colour && { colour: wished.colour }),
      ...(wished.dash.join() !== base.dash.join() && { dash: wished.dash }),
    };
  }

  /** Shows what the style is made of. */
  private fillIn(): void {
    const look = lookOf({ ...defaultPrint, style: this.chosenStyle() });
    for (const kind of kinds) this.fillLines(kind, look.lines[kind]);
    this.shaded.checked = look.flaps !== 'none';
  }

  private fillLines(kind: LineKind, { width, colour, dash }: LineStyle): void {
    const fields = this.lines[kind];
    fields.width.value = String(width);
    fields.colour.value = colour;
    if (fields.dash) fields.dash.value = dash.join(' ');
  }

  /** Marks the fields that make no sense. */
  private check(): void {
    for (const kind of kinds) {
      const { dash } = this.lines[kind];
      dash?.setAttribute('aria-invalid', String(parseDash(dash.value) === null));
    }
    for (const field of this.panel.querySelectorAll<HTMLInputElement>('[type=number]')) {
      field.setAttribute('aria-invalid', String(!field.validity.valid));
    }
  }

  private preview(): void {
    this.check();
    this.remember();
    this.explain();
    this.onPreview();
  }

  /** Shows what lines look like, and says clearly whether sheets are corrected. */
  private explain(): void {
    const options = this.read();
    const { printing: told, speech } = this.told;
    const { lines } = lookOf(options);
    for (const kind of kinds) {
      const { sample } = this.lines[kind];
      sample.setAttribute('stroke', lines[kind].colour);
      sample.setAttribute('stroke-width', String(lines[kind].width));
      sample.setAttribute('stroke-dasharray', lines[kind].dash.join(' ') || 'none');
    }
    this.colours.explain(options);
    this.machineHint.textContent = told.machine[options.machine];
    for (const field of [
      this.style,
      this.shaded,
      this.ticks,
      this.backs,
      this.legend,
      this.printer,
    ]) {
      field.disabled = options.machine !== 'none';
    }
    const isOn = isCalibrated(options);
    const words = options.measured.map((length) => {
      const share = Math.abs(100 * (rulerLength / length - 1));
      const percent = speech.fixed(share, 1);
      return length < rulerLength ? told.longer(percent) : told.shorter(percent);
    }) as [string, string];
    this.state.textContent = isOn ? told.correcting(...words) : told.notCorrecting;
    this.badge.hidden = !isOn;
    this.badge.textContent = told.corrected(...options.measured);
  }

  private remember(): void {
    const { measured } = this.read();
    try {
      localStorage.setItem(memory, JSON.stringify(measured));
    } catch {
      // A browser that keeps nothing is no reason to fail.
    }
  }

  private recall(): void {
    try {
      const kept: unknown = JSON.parse(localStorage.getItem(memory) ?? 'null');
      if (!Array.isArray(kept)) return;
      [this.across, this.up].forEach((field, i) => {
        const value: unknown = kept[i];
        if (typeof value === 'number' && value !== rulerLength) field.value = String(value);
      });
    } catch {
      // Whatever else is kept under this name is not ours.
    }
  }
}
