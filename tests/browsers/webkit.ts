/** WebKit in its GTK build, through the WebDriver that comes with it: the few commands of the W3C's protocol that are needed. */
import { spawn, type ChildProcess } from 'node:child_process';
import { createServer } from 'node:net';
import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import type { Engine, EnginePage } from './engine-page.js';

/** Ms for the driver to answer at all. */
const patience = 10_000;
/** Ms for a function that runs in the page. */
const scriptLimit = 60_000;

/** The private-use code points by which the protocol names keys. */
const keyCodes: Record<string, string> = { Enter: '\uE007', Tab: '\uE004', Escape: '\uE00C' };

/** The browser that the library brings for tests; it lies in a folder of the machine's architecture. */
function browserPath(): string {
  const folders = readdirSync('/usr/lib').map((name) => join('/usr/lib', name, 'webkit2gtk-4.1'));
  const browser = folders.map((folder) => join(folder, 'MiniBrowser')).find(existsSync);
  if (!browser) throw new Error('There is no MiniBrowser of WebKitGTK below /usr/lib');
  return browser;
}

function freePort(): Promise<number> {
  return new Promise((resolve, reject) => {
    const server = createServer().once('error', reject);
    server.listen(0, '127.0.0.1', () => {
      const { port } = server.address() as { port: number };
      server.close(() => resolve(port));
    });
  });
}

type Command = <Value = unknown>(path: string, body?: object) => Promise<Value>;

/** Sends commands to an address: with a body by POST, without one by GET. */
function commandsTo(address: string): Command {
  return async <Value>(path: string, body?: object) => {
    const request = body && { method: 'POST', body: JSON.stringify(body) };
    const response = await fetch(address + path, request);
    const { value } = (await response.json()) as { value: Value & { message?: string } };
    if (!response.ok) throw new Error(`${path}: ${value.message}`);
    return value as Value;
  };
}

async function untilReady(command: Command): Promise<void> {
  const last = Date.now() + patience;
  for (;;) {
    const isReady = await command<{ ready: boolean }>('/status').then(
      ({ ready }) => ready,
      () => false,
    );
    if (isReady) return;
    if (Date.now() > last) throw new Error('WebKitWebDriver does not answer');
    await new Promise((done) => setTimeout(done, 50));
  }
}

/** What the page answers, or why it does not. */
type Outcome<Result> = { result: Result } | { fault: string };

class WebKitPage implements EnginePage {
  constructor(
    private readonly driver: ChildProcess,
    private readonly command: Command,
    private readonly end: () => Promise<unknown>,
  ) {}

  async goto(url: string): Promise<void> {
    await this.command('/url', { url });
  }

  async reload(): Promise<void> {
    await this.command('/refresh', {});
  }

  async evaluate<Result, Argument = undefined>(
    body: (argument: Argument) => Result | Promise<Result>,
    argument?: Argument,
  ): Promise<Result> {
    const script = `const [argument, done] = arguments;
      (async () => (${String(body)})(argument))()
        .then((result) => done({ result }), (error) => done({ fault: String(error) }));`;
    const args = [argument ?? null];
    const outcome = await this.command<Outcome<Result>>('/execute/async', { script, args });
    if ('fault' in outcome) throw new Error(outcome.fault);
    return outcome.result;
  }

  async click(x: number, y: number): Promise<void> {
    const actions = [
      { type: 'pointerMove', x: Math.round(x), y: Math.round(y), duration: 0 },
      { type: 'pointerDown', button: 0 },
      { type: 'pointerUp', button: 0 },
    ];
    await this.act({ type: 'pointer', id: 'mouse', actions });
  }

  async press(...keys: string[]): Promise<void> {
    const actions = keys
      .map((key) => keyCodes[key] ?? key)
      .flatMap((value) => ['keyDown', 'keyUp'].map((type) => ({ type, value })));
    await this.act({ type: 'key', id: 'keyboard', actions });
  }

  async resize(width: number, height: number): Promise<void> {
    await this.command('/window/rect', { width, height });
  }

  async screenshot(): Promise<Uint8Array> {
    return Buffer.from(await this.command<string>('/screenshot'), 'base64');
  }

  async close(): Promise<void> {
    await this.end();
    this.driver.kill();
  }

  private async act(source: object): Promise<void> {
    await this.command('/actions', { actions: [source] });
  }
}

async function open(display: string): Promise<EnginePage> {
  const port = await freePort();
  const env = { ...process.env, DISPLAY: display };
  const driver = spawn('WebKitWebDriver', [`--port=${port}`], { env, stdio: 'ignore' });
  const root = `http://127.0.0.1:${port}`;
  await untilReady(commandsTo(root));
  const browser = {
    binary: browserPath(),
    // Without its bars, which would not let the window become as narrow as a phone.
    args: ['--automation', '--full-screen'],
  };
  const { sessionId } = await commandsTo(root)<{ sessionId: string }>('/session', {
    capabilities: {
      alwaysMatch: { 'webkitgtk:browserOptions': browser, timeouts: { script: scriptLimit } },
    },
  });
  const session = `${root}/session/${sessionId}`;
  return new WebKitPage(driver, commandsTo(session), () => fetch(session, { method: 'DELETE' }));
}

export const webkit: Engine = { name: 'webkit', open };
