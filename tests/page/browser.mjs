// Helpers of the tests in a browser: pages of twrench in Chromium, or with BROWSER=firefox in Firefox.
// Unexpected errors and requests of a page fail the test.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import puppeteer from 'puppeteer-core';

export const folder = mkdtempSync(join(tmpdir(), 'twrench-page-'));

/** Runs the program and returns its standard output. */
export const twrench = (...words) =>
  execFileSync(process.env.TWRENCH, words, { encoding: 'utf8', maxBuffer: 1 << 28 });

/** Writes a page and returns its file. */
export function writePage(name, ...words) {
  const file = join(folder, name);
  twrench('page', ...words, '-o', file);
  return file;
}

const isFirefox = process.env.BROWSER === 'firefox';
const programs = isFirefox ? ['/usr/bin/firefox-esr', '/usr/bin/firefox'] : ['/usr/bin/chromium', '/usr/bin/chromium-browser'];
const executablePath = programs.find((path) => {
  try {
    execFileSync(path, ['--version'], { stdio: 'ignore' });
    return true;
  } catch {
    return false;
  }
});

/**
 * Starts a browser. Without a graphics card Chromium draws WebGL 2 with SwiftShader and Firefox with
 * Mesa; Firefox then needs a display (xvfb-run).
 */
const launch = (...more) =>
  isFirefox
    ? puppeteer.launch({
        browser: 'firefox',
        executablePath,
        headless: false,
        protocolTimeout: 120_000,
        extraPrefsFirefox: { 'webgl.force-enabled': true, 'ui.prefersReducedMotion': 1 },
      })
    : puppeteer.launch({
        executablePath,
        protocolTimeout: 120_000,
        args: ['--no-sandbox', '--enable-unsafe-swiftshader', '--disable-dev-shm-usage', ...more],
      });

export const browser = await launch();

/** Uses a display with this many pixels per point. Emulation would not affect a canvas. */
export async function openOnDisplay(scale, file) {
  const other = await launch(`--force-device-scale-factor=${scale}`);
  const page = await other.newPage();
  await page.setViewport(null);
  await page.goto(pathToFileURL(file).href);
  await page.evaluate(() => globalThis.twrench.ready);
  return { page, close: () => other.close() };
}

/**
 * Opens a page and waits until it is ready. Collects console errors and requests in `trouble`; a test
 * that expects none calls quiet(). `before` is a function that runs before the page's scripts.
 */
export async function open(file, { hash = '', width = 900, height = 600, features, before } = {}) {
  const page = await browser.newPage();
  if (before) await page.evaluateOnNewDocument(before);
  await page.setViewport({ width, height });
  if (features && !isFirefox) await page.emulateMediaFeatures(features);
  const trouble = watch(page, file);
  await page.goto(pathToFileURL(file).href + hash);
  await page.evaluate(() => globalThis.twrench.ready);
  return {
    page,
    trouble,
    quiet: () => assert.deepEqual(trouble, [], 'errors in the console, or requests'),
  };
}

/** Collects the errors and requests of a page. */
export function watch(page, file) {
  const trouble = [];
  const own = pathToFileURL(file).href;
  page.on('pageerror', (error) => trouble.push(`error: ${error.message}`));
  page.on('console', (message) => {
    // A software renderer warns that reading pixels stalls it.
    if (/GPU stall due to ReadPixels/.test(message.text())) return;
    if (['error', 'warn'].includes(message.type())) trouble.push(`${message.type()}: ${message.text()}`);
  });
  page.on('request', (request) => {
    const url = request.url();
    if (!url.startsWith(own) && !/^(data|blob):/.test(url)) trouble.push(`request: ${url}`);
  });
  return trouble;
}

/**
 * Runs the tests in order, and ends with exit status 0 if all passed. In Firefox it skips tests that need
 * Chromium's protocol.
 */
export async function run(tests, ofChromium = []) {
  assert.ok(ofChromium.every((name) => name in tests), 'a test of that name');
  let failed = 0;
  const chosen = process.argv[2];
  for (const [name, test] of Object.entries(tests)) {
    if (chosen && !name.includes(chosen)) continue;
    if (isFirefox && ofChromium.includes(name)) continue;
    const start = performance.now();
    try {
      await test();
      console.log(`ok      ${name} (${((performance.now() - start) / 1000).toFixed(1)} s)`);
    } catch (error) {
      ++failed;
      console.log(`FAILED  ${name}\n${error.stack}`);
    }
    for (const page of await browser.pages()) if (page.url() !== 'about:blank') await page.close();
  }
  await browser.close();
  process.exit(failed ? 1 : 0);
}
