/** Chromium and Firefox, which puppeteer drives both. */
import puppeteer, { type Browser, type KeyInput, type LaunchOptions } from 'puppeteer-core';
import type { Engine, EnginePage } from './engine-page.js';

const browsers: Record<'chromium' | 'firefox', LaunchOptions> = {
  chromium: {
    browser: 'chrome',
    executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  },
  firefox: {
    browser: 'firefox',
    executablePath: process.env['FIREFOX'] ?? '/usr/bin/firefox-esr',
    // Software is good enough for WebGL here.
    extraPrefsFirefox: { 'webgl.force-enabled': true },
  },
};

async function pageOf(browser: Browser): Promise<EnginePage> {
  const page = await browser.newPage();
  return {
    goto: async (address) => void (await page.goto(address)),
    reload: async () => void (await page.reload()),
    evaluate: <Result, Argument>(
      body: (argument: Argument) => Result | Promise<Result>,
      argument?: Argument,
    ) => page.evaluate(body as (given: unknown) => unknown, argument) as Promise<Result>,
    click: (x, y) => page.mouse.click(x, y),
    press: async (...keys) => {
      for (const key of keys) await page.keyboard.press(key as KeyInput);
    },
    resize: (width, height) => page.setViewport({ width, height }),
    screenshot: () => page.screenshot({ type: 'png' }),
    close: () => browser.close(),
  };
}

function puppet(name: keyof typeof browsers): Engine {
  const open = async (display: string): Promise<EnginePage> => {
    const env = { ...process.env, DISPLAY: display };
    return pageOf(await puppeteer.launch({ ...browsers[name], headless: false, env }));
  };
  return { name, open };
}

export const chromium = puppet('chromium');
export const firefox = puppet('firefox');
