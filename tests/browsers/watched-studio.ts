import { mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { SavedFile } from '../e2e/saved-files.js';
import type { Engine, EnginePage } from './engine-page.js';

/** Ms for whatever a test waits for: WebGL and the engine share two cores here. */
const patience = 60_000;

/** The studio in an engine, and what a person does there. */
export class WatchedStudio {
  private constructor(
    private readonly engine: string,
    readonly page: EnginePage,
  ) {}

  static async open(engine: Engine, display: string, address: string): Promise<WatchedStudio> {
    const page = await engine.open(display);
    const studio = new WatchedStudio(engine.name, page);
    try {
      await page.resize(1366, 768);
      await page.goto(address);
      await studio.until('.sample');
    } catch (error) {
      await page.close();
      throw error;
    }
    return studio;
  }

  /** Waits until something is to be seen, and says what is written there. */
  async until(selector: string, words = ''): Promise<string> {
    return this.poll(`${selector} with “${words}”`, () =>
      this.page.evaluate(([name, text]) => window.seen(name, text)[0]?.textContent.trim() ?? null, [
        selector,
        words,
      ] as const),
    );
  }

  /** Waits for an answer that is not null. */
  async poll<Answer>(what: string, ask: () => Promise<Answer | null>): Promise<Answer> {
    const last = Date.now() + patience;
    for (;;) {
      const answer = await ask();
      if (answer !== null) return answer;
      if (Date.now() > last) throw new Error(`${this.engine}: there is no ${what}`);
      await new Promise((done) => setTimeout(done, 50));
    }
  }

  /** Clicks in the middle of what is to be seen first, once nothing lies over it. */
  async click(selector: string, words = ''): Promise<void> {
    const place = await this.poll(`${selector} with “${words}” to click`, () =>
      this.page.evaluate(
        ([name, text]) => {
          const [element] = window.seen(name, text);
          if (!element) return null;
          element.scrollIntoView({ block: 'center', inline: 'center' });
          const { x, y, width, height } = element.getBoundingClientRect();
          const middle = [x + width / 2, y + height / 2] as const;
          const root = element.getRootNode() as ShadowRoot;
          return element.contains(root.elementFromPoint(...middle)) ? middle : null;
        },
        [selector, words] as const,
      ),
    );
    await this.page.click(...place);
  }

  /** Clicks into a field and writes over what is there. */
  async write(selector: string, text: string): Promise<void> {
    await this.click(selector);
    await this.page.evaluate((name) => {
      (window.seen(name)[0] as HTMLInputElement).select();
    }, selector);
    await this.page.press(...text);
  }

  /** Chooses from a list, as a person would: each engine opens a list in a window of its own, which no test reaches. */
  async choose(selector: string, value: string): Promise<void> {
    await this.page.evaluate(
      ([name, wanted]) => {
        const list = window.seen(name)[0] as HTMLSelectElement;
        list.value = wanted;
        for (const type of ['input', 'change']) {
          list.dispatchEvent(new Event(type, { bubbles: true }));
        }
      },
      [selector, value] as const,
    );
  }

  /** Waits for a result other than this one, with all its sheets on the page, and returns its hash. */
  result(before = ''): Promise<string> {
    return this.poll('result', () =>
      this.page.evaluate((other) => {
        const [result] = window.seen('#result');
        const isBusy = window.seen('#progress, #sheets[aria-busy]').length > 0;
        const hash = result?.dataset['hash'] ?? other;
        return isBusy || hash === other ? null : hash;
      }, before),
    );
  }

  /** Presses the button of a format, and returns the file that the page hands to the browser. */
  async save(format: string): Promise<SavedFile> {
    const count = await this.page.evaluate(() => window.saved.length);
    await this.click(`[data-format="${format}"]`);
    const { name, codes } = await this.poll(`file in ${format}`, () =>
      this.page.evaluate(async (index) => {
        const file = window.saved[index];
        if (!file) return null;
        const bytes = new Uint8Array(await file.blob.arrayBuffer());
        return { name: file.name, codes: Array.from(bytes) };
      }, count),
    );
    return { name, bytes: Uint8Array.from(codes) };
  }

  /** Opens a fold, as a click on its summary does. */
  async unfold(selector: string): Promise<void> {
    await this.page.evaluate((name) => {
      (window.seen(name)[0] as HTMLDetailsElement).open = true;
    }, selector);
  }

  /** Scrolls until something is in the middle of the window. */
  async reveal(selector: string): Promise<void> {
    await this.page.evaluate((name) => {
      window.seen(name)[0]!.scrollIntoView({ block: 'center' });
    }, selector);
  }

  /** Where something is in the window, in CSS pixels. */
  placeOf(selector: string): Promise<{ x: number; y: number; width: number; height: number }> {
    return this.page.evaluate((name) => {
      const { x, y, width, height } = window.seen(name)[0]!.getBoundingClientRect();
      return { x, y, width, height };
    }, selector);
  }

  /** By how many pixels the page is wider than the window. */
  overflow(): Promise<number> {
    return this.page.evaluate(() => {
      const { scrollWidth, clientWidth } = document.documentElement;
      return scrollWidth - clientWidth;
    });
  }

  complaints(): Promise<string[]> {
    return this.page.evaluate(() => window.complaints);
  }

  /** Keeps a picture of the window for people to look at. */
  async picture(name: string): Promise<void> {
    const folder = join('build', 'screenshots');
    await mkdir(folder, { recursive: true });
    await writeFile(join(folder, `${this.engine}-${name}.png`), await this.page.screenshot());
  }

  close(): Promise<void> {
    return this.page.close();
  }
}
