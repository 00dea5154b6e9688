// Tests of the lab's controls: each by mouse and by keyboard, links, copied and saved texts, and
// accessibility.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { folder, open, openOnDisplay, run, twrench, writePage } from './browser.mjs';
import { copied, enter, sample, saved, settle, shown, still, time } from './controls.mjs';

const labOf = (name, ...words) => writePage(name, '--lab', ...words);
const flip = labOf('flip.html');
const axe = readFileSync(join(dirname(createRequire(import.meta.url).resolve('axe-core')), 'axe.min.js'), 'utf8');

const tests = {
  async 'it plays, and stands still for those who want less motion'() {
    const { page, quiet } = await open(flip);
    const start = await time(page);
    await page.waitForFunction((t) => Number(document.getElementById('timeline').ariaValueNow) > t + 1, {}, start);
    await page.click('#play');
    await settle(page);
    const stopped = await time(page);
    await new Promise((done) => setTimeout(done, 300));
    assert.equal(await time(page), stopped);
    quiet();
    const calm = await open(flip, still);
    await new Promise((done) => setTimeout(done, 300));
    assert.equal(await time(calm.page), 0);
    calm.quiet();
  },

  async 'the controls of time, by mouse and by keyboard'() {
    const { page, quiet } = await open(flip, still);
    const expectTime = async (t, what) => {
      await settle(page);
      assert.ok(Math.abs((await time(page)) - t) < 2e-4, `${what}: ${await time(page)} in place of ${t}`);
    };
    await page.click('#flip-on');
    await expectTime(11.8154, 'next flip');
    await page.click('#flip-on');
    await expectTime(35.4461, 'the one after');
    await page.click('#flip-back');
    await expectTime(11.8154, 'back');
    await page.click('#step-on');
    await expectTime(11.8154 + 4 / 60, 'a step');
    await enter(page, '#t', '1000000000');
    await expectTime(1e9, 'typed');
    await enter(page, '#t', '-5');
    await expectTime(1e9, 'before the start');
    await enter(page, '#t', '20');
    await page.focus('#timeline');
    for (const [key, t] of [['Home', 0], ['PageUp', 11.8154], ['PageUp', 35.4461], ['PageDown', 11.8154]]) {
      await page.keyboard.press(key);
      await expectTime(t, key);
    }
    const box = await (await page.$('#timeline')).boundingBox();
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    await settle(page);
    const middle = await time(page);
    await page.keyboard.press(' ');
    await page.waitForFunction((t) => Number(document.getElementById('timeline').ariaValueNow) > t, {}, middle);
    await page.keyboard.press(' ');
    quiet();
  },

  async 'keys work without a focus, and a question mark lists them'() {
    const { page, quiet } = await open(flip, still);
    await settle(page);
    await page.keyboard.press('ArrowRight');
    await settle(page);
    assert.ok(Math.abs((await time(page)) - 4 / 60) < 1e-6, 'a step on');
    await page.keyboard.press(' ');
    await page.waitForFunction(() => Number(document.getElementById('timeline').ariaValueNow) > 0.1);
    assert.equal(await page.evaluate(() => scrollY), 0, 'space does not scroll');
    await page.keyboard.press(' ');
    await page.keyboard.type('?');
    assert.equal(await page.$eval('#keys', (dialog) => dialog.open), true);
    await page.keyboard.press('Escape');
    assert.equal(await page.$eval('#keys', (dialog) => dialog.open), false);
    await page.click('#longer');
    await settle(page);
    assert.equal(await page.$eval('#length', (input) => input.value), '192', 'plus makes it longer');
    quiet();
  },

  async 'time suits any motion: days and microseconds'() {
    const slow = labOf('slow.html', '--inertia', '1,2,3', '--omega', '1e-6,3e-5,1e-6');
    const { page, quiet } = await open(slow, still);
    const speeds = await page.$$eval('#speed option', (options) => options.map((option) => option.textContent));
    assert.ok(speeds.every((text) => /^[\d.]+ (s|min|h|d)\/s$/.test(text)), speeds.join(', '));
    await page.click('#play');
    await page.waitForFunction(() => Number(document.getElementById('timeline').ariaValueNow) > 1e5, { timeout: 20_000 });
    await page.click('#play');
    assert.match(await shown(page, '#readout'), /^t = [\d.]+ (h|d) · flips: \d+ · next in [\d.]+ (s|min|h|d)$/);
    quiet();
    const fast = await open(flip, { ...still, hash: '#omega=1e6,5e4,0&length=1e-4&speed=1e-6' });
    await settle(fast.page);
    assert.match(await shown(fast.page, '#readout'), /^t = 0(\.0+)? (ms|µs) · .* µs$/);
    await fast.page.click('#flip-on');
    await settle(fast.page);
    assert.ok(Math.abs((await time(fast.page)) - 11.8154e-6) < 1e-9);
    fast.quiet();
  },

  async 'the start is set by typing, by slider, by dragging and by arrow keys'() {
    const { page, quiet } = await open(flip, still);
    const omega = async () => (await sample(page, 0)).omega;
    await enter(page, '#omega input[inputmode=decimal]', '1,5');
    assert.deepEqual(await omega(), [1.5, 0.05, 0], 'typed, with a comma');
    await enter(page, '#omega input[inputmode=decimal]', 'much');
    assert.deepEqual(await omega(), [1.5, 0.05, 0], 'nonsense');
    await page.focus('#omega input[type=range]');
    await page.keyboard.press('ArrowLeft');
    await settle(page);
    assert.ok((await omega())[0] < 1.5, 'slider');
    let before = await omega();
    await page.focus('#sphere canvas');
    await page.keyboard.press('ArrowUp');
    await settle(page);
    assert.notDeepEqual(await omega(), before, 'arrow on the sphere');
    const length = (vector) => Math.hypot(vector[0] * 982.27130302240869, vector[1] * 722.67103008077208, vector[2] * 1578.6503084288711);
    assert.ok(Math.abs(length(await omega()) / length(before) - 1) < 1e-12, 'the same |L|');
    before = await omega();
    const next = await shown(page, '#readout');
    for (const button of await page.$$('#about button')) {
      await button.click();
      await settle(page);
    }
    assert.notEqual(await shown(page, '#readout'), next);
    quiet();
  },

  async 'keys turn and zoom a view'() {
    const { page, quiet } = await open(flip, still);
    const isShown = (view) =>
      page.waitForFunction((text) => decodeURIComponent(location.hash).includes(text), {}, view);
    await page.focus('#body canvas');
    for (const key of ['ArrowRight', 'ArrowUp', 'ArrowUp', '+']) await page.keyboard.press(key);
    await isShown('view=0.08,0.16,1.12');
    for (const key of ['ArrowLeft', 'ArrowDown', '-', '-']) await page.keyboard.press(key);
    await isShown('view=0,0.08,0.8929');
    await page.keyboard.press('0');
    await page.waitForFunction(() => !location.hash.includes('view'));
    quiet();
  },

  async 'impossible moments of inertia are reported, and the motion continues'() {
    const { page, quiet } = await open(flip, { ...still, hash: '#moments=1,2,30' });
    assert.ok((await shown(page, '#moments-note')).length > 10);
    assert.equal((await sample(page, 1e4)).X.every(Number.isFinite), true);
    await page.click('input[name=body][value=scene]');
    await settle(page);
    assert.equal(await shown(page, '#moments-note'), '');
    quiet();
  },

  async 'two methods go side by side or as a ghost, and a bad one is seen to go wrong'() {
    const { page, quiet } = await open(flip, { ...still, hash: '#compare=beside&methods=exact,rk4&step=0.5&t=60' });
    await page.waitForFunction(() => /e-|10|\d/.test(document.querySelector('#errors tbody').textContent));
    const rows = await shown(page, '#errors tbody');
    await page.click('input[name=compare][value=ghost]');
    await page.select('#method-b', 'euler');
    await settle(page);
    await page.waitForFunction((text) => document.querySelector('#errors tbody').textContent !== text, {}, rows);
    // A step longer than a turn of the body is reported, and the page goes on.
    await enter(page, '#step-field input[inputmode=decimal]', '9');
    await page.waitForFunction(() => document.getElementById('compare-note').textContent.length > 10);
    await enter(page, '#step-field input[inputmode=decimal]', '0.01');
    await page.waitForFunction(() => document.getElementById('compare-note').textContent === '');
    for (const [, label] of await page.$eval('#method-a', (list) => [...list.options].map((o) => [o.index, o.value]))) {
      await page.select('#method-a', label);
      await settle(page);
    }
    quiet();
  },

  async 'a link holds what is seen'() {
    const state = '#t=31.25&omega=0.3,1.2,-0.1&moments=3,5,7&speed=2&theme=space&frame=body&show=axes,omega&view=0.5,-0.25,1.5&length=50&compare=ghost&methods=rk4,strang&step=0.125&tolerance=0.0001&lang=nb';
    const { page, quiet } = await open(flip, { ...still, hash: state });
    assert.equal(await page.$eval('html', (html) => html.lang), 'nb');
    const link = await copied(page, '#copy-link');
    const pairs = (text) => new Set(decodeURIComponent(text.slice(text.indexOf('#') + 1)).split('&'));
    assert.deepEqual(pairs(link), pairs(state));
    const again = await open(flip, { ...still, hash: link.slice(link.indexOf('#')) });
    assert.deepEqual(await sample(again.page, 31.25), await sample(page, 31.25));
    assert.equal(await time(again.page), 31.25);
    quiet();
    again.quiet();
  },

  async 'nonsense in a link is left out with a note, and never run'() {
    const hash = '#t=abc&omega=1,2&step=1e99&compare=<img src=x onerror=globalThis.broken=1>&__proto__=1&constructor=1&tour=7e5&theme=javascript:alert(1)&%E0%A4%A=1&moments=-1,2,3&speed=2';
    const { page, quiet } = await open(flip, { ...still, hash });
    assert.equal(await page.evaluate(() => globalThis.broken), undefined);
    assert.match(await shown(page, '#note'), /onerror|abc/);
    assert.equal(await page.$eval('#speed', (select) => select.value), '2', 'what makes sense counts');
    assert.deepEqual((await sample(page, 0)).omega, [1, 0.05, 0]);
    quiet();
  },

  async 'the copied command makes this very motion, to the last digit'() {
    for (const [words, hash] of [
      [[], '#speed=2'],
      [['stable-y', '--omega', '0.25,1.5,0.125'], ''],
      [['--inertia', '2,3,4'], '#omega=0.5,1.25,0.375'],
      [['--inertia', '2,3,4,0.25,-0.125,0.5'], '#omega=0.5,1.25,0.375'],
      [[], '#moments=2,3,4&omega=-0.5,1.25,0.375&theme=paper&frame=rotating&show=floor&view=0.5,0.25,2'],
    ]) {
      const { page, quiet } = await open(labOf('copied.html', ...words), { ...still, hash });
      const command = await copied(page, '#copy-command');
      assert.match(command, /^twrench render .* -o flip\.mp4$/);
      const frames = join(folder, `copied-${Math.random()}`);
      const line = command.replace(/^twrench/, '"$TWRENCH"').replace(/-o flip\.mp4$/, '');
      execFileSync('sh', ['-c', `${line} --no-video --frames 0,7,200 --size 64x36 --progress none --frames-dir ${frames}`], { cwd: folder });
      const manifest = JSON.parse(readFileSync(join(frames, 'manifest.json'), 'utf8'));
      assert.equal(manifest.frames.length, 3);
      for (const frame of manifest.frames) {
        const { X } = await sample(page, frame.t);
        const apart = Math.max(...X.map((x, i) => Math.abs(x - frame.X[i])));
        // Longer sums may round differently: docs/page.md.
        assert.ok(apart <= (words.length || hash.includes('omega') ? 3.2e-15 * Math.max(1, 2 * frame.t) : 0), `${command}: ${apart} at ${frame.t} s`);
      }
      const scene = await copied(page, '#copy-scene');
      writeFileSync(join(folder, 'copied.toml'), scene);
      const [, row] = twrench('simulate', join(folder, 'copied.toml'), '--times', '5').trim().split('\n');
      const X = row.split(',').slice(1, 10).map(Number);
      const found = (await sample(page, 5)).X;
      assert.ok(Math.max(...X.map((x, i) => Math.abs(x - found[i]))) <= 3e-14, 'the scene file');
      quiet();
    }
  },

  async 'the scene file of meshes, solid or a wall, can be read'() {
    const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => `v ${i & 1} ${(i >> 1) & 1} ${2 * (i >> 2)}`);
    const faces = ['1 3 4 2', '5 6 8 7', '1 2 6 5', '3 7 8 4', '1 5 7 3', '2 4 8 6'].map((face) => `f ${face}`);
    writeFileSync(join(folder, 'box.obj'), [...corners, ...faces, ''].join('\n'));
    const part = '[[part]]\nshape = "mesh"\nfile = "box.obj"\nunit = "cm"\ndensity = 2\n';
    writeFileSync(join(folder, 'box.toml'), `${part}${part}shell = 0.1\nposition = [3, 0, 0]\n`);
    const { page, quiet } = await open(labOf('box.html', join(folder, 'box.toml')), still);
    writeFileSync(join(folder, 'copied-box.toml'), await copied(page, '#copy-scene'));
    const moments = (name) => JSON.parse(twrench('inertia', join(folder, name), '--format', 'json')).principal_moments;
    assert.deepEqual(moments('copied-box.toml'), moments('box.toml'));
    quiet();
  },

  async 'the page of a story gives its command, and the scene file for what is shown'() {
    const { page, quiet } = await open(labOf('story.html', 'explain'), { ...still, hash: '#omega=0.5,1.25,0.375' });
    const lines = (await copied(page, '#copy-command')).split('\n');
    assert.match(lines[0], /^# .*shots/);
    assert.equal(lines[1], 'twrench render explain -o story.mp4');
    assert.match(lines[2], /^# .*scene file/);
    assert.equal(lines[3], 'twrench render flip.toml -o flip.mp4');
    writeFileSync(join(folder, 'flip.toml'), await copied(page, '#copy-scene'));
    const frames = join(folder, 'story');
    twrench('render', join(folder, 'flip.toml'), '--no-video', '--frames', '90', '--size', '64x36', '--progress', 'none', '--frames-dir', frames);
    const [frame] = JSON.parse(readFileSync(join(frames, 'manifest.json'), 'utf8')).frames;
    const { X } = await sample(page, frame.t);
    assert.ok(Math.max(...X.map((x, i) => Math.abs(x - frame.X[i]))) <= 1e-14);
    quiet();
  },

  async 'the data that are saved are those of twrench simulate'() {
    for (const [words, hash, more, bound] of [
      [['dzhanibekov'], '', ['--method', 'exact'], 0],
      [['dzhanibekov', '--duration', '0.99'], '', ['--method', 'exact'], 0],
      [['stable-y', '--omega', '0.2,1.5,0.3', '--duration', '10'], '', ['--method', 'exact'], 3e-14],
      [['dzhanibekov', '--duration', '5'], '#compare=ghost&methods=rk4,exact&step=0.25', ['--method', 'rk4', '--step', '0.25'], 1e-13],
    ]) {
      const { page, quiet } = await open(labOf('data.html', ...words), { ...still, hash });
      const text = await saved(page, '#save-csv');
      const expected = twrench('simulate', ...words, ...more);
      const [head, ...rows] = text.trim().split('\n'), [expectedHead, ...expectedRows] = expected.trim().split('\n');
      assert.equal(head, expectedHead);
      assert.equal(rows.length, expectedRows.length);
      rows.forEach((row, i) => {
        const numbers = row.split(',').map(Number), others = expectedRows[i].split(',').map(Number);
        // The numbers of the motion are the same text; energy and errors are sums, and round differently.
        const moving = bound === 0 ? 13 : 1;
        assert.equal(row.split(',', moving).join(), expectedRows[i].split(',', moving).join());
        numbers.forEach((x, k) => {
          const apart = Math.abs(x - others[k]) / Math.max(1, Math.abs(x));
          assert.ok(apart <= Math.max(bound, 2e-14), `${words} ${hash}: ${x} and ${others[k]} in ${head.split(',')[k]} of row ${i}`);
        });
      });
      quiet();
    }
    const long = await open(flip, { ...still, hash: '#length=1e6' });
    const lines = (await saved(long.page, '#save-csv')).trim().split('\n');
    assert.ok(lines.length > 10_000 && lines.length <= 20_003, `${lines.length} lines`);
    assert.match(lines.at(-1), /^1e\+06,/);
    const bad = await open(flip, { ...still, hash: '#compare=ghost&methods=rk4,exact&step=9' });
    await bad.page.click('#save-csv');
    assert.match(await shown(bad.page, '#copied'), /rk4/);
  },

  async 'what each readout shows while methods are compared'() {
    const { page, quiet } = await open(flip, { ...still, hash: '#compare=beside&methods=rk4,exact&step=0.25&t=40' });
    await page.waitForFunction(() => /\d/.test(document.querySelector('#errors tbody').textContent));
    const of = (method) => {
      const control = method === 'exact' ? [] : ['--step', '0.25'];
      return twrench('simulate', '--method', method, ...control, '--times', '40').trim().split('\n')[1].split(',').map(Number);
    };
    const apart = (row, X) => Math.max(...X.map((x, i) => Math.abs(x - row[1 + i])));
    const { X } = await sample(page, 40);
    assert.ok(apart(of('rk4'), X) < 1e-11, 'sample(t) is the first method');
    assert.ok(apart(of('exact'), X) > 1e-6, 'which is not exact');
    assert.match(await copied(page, '#copy-command'), /--method rk4 .*--step 0.25 .*--compare rk4,exact/);
    await page.$eval('#data', (details) => (details.open = true));
    await enter(page, '#length', '40');
    const cells = await page.$$eval('#table tbody tr:last-child td', (all) => all.slice(0, 9).map((cell) => Number(cell.textContent.replace('−', '-'))));
    assert.ok(apart(of('exact'), cells) < 1e-6, 'the table is the exact motion');
    assert.match(await shown(page, '#readout'), /^t = 40/);
    quiet();
  },

  async 'the page is accessible: axe reports no violations'() {
    for (const [hash, size] of [
      ['', { width: 1280, height: 800 }],
      ['#theme=paper&lang=nb&compare=beside&moments=1,2,9', { width: 1280, height: 800 }],
      ['#theme=space&compare=ghost', { width: 360, height: 740 }],
    ]) {
      const { page, quiet } = await open(flip, { ...still, ...size, hash });
      await page.$eval('#data', (details) => (details.open = true));
      await settle(page);
      const session = await page.createCDPSession();
      await session.send('Page.setBypassCSP', { enabled: true });
      await page.evaluate(axe);
      const found = await page.evaluate(async () => {
        const { violations } = await globalThis.axe.run({ runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'] });
        return violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 120)).join(' | ')}`);
      });
      assert.deepEqual(found, [], hash);
      quiet();
    }
  },

  async 'it fits from a phone to a wall'() {
    mkdirSync(process.env.SHOTS ?? join(folder, 'shots'), { recursive: true });
    for (const [width, height] of [[360, 740], [768, 1024], [1280, 800], [3840, 2160]]) {
      const { page, quiet } = await open(flip, { ...still, width, height, hash: '#t=12.5' });
      await settle(page);
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= width, `${wide} pixels wide in ${width}`);
      await page.screenshot({ path: join(process.env.SHOTS ?? join(folder, 'shots'), `page-${width}.png`) });
      quiet();
    }
  },

  async 'it is sharp where a point is two pixels'() {
    const { page, close } = await openOnDisplay(2, flip);
    await settle(page);
    for (const canvas of ['#body', '#sphere', '#timeline', '#components']) {
      const sharp = await page.$eval(`${canvas} canvas`, (element) => element.width / element.getBoundingClientRect().width);
      assert.ok(Math.abs(sharp - 2) < 0.02, `${canvas} has ${sharp} pixels a point`);
    }
    await close();
  },

  async 'no size of a window or of a picture breaks it'() {
    const { page, quiet } = await open(flip, still);
    for (const [width, height] of [[1, 1], [3840, 2160], [200, 100], [4000, 50], [360, 740]]) {
      await page.setViewport({ width, height });
      await settle(page);
    }
    await page.$eval('#body', (box) => (box.style.display = 'none'));
    await settle(page);
    const said = await page.evaluate(async () => {
      const errors = [];
      for (const options of [{}, { width: 0, height: 9 }, { width: -5, height: 9 }, { width: 1e6, height: 1e6 }, { width: 9, height: 9, theme: 'x' }])
        await globalThis.twrench.picture(options).catch((error) => errors.push(error.message));
      return errors;
    });
    assert.equal(said.length, 5);
    for (const message of said) assert.match(message, /^picture: /);
    quiet();
  },

  async 'one WebGL context draws all views, and is restored when it is lost'() {
    const before = () => {
      globalThis.contexts = [];
      const create = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
        const context = create.call(this, kind, ...rest);
        if (kind === 'webgl2') globalThis.contexts.push(context);
        return context;
      };
    };
    const { page, quiet } = await open(flip, { ...still, hash: '#t=12', before });
    await settle(page);
    const picture = () => page.evaluate(() => globalThis.twrench.picture({ width: 160, height: 90 }));
    const whole = await picture();
    assert.equal(await page.evaluate(() => globalThis.contexts.length), 1);
    await page.evaluate(() => {
      globalThis.lost = globalThis.contexts[0].getExtension('WEBGL_lose_context');
      globalThis.lost.loseContext();
    });
    await page.waitForFunction(() => !document.getElementById('note').hidden);
    await page.click('#step-on');
    await page.click('#step-back');
    await page.evaluate(() => globalThis.lost.restoreContext());
    await page.waitForFunction(() => document.getElementById('note').hidden);
    await settle(page);
    await enter(page, '#t', '12');
    assert.equal(await picture(), whole);
    quiet();
  },

  async 'it draws only what changes'() {
    const { page, quiet } = await open(flip, still);
    await settle(page);
    const asked = await page.evaluate(async () => {
      let count = 0;
      const request = globalThis.requestAnimationFrame;
      globalThis.requestAnimationFrame = (call) => (++count, request(call));
      // On a busy machine the page may still be starting, so up to five attempts are made.
      for (let chance = 0; chance < 5; ++chance) {
        count = 0;
        await new Promise((done) => setTimeout(done, 500));
        if (count <= 1) break;
      }
      return count;
    });
    assert.ok(asked <= 1, `${asked} frames in half a second of rest`);
    quiet();
  },

  async 'it prints'() {
    const { page, quiet } = await open(flip, { ...still, hash: '#t=12.5' });
    const pdf = await page.pdf({ format: 'A4', printBackground: true });
    const pages = Buffer.from(pdf).toString('latin1').match(/\/Type\s*\/Page\b/g)?.length ?? 0;
    assert.ok(pages >= 1 && pages <= 4, `${pages} pages`);
    quiet();
  },

  async 'memory stays flat while it plays'() {
    const { page, quiet } = await open(flip, { hash: '#speed=16&t=80' }); // the herpolhode is soon recomputed
    const session = await page.createCDPSession();
    const memory = async () => {
      await session.send('HeapProfiler.collectGarbage');
      const wasm = await page.evaluate(() => globalThis.twrench.core.instance.exports.memory.buffer.byteLength);
      return { heap: (await page.metrics()).JSHeapUsedSize, wasm };
    };
    const half = Number(process.env.PLAY_SECONDS ?? 10) * 500;
    await new Promise((done) => setTimeout(done, half));
    const before = await memory();
    await new Promise((done) => setTimeout(done, half));
    const after = await memory();
    assert.equal(after.wasm, before.wasm);
    assert.ok(after.heap < before.heap + 6e6, `${before.heap} bytes became ${after.heap}`);
    quiet();
  },

  async 'no order of clicks and keys breaks it, and its memory stays flat'() {
    const { page, quiet } = await open(flip, { width: 1000, height: 800 });
    let seed = 1;
    const random = (below) => (seed = (seed * 48271) % 2147483647) % below;
    const keys = ['Tab', 'Tab', 'Tab', 'Enter', ' ', 'ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight', 'Home', 'End', 'PageUp', 'PageDown', 'Escape', '5', '.', '-', 'e', 'Backspace'];
    const heap = async () => {
      const session = await page.createCDPSession();
      await session.send('HeapProfiler.collectGarbage');
      return (await page.metrics()).JSHeapUsedSize;
    };
    const seconds = Number(process.env.MONKEY_SECONDS ?? 15);
    const half = async (until) => {
      while (performance.now() < until) {
        if (random(2)) await page.keyboard.press(keys[random(keys.length)]);
        else {
          await page.mouse.move(random(1000), random(800));
          await page.mouse.down();
          if (random(3) === 0) await page.mouse.move(random(1000), random(800), { steps: 3 });
          await page.mouse.up();
          if (random(8) === 0) await page.mouse.wheel({ deltaY: random(600) - 300 });
        }
      }
    };
    const start = performance.now();
    await half(start + 500 * seconds);
    const before = await heap();
    await half(start + 1000 * seconds);
    const after = await heap();
    assert.ok(after < before + 12e6, `${(before / 1e6).toFixed(1)} MB became ${(after / 1e6).toFixed(1)}`);
    assert.equal((await sample(page, 1)).X.every(Number.isFinite), true);
    quiet();
  },
};

await run(tests, [
  'it plays, and stands still for those who want less motion',
  'the page is accessible: axe reports no violations',
  'it is sharp where a point is two pixels',
  'it prints',
  'memory stays flat while it plays',
  'no order of clicks and keys breaks it, and its memory stays flat',
]);
