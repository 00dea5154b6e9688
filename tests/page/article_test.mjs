// Tests of a page's article: its figures react to their controls with the numbers of the core, one figure plays at
// a time, and the text fits and is accessible.
import assert from 'node:assert/strict';
import { readFileSync, statSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { open, run, writePage } from './browser.mjs';

const flip = writePage('article.html');
const axe = readFileSync(join(dirname(createRequire(import.meta.url).resolve('axe-core')), 'axe.min.js'), 'utf8');
const still = { features: [{ name: 'prefers-reduced-motion', value: 'reduce' }] };
const dark = { features: [...still.features, { name: 'prefers-color-scheme', value: 'dark' }] };
const wide = { width: 1280, height: 800 };
const mostBytes = 480_000;

const settle = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
const figures = (page) => page.evaluate(() => globalThis.twrench.figures());
const figure = async (page, id) => (await figures(page)).find((one) => one.id === id);
const ids = ['flip', 'axes', 'try', 'constant', 'frame', 'stable', 'sphere', 'waiting', 'inside', 'methods'];

/** The numbers in the readout of a figure, such as 23.6 or 1.2·10⁻⁸. */
const readout = (page, id) =>
  page.$$eval(`#part-${id} .readout .number`, (all) =>
    all.map(({ textContent }) => {
      const digits = (text) => [...text].map((c) => ('⁰¹²³⁴⁵⁶⁷⁸⁹'.includes(c) ? '⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(c) : c === '⁻' ? '-' : c)).join('');
      const [, value, , power] = textContent.match(/(−?[\d.]+)(·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?/);
      return Number(value.replace('−', '-')) * 10 ** Number(power ? digits(power) : 0);
    }),
  );

const near = (found, expected, what, share = 0.006) =>
  assert.ok(Math.abs(found - expected) <= share * Math.abs(expected), `${what}: ${found} in place of ${expected}`);

/** Scrolls to a figure and drags its slider to a share of its length; returns the value in the field beside it. */
async function drag(page, id, share) {
  const slider = await page.$(`#part-${id} input[type=range]`);
  await slider.evaluate((element) => element.scrollIntoView({ block: 'center' }));
  await settle(page);
  const { x, y, width, height } = await slider.boundingBox();
  await page.mouse.move(x + 0.2 * width, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + share * width, y + height / 2, { steps: 4 });
  await page.mouse.up();
  await new Promise((done) => setTimeout(done, 300)); // a slow machine may still be drawing
  await settle(page);
  return Number(await page.$eval(`#part-${id} .field input[inputmode]`, (input) => input.value));
}

/** Evaluates with the core, the moments (ascending) and the inertia of the default scene's body. */
const core = (page, act, ...values) =>
  page.evaluate(
    (text, ...rest) => {
      const { core } = globalThis.twrench,
        inertia = [982.2713030224087, 0, 0, 0, 722.6710300807721, 0, 0, 0, 1578.650308428871];
      return new Function('core', 'inertia', '...rest', `return (${text})(core, inertia, ...rest)`)(core, inertia, ...rest);
    },
    String(act),
    ...values,
  );

/** The largest angle between L and the body axis `axis`, in degrees. */
const largestLean = (page, omega, axis, wheel = [0, 0, 0]) =>
  core(
    page,
    (c, inertia, start, k, h) => {
      const motion = c.motion(inertia, start, { wheel: h, energyLossTime: Infinity }),
        times = Array.from({ length: 2001 }, (_, i) => (i * 60) / 2000),
        { omega: all } = motion.samples(times);
      let most = 0;
      for (let i = 0; i < times.length; ++i) {
        const m = [0, 1, 2].map((j) => inertia[4 * j] * all[3 * i + j] + h[j]);
        most = Math.max(most, Math.acos(m[k] / Math.hypot(...m)));
      }
      return (180 / Math.PI) * most;
    },
    omega,
    axis,
    wheel,
  );

/** Runs before the scripts of a page: the browser has no WebGL 2. */
const withoutWebGL = () => {
  const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
    return kind === 'webgl2' ? null : getContext.call(this, kind, ...rest);
  };
};

/** The pictures of the views, each as the colours of small squares, by the names of their stills. */
const thumbnails = async (page, selector) => {
  const found = [];
  for (const view of await page.$$(selector)) {
    await view.evaluate((element) => element.scrollIntoView({ block: 'center' }));
    await settle(page);
    await settle(page);
    found.push(
      await view.evaluate((element) => {
        const small = Object.assign(document.createElement('canvas'), { width: 48, height: 32 }),
          context = small.getContext('2d');
        context.imageSmoothingQuality = 'high';
        context.drawImage(element.querySelector('canvas'), 0, 0, 48, 32);
        return [element.dataset.still + (element.dataset.pane ?? ''), [...context.getImageData(0, 0, 48, 32).data]];
      }),
    );
  }
  return Object.fromEntries(found);
};

/** The mean difference of the samples of two thumbnails, of 255. */
const meanDifference = (a, b) => a.reduce((sum, value, i) => sum + Math.abs(value - b[i]), 0) / a.length;

const tests = {
  async 'before it draws, each view shows the same as when it draws'() {
    const views = '#article .view, #stage .view, #views .view';
    for (const size of [wide, { width: 1920, height: 1080 }]) {
      const page = async (more) => {
        const { page, quiet } = await open(flip, { ...dark, ...size, ...more });
        const found = await thumbnails(page, views);
        quiet();
        return found;
      };
      const stills = await page({ before: withoutWebGL }),
        drawn = await page({});
      const names = Object.keys(drawn);
      assert.deepEqual(Object.keys(stills), names);
      assert.equal(names.length, ids.length + 4);
      for (const name of names) {
        const difference = meanDifference(stills[name], drawn[name]);
        // The lines of an inset are thicker in a small picture.
        assert.ok(difference < (/sphere1|^sphere|poinsot/.test(name) ? 9 : 3.5), `${name} at ${size.width}: ${difference}`);
      }
    }
  },

  async 'without WebGL the stills stay, with a note in the language of the page'() {
    const { page, quiet } = await open(flip, { ...wide, before: withoutWebGL });
    const note = () => page.$eval('#stills-note', (element) => element.innerText);
    assert.match(await note(), /WebGL 2.*do not move/);
    await page.select('#lang', 'nb');
    await settle(page);
    assert.match(await note(), /WebGL 2.*beveger seg ikke/);
    assert.match(await page.$eval('#part-flip', (part) => part.innerText), /23,6 s/);
    assert.ok((await figures(page)).every(({ plays }) => !plays), 'no figure plays by itself');
    assert.ok(await page.$eval('#save-png', (button) => button.hidden));
    const answer = await page.evaluate(() => globalThis.twrench.picture({ width: 64, height: 36 }).catch((error) => error.message));
    assert.match(answer, /WebGL 2/);
    assert.equal((await page.evaluate(() => globalThis.twrench.sample(0))).t, 0);
    const shown = await thumbnails(page, '#article .view');
    // The arrow of L is beside another axis of each body.
    const thirds = [0, 16, 32].map((left) => shown['part-axes'].filter((_, i) => Math.floor((i / 4) % 48 / 16) === left / 16));
    assert.ok(meanDifference(thirds[0], thirds[1]) > 1 && meanDifference(thirds[1], thirds[2]) > 1, 'three bodies');
    quiet();
    const other = await open(flip, { ...still, ...wide });
    assert.equal(await other.page.$eval('#stills-note', (element) => element.hidden), true);
    other.quiet();
  },

  async 'each figure reacts to what is dragged, with the right numbers'() {
    const { page, quiet } = await open(flip, { ...still, ...wide });
    const flips = (omega) => core(page, (c, inertia, start) => c.motion(inertia, start).facts.flips, omega);

    await drag(page, 'flip', 0.6);
    const { t } = await figure(page, 'flip');
    const { interval, first } = await flips([1, 0.05, 0]);
    assert.ok(t > first && t < first + interval);
    const [time, count, next] = await readout(page, 'flip');
    near(time, t, 'the time');
    assert.equal(count, 1);
    near(next, first + interval - t, 'the next flip');

    const push = await drag(page, 'axes', 0.9);
    assert.ok(push > 0.1 && push < 0.3, `${push}`);
    const pushed = await figure(page, 'axes'),
      leans = await readout(page, 'axes');
    assert.equal(pushed.omegas.length, 3);
    for (const [i, axis] of [1, 0, 2].entries()) {
      near(Math.hypot(...pushed.omegas[i].filter((_, k) => k !== axis)), push, 'the push', 1e-3);
      near(leans[i], await largestLean(page, pushed.omegas[i], axis), `the lean about ${'xyz'[axis]}`);
    }
    assert.ok(leans[0] < 45 && leans[1] > 150 && leans[2] < 45, leans.join());

    const angle = await drag(page, 'try', 0.3);
    assert.ok(angle > 45 && angle < 65, `${angle}`);
    const [of, every] = await readout(page, 'try');
    near(of, angle, 'the angle');
    const chosen = await figure(page, 'try');
    near(Math.atan2(chosen.omegas[0][0], chosen.omegas[0][1]), (Math.PI / 180) * angle, 'its direction');
    near(every, (await flips(chosen.omegas[0])).interval, 'its flips');

    await drag(page, 'constant', 0.25);
    const at = (await figure(page, 'constant')).t;
    const [momentum, energy, rate] = await readout(page, 'constant');
    const [exactMomentum, exactEnergy, exactRate] = await core(page, (c, inertia, now) => {
      const motion = c.motion(inertia, [1, 0.05, 0]),
        { omega } = motion.at(now);
      return [Math.hypot(...motion.facts.momentum), motion.facts.energy, Math.hypot(...omega)];
    }, at);
    near(momentum, exactMomentum, '|L|', 1e-5);
    near(energy, exactEnergy, 'E', 1e-5);
    near(rate, exactRate, '|omega|', 1e-5);

    const lean = await drag(page, 'frame', 0.5);
    const [back, over] = await readout(page, 'frame');
    // The sums of m r^2 of docs/theory.md.
    const torque = Math.sin((Math.PI / 180) * lean) * Math.cos((Math.PI / 180) * lean);
    near(over, 659.5 * torque, 'pulls over');
    near(back, 501.7 * torque, 'pulls back');
    const bars = await page.$$eval('#part-frame .tug span', (all) => all.map((bar) => bar.getBoundingClientRect().width));
    near(bars[1] / bars[0], over / back, 'the bars', 0.02);

    await drag(page, 'stable', 0.9);
    const stable = await figure(page, 'stable'),
      found = await readout(page, 'stable');
    for (const [i, axis] of [1, 0, 2].entries()) near(found[i], await largestLean(page, stable.omegas[i], axis), `stable ${i}`);

    const small = await drag(page, 'waiting', 0.3);
    assert.ok(small > 1e-8 && small < 1e-5, `${small}`);
    near((await readout(page, 'waiting'))[0], (await flips((await figure(page, 'waiting')).omegas[0])).first, 'the first flip');

    for (const [share, holds] of [[0.2, false], [0.9, true]]) {
      const wheel = await drag(page, 'inside', share);
      const [of, threshold, most] = await readout(page, 'inside');
      near(of, wheel, 'the wheel');
      near(threshold, 1578.650308428871 - 982.2713030224087, 'its threshold');
      assert.equal(wheel > threshold, holds, `${wheel}`);
      near(most, await largestLean(page, (await figure(page, 'inside')).omegas[0], 0, [wheel, 0, 0]), 'the lean of the body with a wheel');
      assert.ok(holds ? most < 15 : most > 60, `${most}`);
    }

    const before = (await figure(page, 'sphere')).omegas[0];
    await page.focus('#part-sphere .view canvas');
    await settle(page);
    for (let i = 0; i < 12; ++i) await page.keyboard.press('ArrowUp');
    await settle(page);
    const moved = (await figure(page, 'sphere')).omegas[0];
    assert.notDeepEqual(moved, before);
    near((await readout(page, 'sphere'))[0], (await flips(moved)).interval, 'the flips from there');
    quiet();
  },

  async 'the ring on the sphere can be dragged'() {
    const { page, quiet } = await open(flip, { ...still, ...wide });
    await page.$eval('#part-sphere', (part) => part.scrollIntoView());
    await settle(page);
    await settle(page);
    const before = (await figure(page, 'sphere')).omegas[0];
    const { x, y, width, height } = await (await page.$('#part-sphere .view canvas')).boundingBox();
    // The ring is near the end of the middle axis, which is below the middle on the right: look for it on a grid.
    let moved = before;
    for (let i = 12; i < 19 && String(moved) === String(before); ++i) {
      for (let k = 10; k < 15 && String(moved) === String(before); ++k) {
        await page.mouse.move(x + (width * i) / 20, y + (height * k) / 20);
        await page.mouse.down();
        await page.mouse.move(x + (width * i) / 20 + 15, y + (height * k) / 20 - 15);
        await page.mouse.up();
        await page.focus('#part-sphere .view canvas');
        await page.keyboard.press('0'); // a miss has turned the view
        moved = (await figure(page, 'sphere')).omegas[0];
      }
    }
    assert.notDeepEqual(moved, before);
    quiet();
  },

  async 'methods are compared at a time'() {
    const { page, quiet } = await open(flip, { ...still, ...wide });
    await drag(page, 'methods', 0.95);
    const step = Number(await page.$eval('#part-methods .field input[inputmode]', (input) => input.value));
    await page.click('#part-methods button.round');
    await page.waitForFunction(() => globalThis.twrench.figures().at(-1).t > 40, { timeout: 60_000 });
    await page.click('#part-methods button.round');
    await page.waitForFunction(() => !globalThis.twrench.figures().at(-1).plays);
    await settle(page);
    const { t } = await figure(page, 'methods');
    const [exact, rk4, rkmk4] = await readout(page, 'methods');
    const expected = await core(page, (c, inertia, now, h) => {
      const motion = c.motion(inertia, [1, 0.05, 0]);
      const seen = (name) => {
        const of = motion.run(name, { step: h, tolerance: 1e-6 });
        of.samples([now]);
        return of.flipTimes().filter((time) => time <= now).length;
      };
      return [motion.flipTimes(0, now).length, seen('rk4'), seen('rkmk4')];
    }, t, step);
    assert.deepEqual([exact, rk4, rkmk4], expected);
    assert.ok(exact >= 2, `${exact}`);
    quiet();
  },

  async 'friction makes the body spin about the axis of greatest moment'() {
    const { page, quiet } = await open(flip, { ...still, ...wide });
    await page.$eval('#part-inside', (part) => part.scrollIntoView());
    await page.click('#part-inside button.round');
    await page.waitForFunction(() => globalThis.twrench.figures().at(-2).t > 25, { timeout: 60_000 });
    await page.click('#part-inside button.round');
    await page.waitForFunction(() => !globalThis.twrench.figures().at(-2).plays);
    await settle(page);
    const { t, omegas } = await figure(page, 'inside');
    const expected = await core(page, (c, inertia, now, omega) => {
      const { interval } = c.motion(inertia, [1, 0.05, 0]).facts.flips,
        motion = c.motion(inertia, omega, { wheel: [0, 0, 0], energyLossTime: interval / 5 }),
        energy = (at) => motion.at(at).omega.reduce((sum, w, k) => sum + inertia[4 * k] * w * w, 0);
      return (100 * energy(now)) / energy(0);
    }, t, omegas[1]);
    const [, , , left] = await readout(page, 'inside');
    near(left, expected, 'the energy left', 0.02);
    near(left, (100 * 722.6710300807721) / 1578.650308428871, 'as about the axis of greatest moment', 0.05);
    quiet();
  },

  async 'one figure plays at a time, and memory stays flat while the article is scrolled'() {
    const { page, quiet } = await open(flip, { width: 480, height: 480 });
    const session = await page.createCDPSession();
    const heap = async () => {
      await session.send('HeapProfiler.collectGarbage');
      return (await page.metrics()).JSHeapUsedSize;
    };
    const height = await page.evaluate(() => document.documentElement.scrollHeight - innerHeight);
    const played = new Set();
    const before = await heap();
    for (let step = 0; step <= 60; ++step) {
      await page.evaluate((y) => scrollTo(0, y), (height * step) / 60);
      await settle(page);
      const first = await figures(page);
      await settle(page);
      const second = await figures(page);
      const advanced = second.filter(({ t }, i) => t !== first[i].t);
      assert.ok(second.filter(({ plays }) => plays).length <= 1, `step ${step}`);
      // Between the two looks the turn may pass from one to the next.
      assert.ok(advanced.length <= 2, `step ${step}: ${advanced.map(({ id }) => id)}`);
      for (const { id } of second.filter(({ plays }) => plays)) played.add(id);
    }
    assert.deepEqual([...played], ids, 'each gets its turn');
    assert.ok((await figures(page)).every(({ plays }) => !plays), 'none plays at the end of the lab');
    const after = await heap();
    assert.ok(after < before + 10e6, `${before} bytes became ${after}`);
    quiet();
  },

  async 'a figure that the reader pauses stays paused, and one outside the window is not drawn'() {
    const before = () => {
      globalThis.drawn = [];
      const draw = CanvasRenderingContext2D.prototype.drawImage;
      CanvasRenderingContext2D.prototype.drawImage = function (image, ...rest) {
        globalThis.drawn.push([this.canvas.closest('section')?.id, image.tagName]);
        return draw.call(this, image, ...rest);
      };
    };
    const { page, quiet } = await open(flip, { ...wide, before });
    await page.waitForFunction(() => globalThis.twrench.figures()[0].t > 0);
    const drawn = await page.evaluate(() => globalThis.drawn);
    assert.deepEqual(drawn.find(([part]) => part === 'part-flip'), ['part-flip', 'IMG'], 'the still image comes first');
    assert.ok(drawn.some(([part, image]) => part === 'part-flip' && image === 'CANVAS'));
    assert.ok(!drawn.some(([part, image]) => part === 'part-methods' && image === 'CANVAS'), 'far below the window');
    await page.click('#part-flip button.round');
    await page.evaluate(() => document.getElementById('part-try').scrollIntoView());
    await page.waitForFunction(() => globalThis.twrench.figures().some(({ id, plays }) => id === 'try' && plays));
    await page.evaluate(() => scrollTo(0, 0));
    await page.waitForFunction(() => globalThis.twrench.figures().every(({ plays }) => !plays));
    await settle(page);
    assert.equal((await figure(page, 'flip')).plays, false);
    quiet();
  },

  async 'nothing plays by itself for those who want less motion, and a button plays'() {
    const { page, quiet } = await open(flip, { ...still, ...wide });
    for (const id of ids) {
      await page.$eval(`#part-${id}`, (part) => part.scrollIntoView());
      await settle(page);
      assert.ok((await figures(page)).every(({ plays, t }) => !plays && t === 0), id);
    }
    await page.$eval('#part-flip', (part) => part.scrollIntoView());
    await page.focus('#part-flip button.round');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => globalThis.twrench.figures()[0].t > 0);
    quiet();
  },

  async 'the keyboard reaches the picture, the button, the slider and the words, in this order'() {
    const { page, quiet } = await open(flip, { ...still, ...wide });
    await page.focus('#part-constant canvas');
    const before = await page.$eval('#part-constant canvas', (canvas) => canvas.toDataURL());
    await page.keyboard.press('ArrowLeft');
    await settle(page);
    await settle(page);
    assert.notEqual(await page.$eval('#part-constant canvas', (canvas) => canvas.toDataURL()), before, 'an arrow turns the picture');
    const visited = [];
    for (let i = 0; i < 6; ++i) {
      await page.keyboard.press('Tab');
      visited.push(await page.evaluate(() => document.activeElement.type ?? document.activeElement.tagName));
      if (visited.at(-1) === 'range') await page.keyboard.press('ArrowRight');
    }
    assert.deepEqual(visited, ['button', 'range', 'text', 'button', 'button', 'button']);
    assert.ok((await figure(page, 'constant')).t > 0, 'an arrow moves the slider');
    assert.equal(await page.evaluate(() => document.activeElement.closest('section').id), 'part-constant');
    quiet();
  },

  async 'words stress what they name'() {
    const { page, quiet } = await open(flip, { ...still, ...wide });
    await page.$eval('#part-constant', (part) => part.scrollIntoView());
    await settle(page);
    await settle(page);
    const pixels = () => page.$eval('#part-constant .view canvas', (canvas) => canvas.toDataURL());
    const plain = await pixels();
    await page.focus('#part-constant button.thing');
    await settle(page);
    assert.notEqual(await pixels(), plain, 'the picture stresses it');
    await page.$eval('#part-constant button.thing', (button) => button.blur());
    await settle(page);
    assert.equal(await pixels(), plain, 'and no longer');
    // The colours are those of the theme.
    const color = (id) => page.$eval(`#part-${id} .thing`, (thing) => getComputedStyle(thing).color);
    await page.select('#theme', 'studio');
    await settle(page);
    const dark = await color('constant');
    await page.select('#theme', 'paper');
    await settle(page);
    assert.notEqual(await color('constant'), dark);
    quiet();
  },

  async 'both languages have all texts, and every number is filled in'() {
    const { page, quiet } = await open(flip, { ...still, ...wide });
    const texts = () => page.$$eval('#article section', (all) => all.map((part) => part.innerText));
    const english = await texts();
    assert.equal(english.length, ids.length);
    await page.select('#lang', 'nb');
    await settle(page);
    const norwegian = await texts();
    for (const [i, text] of [...english, ...norwegian].entries()) assert.doesNotMatch(text, /[{}[\]|]{2}|\{|undefined|NaN/, `${i}`);
    english.forEach((text, i) => assert.notEqual(text, norwegian[i]));
    assert.match(norwegian[0], /23,6 s/);
    assert.ok((await page.$$eval('#article .number', (all) => all.map((one) => one.textContent))).every((text) => text !== ''));
    quiet();
  },

  async 'a body without three different moments gets one that has them'() {
    const { page, quiet } = await open(writePage('ball.html', 'sphere'), { ...still, ...wide });
    await settle(page);
    const text = await page.$eval('#part-axes', (part) => part.innerText);
    assert.match(text, /700, 1000, 1500 g cm²/);
    assert.match(await page.$eval('#part-own', (part) => part.innerText), /equal, or nearly so.*it spins steadily\./s);
    quiet();
    const top = await open(writePage('top.html', '--inertia', '2,2,3', '--omega', '0.3,0,1'), { ...still, ...wide });
    await settle(top.page);
    const own = await top.page.$eval('#part-own', (part) => part.innerText);
    assert.match(own, /its axis of symmetry circles the angular momentum at an angle of 11.3°, once every 4.11 s\./);
    assert.doesNotMatch(await top.page.$eval('#article', (article) => article.innerText), /[Tt]his body turns over/);
    const omega = await top.page.evaluate(() => JSON.parse(document.getElementById('scene').textContent).scene.motion.omega);
    assert.deepEqual((await figure(top.page, 'own')).omegas, [omega], 'the motion of the scene');
    top.quiet();
  },

  async 'a body with three different moments has no section on its own motion'() {
    const { page, quiet } = await open(flip, { ...still, ...wide });
    assert.equal(await page.$('#part-own'), null);
    quiet();
  },

  async 'it is accessible: axe reports no violations'() {
    for (const [theme, lang, size] of [
      ['studio', 'en', wide],
      ['paper', 'nb', { width: 390, height: 844 }],
      ['space', 'en', { width: 320, height: 640 }],
    ]) {
      const { page, quiet } = await open(flip, { ...still, ...size });
      await page.select('#theme', theme);
      await page.select('#lang', lang);
      await settle(page);
      const session = await page.createCDPSession();
      await session.send('Page.setBypassCSP', { enabled: true });
      await page.evaluate(axe);
      const found = await page.evaluate(async () => {
        const { violations } = await globalThis.axe.run({ runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'] });
        return violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 120)).join(' | ')}`);
      });
      assert.deepEqual(found, [], theme);
      quiet();
    }
  },

  async 'figures are beside the text on a desktop, and above it on a phone'() {
    for (const [width, height] of [[1920, 1080], [1280, 800], [390, 844], [320, 640]]) {
      const { page, quiet } = await open(flip, { ...still, width, height });
      await settle(page);
      const found = await page.$$eval('#article section', (all) =>
        all.map((part) => {
          const box = (selector) => part.querySelector(selector).getBoundingClientRect();
          const [picture, text] = [box('.figure-views'), box('.text')];
          return { beside: picture.right <= text.left, above: picture.bottom <= text.top, height: picture.height };
        }),
      );
      assert.equal(found.length, ids.length);
      assert.ok(found.every((one) => (width < 900 ? one.above : one.beside)), `${width}`);
      assert.ok(found.every((one) => one.height >= 320), `${width}: ${found.map((one) => one.height)}`);
      const all = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(all <= width, `${all} pixels wide in ${width}`);
      quiet();
    }
  },

  async 'the lab alone has no article, and a link to a state shows the lab'() {
    const lab = await open(writePage('lab.html', '--lab'), { ...still, ...wide });
    assert.equal(await lab.page.$eval('#article', (article) => article.hidden && article.childElementCount === 0), true);
    assert.deepEqual(await figures(lab.page), []);
    lab.quiet();
    const link = await open(flip, { ...still, ...wide, hash: '#t=20' });
    await settle(link.page);
    const top = await link.page.$eval('#live', (live) => live.getBoundingClientRect().top);
    assert.ok(top >= 0 && top < 400, `${top}`);
    assert.equal(await link.page.$eval('#timeline', (slider) => Number(slider.ariaValueNow)), 20);
    link.quiet();
    const themed = await open(flip, { ...still, ...wide, hash: '#theme=paper' });
    await settle(themed.page);
    assert.equal(await themed.page.evaluate(() => scrollY), 0, 'a theme is no state of the lab');
    themed.quiet();
    const { page, quiet } = await open(flip, { ...still, ...wide });
    await page.click('#to-lab');
    await settle(page);
    assert.ok((await page.$eval('#live', (live) => live.getBoundingClientRect().top)) < 400);
    assert.equal(await page.$eval('#note', (note) => note.hidden), true, 'no complaint about the link');
    quiet();
  },

  async 'it is one file of a limited size'() {
    const { size } = statSync(flip);
    assert.ok(size <= mostBytes, `${size} bytes`);
  },
};

await run(tests, [
  'one figure plays at a time, and memory stays flat while the article is scrolled',
  'a figure that the reader pauses stays paused, and one outside the window is not drawn',
  'nothing plays by itself for those who want less motion, and a button plays',
  'it is accessible: axe reports no violations',
]);
