/** The viewer in a frame, which a page of another origin talks with. */
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { serve } from '../../scripts/serve.mjs';
import type { FrameAnswer, FrameNews } from '../../web/element/frame/frame-protocol.js';
import { objText, wavyRing } from '../web/model-text.js';
import { sharedBrowser } from './shared-browser.js';

const built = fileURLToPath(new URL('../../dist/studio', import.meta.url));

type Told = FrameNews & { from: string };
type Request = { ask: string } & Record<string, unknown>;

declare global {
  interface Window {
    told: Told[];
    request: (frame: number, request: Request) => Promise<FrameAnswer>;
  }
}

/** What a page does that has frames: it keeps what they tell, and waits for their answers. */
const script = `
  window.told = [];
  const waiting = new Map();
  addEventListener('message', ({ data, origin }) => {
    if (data.event) told.push({ ...data, from: origin });
    else waiting.get(data.id)?.(data);
  });
  window.request = (frame, request) => new Promise((resolve) => {
    const id = waiting.size + 1;
    waiting.set(id, resolve);
    document.querySelectorAll('iframe')[frame].contentWindow.postMessage({ foldwright: 1, id, ...request }, '*');
  });`;

/** Opens a page with a frame that is told its origin, and one that is told another one. */
async function withFrames(work: (page: Page, host: string) => Promise<void>): Promise<void> {
  const folder = await mkdtemp(join(tmpdir(), 'foldwright-frame-'));
  const [host, server] = [await serve(built), await serve(folder)];
  const page = await (await sharedBrowser()).newPage({ reducedMotion: 'reduce' });
  const frame = (parent: string): string =>
    `<iframe width="400" height="300" src="${host.address}viewer-frame.html?parent=${parent}&controls"></iframe>`;
  const { origin } = new URL(server.address);
  const html = `<!doctype html><title>A shop</title><script>${script}</script>
    ${frame(origin)}${frame('https://other.example')}`;
  await writeFile(join(folder, 'index.html'), html);
  try {
    await page.goto(server.address);
    await page.waitForFunction(() => window.told.some(({ event }) => event === 'ready'));
    await work(page, new URL(host.address).origin);
  } finally {
    await page.close();
    server.close();
    host.close();
    await rm(folder, { recursive: true, force: true });
  }
}

const request = (page: Page, asked: Request, frame = 0): Promise<FrameAnswer> =>
  page.evaluate(([at, what]) => window.request(at, what), [frame, asked] as const);

const done = { foldwright: 1, ok: true };

test('a page lets a frame of another origin unfold a model and hand over its files', () =>
  withFrames(async (page, host) => {
    const loaded = await page.evaluate(
      (text) => {
        const bytes = new TextEncoder().encode(text);
        return window.request(0, { ask: 'load', source: [{ name: 'ring.obj', bytes }] });
      },
      objText(wavyRing(6)),
    );
    expect(loaded).toMatchObject({ ...done, value: null });
    expect(await request(page, { ask: 'set', attributes: { parts: '2' } })).toMatchObject(done);
    const unfolded = await request(page, { ask: 'unfold' });
    expect(unfolded).toMatchObject({ ...done, value: { options: { parts: 2 } } });
    const sizes = await page.evaluate(async () => {
      const answer = await window.request(0, { ask: 'export', format: 'svg' });
      const files = answer.ok ? (answer.value as { name: string; bytes: Uint8Array }[]) : [];
      return files.map(({ name, bytes }) => [name, bytes.length] as const);
    });
    expect(sizes.length).toBeGreaterThan(0);
    for (const [name, size] of sizes) {
      expect(name).toMatch(/^ring.*\.svg$/);
      expect(size).toBeGreaterThan(1000);
    }
    expect(await request(page, { ask: 'fold', time: 0 })).toMatchObject(done);
    const told = await page.evaluate(() => window.told);
    expect(new Set(told.map(({ from }) => from))).toEqual(new Set([host]));
    expect(told.map(({ event }) => event)).toEqual(
      expect.arrayContaining(['ready', 'load', 'unfold', 'fold-change']),
    );
  }));

test('a frame says what it cannot do, and is silent towards pages that it was not told', () =>
  withFrames(async (page) => {
    const refused = { foldwright: 1, ok: false };
    const isBad = { ...refused, code: 'bad-request' };
    expect(await request(page, { ask: 'dance' })).toMatchObject(isBad);
    expect(await request(page, { ask: 'constructor' })).toMatchObject(isBad);
    expect(await request(page, { ask: 'set', attributes: { onclick: 'x' } })).toMatchObject(isBad);
    expect(await request(page, { ask: 'load', source: [{ name: 'a' }] })).toMatchObject(isBad);
    expect(await request(page, { ask: 'unfold' })).toMatchObject({ ...refused, code: 'no-model' });
    const answered = await page.evaluate(async () => {
      const late = new Promise((resolve) => setTimeout(resolve, 1000, 'silent'));
      return Promise.race([window.request(1, { ask: 'unfold' }), late]);
    });
    expect(answered).toBe('silent');
    expect(
      await page.evaluate(() => window.told.filter(({ event }) => event === 'ready')),
    ).toHaveLength(1);
  }));
