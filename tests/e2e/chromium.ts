import { existsSync } from 'node:fs';
import { chromium, type Browser } from 'playwright-core';

/** Without windows, which are the half of a start, before the whole browser. */
const programs = ['/usr/bin/chromium-headless-shell', '/usr/bin/chromium'];
const executablePath = process.env['CHROMIUM'] ?? programs.find((path) => existsSync(path));
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
  return chromium.launch({
    ...(executablePath && { executablePath }),
    args: [...usualFlags, ...flags],
  });
}
