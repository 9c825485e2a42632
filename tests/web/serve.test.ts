/** The server of `npm start`. */
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { get, type IncomingMessage } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { buffer } from 'node:stream/consumers';
import { gunzipSync } from 'node:zlib';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { serve } from '../../scripts/serve.mjs';

const script = 'export const count = 1;\n'.repeat(1000);
let folder: string;
let server: Awaited<ReturnType<typeof serve>>;

beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'foldwright-serve-'));
  await writeFile(join(folder, 'main.js'), script);
  await writeFile(join(folder, 'icon.png'), script);
  server = await serve(folder, { compress: true });
});

afterAll(async () => {
  server.close();
  await rm(folder, { recursive: true });
});

async function fetched(name: string, encoding: string): Promise<[IncomingMessage, Buffer]> {
  const answer = await new Promise<IncomingMessage>((resolve) =>
    get(server.address + name, { headers: { 'accept-encoding': encoding } }, resolve),
  );
  return [answer, await buffer(answer)];
}

test('what a browser can unpack comes compressed', async () => {
  const [answer, body] = await fetched('main.js', 'gzip, deflate, br');
  expect(answer.headers['content-encoding']).toBe('gzip');
  expect(answer.headers['content-type']).toBe('text/javascript; charset=utf-8');
  expect(body.length).toBeLessThan(script.length / 10);
  expect(gunzipSync(body).toString()).toBe(script);
});

test('pictures, and what nobody could unpack, come as they are', async () => {
  for (const [name, encoding] of [
    ['icon.png', 'gzip'],
    ['main.js', 'identity'],
  ] as const) {
    const [answer, body] = await fetched(name, encoding);
    expect(answer.headers['content-encoding']).toBeUndefined();
    expect(body.toString()).toBe(script);
  }
});

test('what is not there, or outside the folder, is not found', async () => {
  for (const name of ['none.js', '..%2f..%2fetc/hostname']) {
    expect((await fetched(name, 'gzip'))[0].statusCode).toBe(404);
  }
});
