/** Counts what a page holds that no collector of garbage takes away. */
import type { CDPSession, Page, Worker } from 'playwright-core';

/** What `watchResources` notes, in the page as in its workers that draw. */
interface Noted {
  contexts: WebGL2RenderingContext[];
  /** Objects of the graphics card that were made and not deleted, by their kinds. */
  held: Record<string, number>;
  /** Blobs by their addresses, which were not given back. */
  blobs: Map<string, Blob>;
}

declare global {
  var noted: Noted;
  var lossOf: WEBGL_lose_context;
}

/** Goes into page and worker as text, before their own scripts. */
function noteResources(): void {
  const note: Noted = { contexts: [], held: {}, blobs: new Map() };
  globalThis.noted = note;
  const canvases = [globalThis.HTMLCanvasElement, globalThis.OffscreenCanvas].filter(Boolean);
  for (const { prototype } of canvases as { prototype: object }[]) {
    const getContext = Reflect.get(prototype, 'getContext') as (kind: string) => unknown;
    Reflect.set(prototype, 'getContext', function (this: unknown, ...asked: [string]) {
      const context = getContext.apply(this, asked);
      const isNew = context instanceof WebGL2RenderingContext && !note.contexts.includes(context);
      if (isNew) note.contexts.push(context);
      return context;
    });
  }
  for (const kind of ['Buffer', 'Texture', 'VertexArray', 'Program', 'Shader']) {
    for (const [name, step] of [
      [`create${kind}`, 1],
      [`delete${kind}`, -1],
    ] as const) {
      type Method = (this: unknown, ...given: unknown[]) => unknown;
      const own = Reflect.get(WebGL2RenderingContext.prototype, name) as Method;
      Reflect.set(
        WebGL2RenderingContext.prototype,
        name,
        function (this: unknown, ...given: unknown[]) {
          // To delete nothing is allowed.
          if (step > 0 || given[0]) note.held[kind] = (note.held[kind] ?? 0) + step;
          return own.apply(this, given);
        },
      );
    }
  }
  const [make, revoke] = [URL.createObjectURL.bind(URL), URL.revokeObjectURL.bind(URL)];
  URL.createObjectURL = (blob: Blob) => {
    const address = make(blob);
    note.blobs.set(address, blob);
    return address;
  };
  URL.revokeObjectURL = (address) => {
    note.blobs.delete(address);
    revoke(address);
  };
}

const script = `(${String(noteResources)})();`;

/** Watches a page, which has loaded nothing yet, and its workers that draw models. */
export async function watchResources(page: Page): Promise<void> {
  await page.addInitScript(script);
  await page.context().route(/\/model-worker-[^/]*\.js$/, async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, body: script + (await response.text()) });
  });
}

/** Whether each WebGL context that a page or a worker has asked for is lost. */
export function contextsIn(place: Page | Worker): Promise<boolean[]> {
  return (place as Page).evaluate(() =>
    globalThis.noted.contexts.map((context) => context.isContextLost()),
  );
}

/** How many objects of each kind a page or a worker holds of the graphics card. */
export function heldIn(place: Page | Worker): Promise<Record<string, number>> {
  return (place as Page).evaluate(() => ({ ...globalThis.noted.held }));
}

/** What a page holds. */
export interface Resources {
  workers: number;
  /** Of `window` and `document`. */
  listeners: number;
  /** What blobs hold whose addresses were not given back. */
  blobs: string[];
  /** Elements of the class that are anywhere, also where nobody finds them. */
  elements: number;
  /** Contexts of the page itself that are not lost. */
  contexts: number;
}

async function listenersOf(devtools: CDPSession, expression: string): Promise<number> {
  const { result } = await devtools.send('Runtime.evaluate', { expression });
  const objectId = result.objectId!;
  const { listeners } = await devtools.send('DOMDebugger.getEventListeners', { objectId });
  return listeners.length;
}

async function countOf(devtools: CDPSession, prototype: string): Promise<number> {
  const { result } = await devtools.send('Runtime.evaluate', { expression: prototype });
  const prototypeObjectId = result.objectId!;
  const { objects } = await devtools.send('Runtime.queryObjects', { prototypeObjectId });
  const { result: count } = await devtools.send('Runtime.callFunctionOn', {
    objectId: objects.objectId!,
    functionDeclaration: 'function () { return this.length; }',
    returnByValue: true,
  });
  await devtools.send('Runtime.releaseObject', { objectId: objects.objectId! });
  return count.value as number;
}

/** Counts what a page holds that `watchResources` watches, after a collection of garbage. */
export async function resourcesOf(page: Page, devtools: CDPSession): Promise<Resources> {
  await devtools.send('HeapProfiler.collectGarbage');
  const contexts = await contextsIn(page);
  return {
    workers: page.workers().length,
    listeners: (await listenersOf(devtools, 'window')) + (await listenersOf(devtools, 'document')),
    blobs: await page.evaluate(() =>
      Promise.all([...globalThis.noted.blobs.values()].map((blob) => blob.text())),
    ),
    elements: await countOf(devtools, 'customElements.get("foldwright-viewer").prototype'),
    contexts: contexts.filter((isLost) => !isLost).length,
  };
}
