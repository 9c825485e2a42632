import { browserTransport } from '../core/browser-transport.js';
import { Studio } from './studio.js';

void new Studio(browserTransport()).start();
