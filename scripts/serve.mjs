// A static file server for the built studio, for `npm start` and the tests in a browser.
import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize, sep } from 'node:path';
import { pipeline } from 'node:stream';
import { createGzip } from 'node:zlib';

const types = {
  '.css': 'text/css; charset=utf-8',
  '.html': 'text/html; charset=utf-8',
  '.ico': 'image/x-icon',
  '.js': 'text/javascript; charset=utf-8',
  '.json': 'application/json',
  '.mjs': 'text/javascript; charset=utf-8',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm', // without it browsers cannot compile while they load
  '.webmanifest': 'application/manifest+json',
  '.woff2': 'font/woff2',
};

/** What is no shorter when it is compressed once more. */
const compressed = new Set(['.png', '.woff2', '.ico']);

function fileFor(folder, address) {
  try {
    const path = normalize(decodeURIComponent(new URL(address, 'http://localhost').pathname));
    const file = join(folder, path.endsWith(sep) ? join(path, 'index.html') : path);
    return file.startsWith(folder + sep) && statSync(file).isFile() ? file : null;
  } catch {
    return null; // no such file, or an address that is none
  }
}

function listen(server, port) {
  return new Promise((resolve, reject) => {
    server.once('error', reject);
    server.listen(port, '127.0.0.1', () => resolve(server.address().port));
  });
}

function send(file, request, response, { headers, compress }) {
  const type = types[extname(file)] ?? 'application/octet-stream';
  const own = { 'content-type': type, 'cache-control': 'no-cache', ...headers };
  const mayCompress = compress && !compressed.has(extname(file));
  if (mayCompress) own.vary = 'accept-encoding';
  const doesCompress = mayCompress && /\bgzip\b/.test(request.headers['accept-encoding'] ?? '');
  if (doesCompress) own['content-encoding'] = 'gzip';
  response.writeHead(200, own);
  if (request.method === 'HEAD') return void response.end();
  const streams = doesCompress ? [createGzip(), response] : [response];
  // A browser that goes away in the middle is no fault.
  pipeline(createReadStream(file), ...streams, () => undefined);
}

/**
 * Serves a folder on this machine alone.
 * @param folder absolute path
 * @param {object} options
 * @param {number} [options.port] the first to try; a taken one is passed over. 0: any free one
 * @param {Record<string, string>} [options.headers] that every answer has besides its own
 * @param {boolean} [options.compress] whether answers are compressed for those who understand that
 * @returns {Promise<{address: string, close: () => void}>}
 */
export async function serve(folder, { port = 0, headers = {}, compress = false } = {}) {
  const server = createServer((request, response) => {
    const file = fileFor(folder, request.url ?? '/');
    if (!file) return void response.writeHead(404).end('not found');
    send(file, request, response, { headers, compress });
  });
  for (let next = port; ; ++next) {
    try {
      const taken = await listen(server, next);
      return { address: `http://localhost:${taken}/`, close: () => server.close() };
    } catch (error) {
      if (error.code !== 'EADDRINUSE') throw error;
    }
  }
}
