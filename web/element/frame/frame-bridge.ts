import { frameFaults } from '../../words/en/frame.js';
import { reflected } from '../viewer/viewer-attributes.js';
import type { FoldwrightViewer } from '../viewer/viewer-element.js';
import {
  frameVersion,
  isRequest,
  toldEvents,
  type FrameAnswer,
  type FrameAsk,
  type FrameAsks,
  type FrameNews,
  type FrameRequest,
} from './frame-protocol.js';

/** Attributes that a page may set. */
const settable: ReadonlySet<string> = new Set([...reflected, 'fold', 'lang']);

/** A request that makes no sense; its message is for who wrote the page. */
class BadRequest extends Error {
  readonly code = 'bad-request';
}

type Doers = {
  [Ask in FrameAsk]: (
    viewer: FoldwrightViewer,
    needs: FrameAsks[Ask]['needs'],
  ) => Promise<FrameAsks[Ask]['gives']> | FrameAsks[Ask]['gives'];
};

/** What is done for each request. */
const doers: Doers = {
  load: async (viewer, { source }) => {
    const isFiles =
      Array.isArray(source) && source.every(({ bytes }) => bytes instanceof Uint8Array);
    if (typeof source !== 'string' && !isFiles) throw new BadRequest(frameFaults.source);
    await viewer.loadModel(source);
    return null;
  },
  unfold: (viewer) => viewer.unfold(),
  cancel: (viewer) => {
    viewer.cancel();
    return null;
  },
  fold: async (viewer, { time }) => {
    if (!Number.isFinite(time)) throw new BadRequest(frameFaults.time);
    await viewer.foldTo(time);
    return null;
  },
  export: (viewer, { format, options }) => viewer.exportAs(format, options),
  project: (viewer) => viewer.saveProject(),
  set: (viewer, { attributes }) => {
    for (const [name, value] of Object.entries(attributes)) {
      if (!settable.has(name)) throw new BadRequest(frameFaults.attribute(name));
      if (value === null) viewer.removeAttribute(name);
      else viewer.setAttribute(name, String(value));
    }
    return null;
  },
};

/**
 * Does for a page what it asks a frame with a viewer for. Only the page around the frame is heard, and only while it
 * is of the origin that the frame was told; nothing is sent to any other.
 */
export class FrameBridge {
  /** @param origin of the page, as `https://shop.example` */
  constructor(
    private readonly viewer: FoldwrightViewer,
    private readonly page: Window,
    private readonly origin: string,
  ) {
    addEventListener('message', (event) => {
      if (event.source !== page || event.origin !== origin || !isRequest(event.data)) return;
      void this.answer(event.data);
    });
    for (const type of toldEvents) {
      viewer.addEventListener(type, (event) => {
        if (event instanceof CustomEvent) this.tell(type, event.detail);
      });
    }
    this.tell('ready', null);
  }

  private tell(event: FrameNews['event'], detail: unknown): void {
    this.send({ foldwright: frameVersion, event, detail });
  }

  private async answer(request: FrameRequest): Promise<void> {
    const { id } = request;
    try {
      const value = await this.done(request);
      this.send({ foldwright: frameVersion, id, ok: true, value });
    } catch (error) {
      const { code = 'internal', message } = error as Error & { code?: string };
      this.send({ foldwright: frameVersion, id, ok: false, code, message });
    }
  }

  private async done(request: FrameRequest): Promise<FrameAsks[FrameAsk]['gives']> {
    if (!Object.hasOwn(doers, request.ask)) {
      throw new BadRequest(frameFaults.ask(String(request.ask)));
    }
    const doer = doers[request.ask] as (
      viewer: FoldwrightViewer,
      needs: FrameRequest,
    ) => Promise<FrameAsks[FrameAsk]['gives']>;
    return doer(this.viewer, request);
  }

  private send(message: FrameAnswer | FrameNews): void {
    this.page.postMessage(message, this.origin);
  }
}
