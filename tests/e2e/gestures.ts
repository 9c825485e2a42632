/** Random gestures of a person at the bench, from a seed. */
import type { Locator, Page } from 'playwright-core';
import { Dice } from '../web/random-edits.js';
import { pointInside } from './sheet-points.js';
import type { StudioPage } from './studio-page.js';

/** Buttons that end the work on the page, or leave it. */
const leaving = /^(?:Close|Show me how)/;

/** Pixels that a piece is dragged by at most, to either side. */
const reach = 60;

/** What a person did, in words. */
export type Deed = string;

/** A person who does whatever the page offers. */
export class Gestures {
  private readonly dice: Dice;
  private readonly page: Page;

  constructor({ page }: StudioPage, seed: number) {
    this.dice = new Dice(seed);
    this.page = page;
  }

  /** Does something, waits until the page is done with it, and says what it was. */
  async next(): Promise<Deed> {
    const deeds = [
      () => this.find(),
      () => this.press('#edge-card button, #piece-card button'),
      () => this.press('#edge-card button, #piece-card button'),
      () => this.press('#parts-list button, #split, #merge'),
      () => this.press('#undo, #redo'),
      () => this.drag(),
      () => this.select('#print-style, #ids, #flap-side, #flap-style, #paper, #piece-sheet'),
      () => this.rename(),
      () => this.key(),
    ];
    const deed = (await this.dice.of(deeds)()) ?? 'nothing: there was none';
    await this.settle();
    return deed;
  }

  /** Takes back all that can be taken back. */
  async undoAll(): Promise<void> {
    const undo = this.page.locator('#undo');
    while (await undo.isVisible()) {
      await undo.click();
      await this.settle();
    }
  }

  /** Waits until what was begun is on the page. */
  private async settle(): Promise<void> {
    const patience = { timeout: 60_000 };
    // Changes of fields and of pieces wait for more of their kind.
    await this.page.waitForTimeout(400);
    await this.page.locator('#progress').waitFor({ state: 'hidden', ...patience });
    await this.page.locator('#sheets[aria-busy]').waitFor({ state: 'detached', ...patience });
  }

  /** Those that are seen and can be used. */
  private async usable(selector: string): Promise<Locator[]> {
    const all = await this.page.locator(selector).all();
    const checked = await Promise.all(
      all.map(async (one) => ((await one.isVisible()) && (await one.isEnabled()) ? [one] : [])),
    );
    return checked.flat();
  }

  private async some(selector: string): Promise<Locator | null> {
    const usable = await this.usable(selector);
    return usable.length > 0 ? this.dice.of(usable) : null;
  }

  private async find(): Promise<Deed | null> {
    const texts = await this.page.locator('.sheet text').allTextContents();
    const numbers = texts.filter((text) => /^[A-Z]?\d*$/.test(text) && text !== '');
    if (numbers.length === 0) return null;
    const number = this.dice.of(numbers);
    await this.page.fill('#edge-number', number);
    await this.page.locator('#edge-number').press('Enter');
    return `looked for ${number}`;
  }

  private async press(selector: string): Promise<Deed | null> {
    const button = await this.some(selector);
    if (!button) return null;
    const name = ((await button.getAttribute('aria-label')) ?? (await button.innerText())).trim();
    if (leaving.test(name)) return null;
    await button.click();
    return `pressed “${name}”`;
  }

  private async drag(): Promise<Deed | null> {
    const names = await this.page
      .locator('.sheet [data-area]')
      .evaluateAll((areas) => areas.map((area) => area.getAttribute('data-area')!));
    if (names.length === 0) return null;
    const name = this.dice.of(names);
    let place: [number, number];
    try {
      place = await pointInside(this.page, `.sheet [data-area="${name}"]`);
    } catch {
      return null; // too thin to be held
    }
    const [x, y] = place;
    const way = (): number => reach * (2 * this.dice.roll() - 1);
    const [dx, dy] = [way(), way()];
    await this.page.mouse.down();
    await this.page.mouse.move(x + dx, y + dy, { steps: 3 });
    await this.page.mouse.up();
    return `dragged ${name} by ${Math.round(dx)}, ${Math.round(dy)}`;
  }

  private async select(selector: string): Promise<Deed | null> {
    const list = await this.some(selector);
    if (!list) return null;
    const values = await list
      .locator('option')
      .evaluateAll((options) => options.map((option) => (option as HTMLOptionElement).value));
    // Other sizes of paper than these ask for a size.
    const value = this.dice.of(values.filter((one) => one !== 'custom'));
    await list.selectOption(value);
    return `chose ${value} of ${await list.getAttribute('id')}`;
  }

  private async rename(): Promise<Deed | null> {
    const field = await this.some('#piece-name, .part__name input');
    if (!field) return null;
    const name = `P${this.dice.below(1000)}`;
    await field.fill(name);
    await field.press('Enter');
    return `named it ${name}`;
  }

  private async key(): Promise<Deed> {
    const key = this.dice.of([
      'Escape',
      'Control+z',
      'Control+Shift+z',
      'r',
      'Shift+r',
      'ArrowLeft',
    ]);
    await this.page.keyboard.press(key);
    return `hit ${key}`;
  }
}
