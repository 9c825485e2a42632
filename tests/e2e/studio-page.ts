import { mkdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { Browser, BrowserContext, Download, Page } from 'playwright-core';
import { startChromium } from './chromium.js';

/** A canvas that shows nothing has one colour; edges smoothed by the browser make many. */
const few = 20;

/** Ms in which a picture must appear: software takes its time to start WebGL. */
const patience = 20_000;

/** Window sizes that the page is looked at in. */
export const desktop = { width: 1280, height: 800 };
export const phone = { width: 390, height: 844 };

export interface BrowserOptions {
  viewport?: { width: number; height: number };
  colorScheme?: 'light' | 'dark';
  hasTouch?: boolean;
  /** Whether things move by themselves; by default they do not. */
  reducedMotion?: 'reduce' | 'no-preference';
  /** Of a browser of its own, besides those that each gets. */
  flags?: string[];
  /** Runs in the page before its own scripts. */
  script?: string;
  /** Runs in the engine's workers, or others, before their own scripts. */
  workerScript?: string;
  /** Addresses of these workers, if they are not the engine's. */
  workers?: RegExp;
  /** Whether the settings are folded away at the start, as they are for people; else they can be filled in at once. */
  folded?: boolean;
  /** By default there are none: each page would fetch all files of the build, and no test could catch a request. */
  serviceWorkers?: 'allow' | 'block';
}

/** The studio in a context of its own: nothing is kept there from other pages, as in a new profile. */
export class StudioPage {
  /** Errors and warnings of the console, and uncaught errors. */
  readonly complaints: string[] = [];
  /** Addresses of everything that was asked for. */
  readonly requests: string[] = [];

  private constructor(
    readonly page: Page,
    private readonly context: BrowserContext,
    private readonly browser: Browser | null,
  ) {
    page.on('pageerror', (error) => this.complaints.push(String(error)));
    page.on('console', (message) => {
      if (message.text().includes('blocked by Playwright')) return;
      if (message.type() === 'error' || message.type() === 'warning') {
        // Of a file that is missing the text does not say which one.
        this.complaints.push(`${message.text()} (${message.location().url})`);
      }
    });
    context.on('request', (request) => this.requests.push(request.url()));
  }

  /** @param shared the browser; without it one is started, which ends with the studio */
  static async open(
    address: string,
    {
      flags,
      script,
      workerScript,
      workers = /\/worker-[^/]*\.js$/,
      folded = false,
      ...options
    }: BrowserOptions = {},
    shared?: Browser,
  ): Promise<StudioPage> {
    const own = shared ? null : await startChromium(flags);
    const context = await (shared ?? own!).newContext({
      viewport: desktop,
      reducedMotion: 'reduce',
      serviceWorkers: 'block',
      ...options,
    });
    const studio = new StudioPage(await context.newPage(), context, own);
    if (script) await context.addInitScript(script);
    if (workerScript) {
      await context.route(workers, async (route) => {
        const response = await route.fetch();
        await route.fulfill({ response, body: workerScript + (await response.text()) });
      });
    }
    await studio.page.goto(address);
    // Either the samples are there or the page says why not.
    await studio.page.locator('.sample, #message:not([hidden])').first().waitFor();
    if (!folded) await studio.unfoldSettings();
    return studio;
  }

  /** The same studio in another tab. */
  async anotherTab(): Promise<StudioPage> {
    const page = await this.context.newPage();
    const tab = new StudioPage(page, this.context, null);
    await page.goto(this.page.url());
    await page.locator('.sample, #message:not([hidden])').first().waitFor();
    return tab;
  }

  /** Ends the page as if its process had died, and opens the studio again in another one. */
  async crash(): Promise<StudioPage> {
    const tab = await this.context.newPage();
    const address = this.page.url();
    const devtools = await this.context.newCDPSession(this.page);
    // Never answered: there is nobody left who could.
    void devtools.send('Page.crash').catch(() => undefined);
    await this.page.waitForEvent('crash');
    const studio = new StudioPage(tab, this.context, null);
    await tab.goto(address);
    await tab.locator('.sample, #message:not([hidden])').first().waitFor();
    return studio;
  }

  /** Opens the settings of all studios, as people do who have wishes. */
  async unfoldSettings(): Promise<void> {
    await this.page.locator('foldwright-studio').evaluateAll((studios) => {
      for (const { shadowRoot } of studios) {
        const folds = shadowRoot!.querySelectorAll<HTMLDetailsElement>('#settings, #more, #print');
        for (const fold of folds) fold.open = true;
      }
    });
  }

  /** Shows one of the tabs of a small window. */
  async showTab(name: 'Model' | 'Sheets' | 'Build' | 'Save'): Promise<void> {
    await this.page.getByRole('tab', { name, exact: true }).click();
  }

  async close(): Promise<void> {
    await this.context.close();
    await this.browser?.close();
  }

  /** Chooses a file, as with the file picker. */
  async choose(name: string, content: string | Buffer): Promise<void> {
    const buffer = Buffer.from(content);
    await this.page.setInputFiles('#file', { name, mimeType: 'application/octet-stream', buffer });
  }

  /** Chooses several files at once, as with the file picker. */
  async chooseTogether(files: { name: string; content: string | Uint8Array }[]): Promise<void> {
    const mimeType = 'application/octet-stream';
    const payloads = files.map(({ name, content }) => {
      return { name, mimeType, buffer: Buffer.from(content) };
    });
    await this.page.setInputFiles('#file', payloads);
  }

  /** Drops a folder of this device on the page. */
  async dropFolder(path: string): Promise<void> {
    const devtools = await this.context.newCDPSession(this.page);
    const data = { items: [], files: [path], dragOperationsMask: 1 };
    const where = { x: 300, y: 300 };
    for (const type of ['dragEnter', 'dragOver', 'drop'] as const) {
      await devtools.send('Input.dispatchDragEvent', { type, ...where, data });
    }
    await devtools.detach();
  }

  /** Drops files on the page, as from a file manager. */
  async drop(files: { name: string; content: string | Uint8Array }[]): Promise<void> {
    const listed = files.map(({ name, content }) => ({ name, bytes: [...Buffer.from(content)] }));
    await this.page.evaluate((dropped) => {
      const data = new DataTransfer();
      for (const { name, bytes } of dropped) {
        data.items.add(new File([Uint8Array.from(bytes)], name));
      }
      const event = { dataTransfer: data, bubbles: true, cancelable: true };
      document.body.dispatchEvent(new DragEvent('dragenter', event));
      document.body.dispatchEvent(new DragEvent('drop', event));
    }, listed);
  }

  async chooseSample(name: string): Promise<void> {
    await this.page.getByRole('button', { name, exact: true }).click();
  }

  /** Waits for all of the result of the model with this name and returns its hash. */
  async resultOf(name: string): Promise<string> {
    await this.page.locator('#result-title', { hasText: name }).waitFor({ timeout: 60_000 });
    await this.page.locator('#progress').waitFor({ state: 'hidden', timeout: 60_000 });
    // What follows the last sheet, such as words about the end, is there then, too.
    await this.page.locator('#sheets[aria-busy]').waitFor({ state: 'detached', timeout: 60_000 });
    return (await this.page.locator('#result').getAttribute('data-hash')) ?? '';
  }

  /** Waits until the page says that it needs no network any more. */
  async keptOffline(): Promise<void> {
    await this.page.getByText('Ready offline').waitFor({ timeout: 60_000 });
  }

  /** Presses a download button and returns the file's name and bytes. */
  async download(format: string): Promise<{ name: string; bytes: Buffer }> {
    const [download]: [Download, void] = await Promise.all([
      this.page.waitForEvent('download'),
      this.page.getByRole('button', { name: format, exact: true }).click(),
    ]);
    return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
  }

  /** What the message says; waits for one. */
  async message(): Promise<string> {
    await this.page.locator('#message').waitFor();
    return this.page.locator('#message-words').innerText();
  }

  /** Waits until a canvas shows a picture. */
  async drawn(selector: string): Promise<void> {
    const last = Date.now() + patience;
    while ((await this.coloursOf(selector)).size <= few) {
      if (Date.now() > last) throw new Error(`${selector} stays empty`);
    }
  }

  /** The colours that an element shows on the screen, as red, green and blue, and how many pixels have each. */
  async coloursOf(selector: string): Promise<ReadonlyMap<number, number>> {
    const shot = await this.page.locator(selector).screenshot();
    const counts = await this.page.evaluate(
      async (source) => {
        const image = new Image();
        image.src = source;
        await image.decode();
        const canvas = new OffscreenCanvas(image.width, image.height);
        const context = canvas.getContext('2d');
        context?.drawImage(image, 0, 0);
        const { data } = context!.getImageData(0, 0, image.width, image.height);
        const found = new Map<number, number>();
        for (let at = 0; at < data.length; at += 4) {
          const colour = (data[at]! << 16) | (data[at + 1]! << 8) | data[at + 2]!;
          found.set(colour, (found.get(colour) ?? 0) + 1);
        }
        return [...found];
      },
      `data:image/png;base64,${shot.toString('base64')}`,
    );
    return new Map(counts);
  }

  /** Keeps a picture of the whole page for people to look at. */
  async picture(name: string): Promise<void> {
    const folder = join('build', 'screenshots');
    await mkdir(folder, { recursive: true });
    await this.page.screenshot({ path: join(folder, `${name}.png`), fullPage: true });
  }
}
