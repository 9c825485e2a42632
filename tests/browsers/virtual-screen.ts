import { spawn } from 'node:child_process';

export interface VirtualScreen {
  /** For the environment variable DISPLAY. */
  display: string;
  close(): void;
}

/** A screen that nobody sees: without one WebKit does not start, and Firefox draws no WebGL. */
export async function openScreen(): Promise<VirtualScreen> {
  const size = ['-screen', '0', '1600x1200x24'];
  // It looks for a free number by itself and tells it.
  const server = spawn('Xvfb', ['-displayfd', '1', '-nolisten', 'tcp', ...size], {
    stdio: ['ignore', 'pipe', 'ignore'],
  });
  const number = await new Promise<string>((resolve, reject) => {
    server.once('error', reject);
    server.once('exit', () => reject(new Error('Xvfb does not start')));
    server.stdout.once('data', (words: Buffer) => resolve(words.toString().trim()));
  });
  return { display: `:${number}`, close: () => void server.kill() };
}
