/** Entry of the threads that do the models of a batch, one after the other; each has engine workers of its own. */
import { parentPort, workerData } from 'node:worker_threads';
import { nodePool } from '../../core/node-pool.js';
import { loadWords } from '../../words/load.js';
import { doModel } from './do-model.js';
import type { SlotAnswer, SlotData, SlotOrder } from './slot-protocol.js';

const { commands, workers } = workerData as SlotData;
const port = parentPort!;
const pool = nodePool(workers);
const words = await loadWords(commands.settings.lang);

const answer = (message: SlotAnswer): void => port.postMessage(message);

port.on('message', (order: SlotOrder) => {
  void doModel(order, {
    commands,
    pool,
    words,
    tell: (event) => answer({ type: 'event', event }),
  }).then((outcome) => answer({ type: 'outcome', outcome }));
});
