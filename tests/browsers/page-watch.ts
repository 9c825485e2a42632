/** What `watchPage` gives to the page. */
declare global {
  interface Window {
    /** Errors and warnings of the console, uncaught errors, and what the page's policy has forbidden. */
    complaints: string[];
    /** The files that were handed to the browser's own download. */
    saved: { name: string; blob: Blob }[];
    /** The documents that were handed to the browser's own dialogue: the widths of their pictures in pixels. */
    printed: { widths: number[] }[];
    /** The studio's elements with a selector that are to be seen, and that have these words or are called so. */
    seen(selector: string, words?: string): (HTMLElement | SVGGraphicsElement)[];
  }
}

/**
 * Runs in the studio's page before its own scripts, the same in every engine, and takes what it saves and prints in the
 * place of the browser's dialogues, which no engine lets a test press. It goes there as text, and so names nothing of
 * this file.
 */
export function watchPage(): void {
  const complaints: string[] = [];
  const saved: Window['saved'] = [];
  const printed: Window['printed'] = [];
  Object.assign(window, { complaints, saved, printed });

  for (const kind of ['error', 'warn'] as const) {
    const own = console[kind].bind(console);
    console[kind] = (...words: unknown[]) => {
      complaints.push(words.map(String).join(' '));
      own(...words);
    };
  }
  const note = (event: Event): void => {
    const { target } = event;
    const address = target instanceof Element ? target.getAttribute('src') : null;
    complaints.push(event instanceof ErrorEvent ? event.message : `${address} cannot be loaded`);
  };
  // In the capturing phase those of pictures and scripts come by, too.
  addEventListener('error', note, true);
  addEventListener('unhandledrejection', ({ reason }) => complaints.push(String(reason)));
  addEventListener('securitypolicyviolation', ({ violatedDirective, blockedURI }) => {
    complaints.push(`${violatedDirective} forbids ${blockedURI}`);
  });

  const blobs = new Map<string, Blob>();
  const createObjectURL = URL.createObjectURL.bind(URL);
  URL.createObjectURL = (blob: Blob) => {
    const address = createObjectURL(blob);
    blobs.set(address, blob);
    return address;
  };
  const click = Object.getOwnPropertyDescriptor(HTMLElement.prototype, 'click')!;
  HTMLAnchorElement.prototype.click = function () {
    const blob = blobs.get(this.href);
    if (blob) saved.push({ name: this.download, blob });
    else (click.value as () => void).call(this);
  };

  const frame = Object.getOwnPropertyDescriptor(HTMLIFrameElement.prototype, 'contentWindow')!;
  Object.defineProperty(HTMLIFrameElement.prototype, 'contentWindow', {
    get(this: HTMLIFrameElement) {
      const view = frame.get!.call(this) as Window | null;
      if (!view) return view;
      view.print = () => {
        const { images } = this.contentDocument!;
        printed.push({ widths: Array.from(images, ({ naturalWidth }) => naturalWidth) });
        view.dispatchEvent(new Event('afterprint'));
      };
      return view;
    },
  });

  window.seen = (selector, words = '') => {
    // Before the element is defined there is nothing to be seen.
    const root = document.querySelector('foldwright-studio')?.shadowRoot;
    const found = root?.querySelectorAll<HTMLElement | SVGGraphicsElement>(selector) ?? [];
    const isMeant = (element: Element): boolean =>
      `${element.ariaLabel ?? ''}\n${element.textContent}`.includes(words);
    return [...found].filter((element) => element.checkVisibility() && isMeant(element));
  };
}
