// measure.mjs frame: the time of JavaScript and WebAssembly per frame of a page, without WebGL's drawing.
// measure.mjs memory [MINUTES]: memory while a page plays at 16 times the speed of the motion.
// Run it where scripts/maintain/page_test.sh runs the tests: TWRENCH=... node build/page/npm/measure.mjs frame
import { execFileSync } from 'node:child_process';
import { browser, open, writePage } from './browser.mjs';

const [what, minutes = '10'] = process.argv.slice(2);

/** The time of each of the next frames in ms, without WebGL's drawing. */
const frameTimes = (page, count) =>
  page.evaluate(async (wanted) => {
    for (const name of ['drawArrays', 'drawElements', 'clear', 'bufferData', 'bufferSubData', 'blitFramebuffer'])
      WebGL2RenderingContext.prototype[name] = () => {};
    const times = [];
    const request = globalThis.requestAnimationFrame;
    globalThis.requestAnimationFrame = (call) =>
      request((now) => {
        const start = performance.now();
        call(now);
        times.push(performance.now() - start);
      });
    while (times.length < wanted) await new Promise((done) => setTimeout(done, 50));
    return times.sort((a, b) => a - b);
  }, count);

async function measureFrames() {
  for (const [name, scene, hash] of [
    ['the default scene', 'dzhanibekov', ''],
    ['methods side by side', 'dzhanibekov', '#compare=beside&methods=rk4,exact&step=0.02'],
    ['the largest body', 'explorer-1', ''],
  ]) {
    const { page } = await open(writePage('measured.html', scene, '--lab'), { width: 1280, height: 800, hash });
    report(name, await frameTimes(page, 300));
    await page.close();
  }
  const { page } = await open(writePage('measured.html', 'dzhanibekov'), { width: 1280, height: 800 });
  for (const part of await page.$$('#article section')) {
    await part.evaluate((element) => element.scrollIntoView());
    report(await part.evaluate((element) => element.id), await frameTimes(page, 150));
  }
}

/** Prints times in ms, ascending. */
function report(name, times) {
  const at = (share) => times[Math.floor(share * times.length)].toFixed(1);
  console.log(`${name}: median ${at(0.5)} ms, 95 of 100 frames within ${at(0.95)} ms`);
}

/** Memory of the browser with all its processes, MB. */
function residentMegabytes() {
  const rows = execFileSync('ps', ['-eo', 'pid=,ppid=,rss='], { encoding: 'utf8' }).trim().split('\n').map((row) => row.trim().split(/\s+/).map(Number));
  const tree = new Set([browser.process().pid]);
  for (let before = 0; before < tree.size; ) {
    before = tree.size;
    for (const [pid, parent] of rows) if (tree.has(parent)) tree.add(pid);
  }
  return rows.reduce((sum, [pid, , rss]) => sum + (tree.has(pid) ? rss / 1024 : 0), 0);
}

async function measureMemory() {
  const { page, quiet } = await open(writePage('measured.html', 'dzhanibekov', '--lab'), { width: 900, height: 600, hash: '#speed=16' });
  const session = await page.createCDPSession();
  const start = performance.now();
  for (let minute = 1; minute <= Number(minutes); ++minute) {
    await new Promise((done) => setTimeout(done, start + 60_000 * minute - performance.now()));
    await session.send('HeapProfiler.collectGarbage');
    const { JSHeapUsedSize } = await page.metrics();
    const [t, wasm] = await page.evaluate(() => [document.getElementById('t').value, globalThis.twrench.core.instance.exports.memory.buffer.byteLength]);
    console.log(`${minute} min, t = ${t} s: heap ${(JSHeapUsedSize / 1e6).toFixed(2)} MB, WebAssembly ${wasm / 65536} pages, resident ${residentMegabytes().toFixed(0)} MB`);
  }
  quiet();
}

await (what === 'memory' ? measureMemory() : measureFrames());
await browser.close();
