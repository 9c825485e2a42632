import { find } from './dom.js';

/** Lies beside the page: from there it serves all that is below. */
const script = './service-worker.js';

/**
 * A build that came while pages of an earlier one were open takes over with this page, if there is
 * no other one. It is loaded once more for that, before a person can have done anything with it.
 */
export async function takeNewestBuild(): Promise<void> {
  const { serviceWorker } = navigator as Partial<Navigator>;
  const waiting = (await serviceWorker?.getRegistration())?.waiting;
  if (!waiting) return;
  serviceWorker?.addEventListener('controllerchange', () => location.reload(), { once: true });
  waiting.postMessage('take over');
}

/** Rejects when not all files could be kept. */
function failure(worker: ServiceWorker | null): Promise<never> {
  return new Promise((_, reject) => {
    worker?.addEventListener('statechange', () => {
      if (worker.state === 'redundant') reject(new Error('A file is missing, or there is no room'));
    });
  });
}

/** Keeps all files of the studio on this device, and says when it needs no network any more. */
export async function keepForOffline(): Promise<void> {
  const words = find('#offline', HTMLElement);
  // Pages that came over a connection that is not secure have none.
  const { serviceWorker } = navigator as Partial<Navigator>;
  if (!serviceWorker) return;
  try {
    const { installing } = await serviceWorker.register(script, { updateViaCache: 'none' });
    await Promise.race([serviceWorker.ready, failure(installing)]);
    words.textContent = 'Ready offline: from now on it works without a network, too.';
  } catch {
    words.textContent = 'It could not be kept on this device, and needs a network.';
  }
}
