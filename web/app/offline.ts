/** Whether the page works without a network; null where a browser cannot keep it. */
export type OfflineState = 'offline' | 'notOffline' | null;

/** Lies beside the page: from there it serves all that is below. */
const script = './service-worker.js';

/** Ms after loading at which a page asks: one that was just closed is still counted for a moment. */
const askingTimes = [0, 300, 1000, 3000];

/** Aborts when a person begins to do something with the page. */
function firstUse(): AbortSignal {
  const use = new AbortController();
  for (const event of ['pointerdown', 'keydown', 'drop']) {
    addEventListener(event, () => use.abort(), { once: true, capture: true });
  }
  return use.signal;
}

/**
 * A build that came while pages of an earlier one were open takes over with this page, if there is
 * no other one. It is loaded once more for that, before a person has done anything with it.
 */
export async function takeNewestBuild(): Promise<void> {
  const { serviceWorker } = navigator as Partial<Navigator>;
  const registration = await serviceWorker?.getRegistration();
  if (!registration?.waiting) return;
  serviceWorker?.addEventListener('controllerchange', () => location.reload(), { once: true });
  const used = firstUse();
  for (const time of askingTimes) {
    setTimeout(() => {
      if (!used.aborted) registration.active?.postMessage({ handOver: true });
    }, time);
  }
}

/** Rejects when not all files could be kept. */
function failure(worker: ServiceWorker | null): Promise<never> {
  return new Promise((_, reject) => {
    worker?.addEventListener('statechange', () => {
      if (worker.state === 'redundant') reject(new Error('A file is missing, or there is no room'));
    });
  });
}

/** Resolves when the worker serves this page, too: it claims all pages before it is activated. */
async function serving(serviceWorker: ServiceWorkerContainer): Promise<void> {
  const worker = (await serviceWorker.ready).active;
  await new Promise<void>((resolve) => {
    const look = (): void => {
      if (worker?.state !== 'activating') resolve();
    };
    worker?.addEventListener('statechange', look);
    look();
  });
}

/** Keeps all files of the studio on this device; resolves when it needs no network any more, or will do with one. */
export async function keepForOffline(): Promise<OfflineState> {
  // Pages that came over a connection that is not secure have none.
  const { serviceWorker } = navigator as Partial<Navigator>;
  if (!serviceWorker) return null;
  try {
    const { installing } = await serviceWorker.register(script, { updateViaCache: 'none' });
    await Promise.race([serving(serviceWorker), failure(installing)]);
    serviceWorker.controller?.postMessage({ completePage: import.meta.url });
    return 'offline';
  } catch {
    return 'notOffline';
  }
}
