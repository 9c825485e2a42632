/** Workers in this thread with an engine that does what a test wants, for tests of the pool. */
import type { Engine } from '../../web/core/engine.js';
import { serveEngine } from '../../web/core/engine-worker.js';
import { Pool } from '../../web/core/pool.js';
import type { Request } from '../../web/core/protocol.js';
import type { Port, PortListener } from '../../web/core/worker-port.js';
import type { EngineEvent } from '../../web/model/job.js';

/** How a job goes. */
export interface Script {
  /** What each step of the job's own work tells; the last one repeats. */
  steps: EngineEvent[][];
  /** Tasks that wait after the first step; the second one follows when all are done. */
  tasks?: number;
  /** Steps that a task takes; default 1. */
  length?: number;
  /** Called with each step of a task, and may throw. */
  onStep?: () => void;
}

/** An engine for such jobs. Tasks carry their number as their only byte. */
export function engineOf({ steps, tasks = 0, length = 1, onStep }: Script): Engine {
  const nothing = new Uint8Array();
  return {
    createJob() {
      let [next, taken, done] = [0, 0, 0];
      const step = (): EngineEvent[] => {
        if (next === 1 && done < tasks) return [];
        return steps[Math.min(next++, steps.length - 1)]!;
      };
      return {
        step,
        advance: step,
        takeTask() {
          if (next === 0 || taken === tasks) return undefined;
          const id = taken++;
          return { id, surface: 0, bytes: Uint8Array.of(id) };
        },
        surface: () => ({ delete: () => undefined }),
        surfaceBytes: () => nothing,
        report: () => [],
        complete() {
          ++done;
          return [];
        },
        draft: () => [],
        cancel: () => [{ type: 'cancelled' }],
        delete() {
          next = NaN;
        },
      };
    },
    createSurface: () => ({ delete: () => undefined }),
    setUniter: () => undefined,
    createTask() {
      let left = length;
      return {
        step() {
          onStep?.();
          return --left <= 0;
        },
        isFolding: () => false,
        status: () => nothing,
        result: () => nothing,
        delete: () => undefined,
      };
    },
  };
}

/** A worker in this thread. */
export function localPort(engine: Engine, listener: PortListener): Port {
  let open = true;
  const later = (call: () => void): void => {
    setImmediate(() => open && call());
  };
  const handle = serveEngine({
    loadEngine: () => Promise.resolve(engine),
    post: (answer) => later(() => listener.onAnswer(answer)),
    pause: () => new Promise((resolve) => setImmediate(resolve)),
    loadDraco: () => Promise.reject(new Error('there is no decoder here')),
    loadManifold: () => Promise.reject(new Error('there is no library here')),
  });
  return {
    post: (request: Request) => later(() => handle(request)),
    close: () => {
      open = false;
    },
  };
}

/** A worker that takes requests and answers nothing. */
export function deafPort(): Port {
  return { post: () => undefined, close: () => undefined };
}

/** A worker that is in a long step when its run ends, and answers that `ms` later. */
export function busyPort(engine: Engine, listener: PortListener, ms: number): Port {
  const port = localPort(engine, listener);
  return {
    post(request, transfer) {
      if (request.type === 'end') setTimeout(() => port.post(request, transfer), ms);
      else port.post(request, transfer);
    },
    close: () => port.close(),
  };
}

/** A worker that dies of the first request for which `isDeadly`. */
export function mortalPort(
  engine: Engine,
  listener: PortListener,
  isDeadly: (request: Request) => boolean,
): Port {
  const port = localPort(engine, listener);
  return {
    post(request, transfer) {
      if (!isDeadly(request)) port.post(request, transfer);
      else setImmediate(() => listener.onDeath('memory access out of bounds'));
    },
    close: () => port.close(),
  };
}

/** A pool and the number of workers that it has started so far. */
export function poolOf(
  size: number,
  spawn: (listener: PortListener, worker: number) => Port,
): { pool: Pool; spawned: { count: number } } {
  const spawned = { count: 0 };
  const pool = new Pool((listener) => spawn(listener, spawned.count++), size);
  return { pool, spawned };
}
