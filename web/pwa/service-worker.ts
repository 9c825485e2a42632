/**
 * Keeps the whole studio on the device, so that it works without a network after one visit. Each
 * build has a cache of its own. A new build waits until no page of the one before is open, or until
 * the only one is loaded anew: so every page gets all of its files from the build that it came from.
 */

/** Files of this build as addresses relative to this script, and a hash of them; from `precache`. */
declare const build: { hash: string; files: string[] };

const worker = self as unknown as ServiceWorkerGlobalScope;
const { scope } = worker.registration;

/** Other studios may live in other folders of the same host. */
const family = `foldwright ${scope} `;
const cacheName = family + build.hash;

/** Fetches all files past the browser's own cache, which may hold those of an earlier build. */
async function fetchFiles(cache: Cache): Promise<void> {
  await cache.addAll(build.files.map((file) => new Request(file, { cache: 'no-cache' })));
  // All names but that of the page say which build they are from.
  const page = await (await cache.match('./'))!.text();
  const scripts = [...page.matchAll(/assets\/[^"]+/g)].map(([name]) => name);
  if (!scripts.every((name) => build.files.includes(name))) {
    throw new Error('The page is from another build');
  }
}

/** Keeps all files or none: the browser tries again at a later visit. */
async function keepFiles(): Promise<void> {
  try {
    await fetchFiles(await caches.open(cacheName));
  } catch (error) {
    await caches.delete(cacheName);
    throw error;
  }
}

/**
 * A page that is complete asks for it: if it is of this build, no page of another one is left.
 *
 * @param file address of a file of the page that has a hash in its name
 */
async function dropOtherBuilds(file: string): Promise<void> {
  // The page of the build before asks, too, when this one takes over at that moment; while it is
  // loaded anew it still needs its files.
  if (!build.files.includes(file.slice(scope.length))) return;
  const names = await caches.keys();
  // One that is coming has its files among them already.
  const { installing, waiting, active } = worker.registration;
  if (installing || waiting || active !== worker.serviceWorker) return;
  const others = names.filter((name) => name.startsWith(family) && name !== cacheName);
  await Promise.all(others.map((name) => caches.delete(name)));
}

/** Pages that were answered and may be on their way still: those are not among the clients yet. */
const answeredPages = new Set<string>();

/** Ms in which the build that waits has long taken over. */
const longestHandOver = 10_000;

/** Until then the build that waits may take over, and a page of this one would lose its worker. */
let handingOverUntil = 0;

const isHandingOver = (): boolean => Date.now() < handingOverUntil;

/**
 * A page that was just loaded asks the worker that serves it to make way for the build that waits;
 * no other page may lose its files, nor one that is on its way because a person loads it anew.
 *
 * @param asking id of the page
 */
async function handOver(asking: string): Promise<void> {
  if (isHandingOver()) return;
  // Not for ever: the build that waits may be replaced by another one before it hears of it.
  handingOverUntil = Date.now() + longestHandOver;
  // Known as clients from then on.
  await Promise.all([...answeredPages].map((id) => worker.clients.get(id)));
  answeredPages.clear();
  const windows = await worker.clients.matchAll({ type: 'window', includeUncontrolled: true });
  const pages = windows.filter(({ url }) => url.startsWith(scope));
  const { waiting } = worker.registration;
  if (waiting && pages.every(({ id }) => id === asking)) waiting.postMessage({ takeOver: true });
  else handingOverUntil = 0;
}

/** Stands in for a page until the next build serves it, in less than a second. */
function pageToCome(): Response {
  const headers = { 'content-type': 'text/html' };
  return new Response('<!doctype html><meta http-equiv="refresh" content="0" />', { headers });
}

async function answer({ request, resultingClientId }: FetchEvent): Promise<Response> {
  if (request.mode === 'navigate') {
    if (isHandingOver()) return pageToCome();
    answeredPages.add(resultingClientId);
  }
  const path = request.url.slice(scope.length).replace(/[?#].*/, '');
  const isPage = request.mode === 'navigate' && ['', 'index.html'].includes(path);
  const cache = await caches.open(cacheName);
  const options = { ignoreSearch: true, ignoreVary: true };
  const kept = await cache.match(isPage ? scope : request, options);
  // A page of the build before may be on its way still when this one takes over: it is loaded anew
  // then, but first ends what it has begun.
  return kept ?? (await caches.match(request, options)) ?? fetch(request);
}

worker.addEventListener('install', (event) => event.waitUntil(keepFiles()));
worker.addEventListener('activate', (event) => {
  // The page of a first visit is served from now on, too.
  event.waitUntil(worker.clients.claim());
});
worker.addEventListener('message', (event) => {
  const { completePage, takeOver } = event.data as { completePage?: string; takeOver?: boolean };
  if (completePage !== undefined) event.waitUntil(dropOtherBuilds(completePage));
  else if (takeOver) event.waitUntil(worker.skipWaiting());
  else event.waitUntil(handOver((event.source as Client).id));
});
worker.addEventListener('fetch', (event) => {
  const { request } = event;
  if (request.method === 'GET' && request.url.startsWith(scope)) {
    event.respondWith(answer(event));
  }
});
