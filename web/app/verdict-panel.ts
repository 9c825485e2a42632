import { hasPlaces } from '../model/finding-places.js';
import { remediesFor, type Remedy } from '../model/remedies.js';
import { conclusionOf, findingsOn, type Finding, type Level } from '../model/verdict.js';
import { findingWords, type VerdictWords } from '../words/verdict.js';
import { make } from './dom.js';
import type { FinishedRun } from './finished-run.js';
import { Panel } from './panel.js';
import type { StudioPlace } from './place.js';
import { isHopeless } from './result-words.js';
import type { Store } from './store.js';

export interface VerdictListener {
  /** Goes to the next place of what was found. */
  show(finding: Finding): void;
  /** Does what helps. */
  mend(remedy: Remedy): void;
}

/** A sign tells a level as its colour does, and a word to those who see neither. */
const signs: Readonly<Record<Level, string>> = { green: '✓', amber: '!', red: '✕' };

/** The sign of a level, and its word. */
function levelSign({ levels }: VerdictWords, level: Level): HTMLElement[] {
  const shape = make('span', { className: `sign sign--${level}`, textContent: signs[level] });
  shape.setAttribute('aria-hidden', 'true');
  return [shape, make('span', { className: 'visually-hidden', textContent: `${levels[level]} ` })];
}

/** Whether a result can be built, what stands against it, where that is, and what helps. */
export class VerdictPanel extends Panel {
  private readonly panel = this.find('#verdict', HTMLElement);
  private readonly title = this.find('#verdict-title', HTMLElement);
  private readonly lead = this.find('#result-lead', HTMLElement);
  private readonly rows = this.find('#verdict-rows', HTMLUListElement);
  private readonly good = this.find('#verdict-good', HTMLDetailsElement);
  private readonly goodTitle = this.find('#verdict-good-title', HTMLElement);
  private readonly goodRows = this.find('#verdict-good-rows', HTMLUListElement);

  constructor(
    place: StudioPlace,
    private readonly store: Store,
    private readonly listener: VerdictListener,
  ) {
    super(place);
    store.on('work', () => this.wait());
  }

  /** Judges another result. */
  offer({ result, settings }: FinishedRun): void {
    const findings = findingsOn(result, settings.margin);
    const conclusion = conclusionOf(findings);
    const row = (finding: Finding): HTMLLIElement => {
      const buttons = [
        ...(hasPlaces(finding) ? [this.showButton(finding)] : []),
        ...remediesFor(finding, { result, settings }).map((remedy) => this.mendButton(remedy)),
      ];
      return this.row(finding, buttons);
    };
    const { verdict: told } = this.told;
    const hasFocus = this.rows.matches(':focus-within');
    const bad = findings.filter(({ level }) => level !== 'green');
    const good = findings.filter(({ level }) => level === 'green');
    this.title.replaceChildren(
      ...levelSign(told, conclusion.level),
      told.headline(conclusion, bad.length),
    );
    // What cannot be built has no words of success.
    this.lead.hidden = isHopeless(result, conclusion);
    this.rows.replaceChildren(...bad.map(row));
    this.good.hidden = good.length === 0;
    this.goodTitle.textContent = told.good(good.length);
    this.goodRows.replaceChildren(...good.map(row));
    this.wait();
    // The button that was pressed may be gone, and what came of it is told at the top.
    if (!hasFocus) return;
    this.panel.focus({ preventScroll: true });
    this.title.scrollIntoView({ block: 'nearest' });
  }

  private row(finding: Finding, buttons: HTMLButtonElement[]): HTMLLIElement {
    const { title, hint } = findingWords(this.told.verdict, finding);
    const words = [make('strong', { textContent: title })];
    if (hint !== '') words.push(make('span', { className: 'finding__hint', textContent: hint }));
    const item = make(
      'li',
      { className: 'finding' },
      ...levelSign(this.told.verdict, finding.level),
    );
    item.append(make('span', { className: 'finding__words' }, ...words));
    if (buttons.length > 0)
      item.append(make('span', { className: 'finding__buttons' }, ...buttons));
    item.dataset['code'] = finding.code;
    return item;
  }

  private showButton(finding: Finding): HTMLButtonElement {
    const button = make('button', {
      type: 'button',
      className: 'button',
      textContent: this.told.edges.show,
    });
    button.setAttribute(
      'aria-label',
      this.told.edges.showWhat(findingWords(this.told.verdict, finding).title),
    );
    button.addEventListener('click', () => this.listener.show(finding));
    return button;
  }

  private mendButton(remedy: Remedy): HTMLButtonElement {
    const textContent = this.told.verdict.remedy(remedy);
    const button = make('button', { type: 'button', className: 'button', textContent });
    button.dataset['mends'] = remedy.kind;
    button.addEventListener('click', () => {
      if (button.getAttribute('aria-disabled') !== 'true') this.listener.mend(remedy);
    });
    return button;
  }

  /** While parts change their numbers, nothing is mended. */
  private wait(): void {
    for (const button of this.rows.querySelectorAll('[data-mends]')) {
      button.setAttribute('aria-disabled', String(this.store.busy));
    }
  }
}
