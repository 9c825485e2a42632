import { existsSync } from 'node:fs';
import { chromium, type Browser } from 'playwright-core';

/** Starts sooner than the whole browser, since it has no windows; not every system has it. */
const shell = '/usr/bin/chromium-headless-shell';
const executablePath = process.env['CHROMIUM'] ?? (existsSync(shell) ? shell : '/usr/bin/chromium');
const usualFlags = [
  '--no-sandbox',
  // WebGL in software, for machines without a graphics card.
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  // The rest of a page is drawn sooner without it.
  '--disable-gpu-compositing',
  '--disable-gpu-rasterization',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

/** @param flags besides those that each gets */
export function startChromium(flags: readonly string[] = []): Promise<Browser> {
  return chromium.launch({ executablePath, args: [...usualFlags, ...flags] });
}
