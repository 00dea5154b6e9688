// Tests of pages of bodies with a wheel or energy loss: the core's numbers, the controls, links, and
// copied and saved texts.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { folder, open, run, twrench, writePage } from './browser.mjs';
import { copied, enter, sample, saved, settle, shown, still } from './controls.mjs';

const flip = writePage('flip.html');
const dualSpin = writePage('dual-spin.html', 'dual-spin');

const distance = (a, b) => Math.max(...[...a].map((x, i) => Math.abs(x - b[i])));
const tight = ['--method', 'taylor', '--tolerance', '1e-15'];

/** The attitude that the program computes. */
const simulated = (t, ...words) =>
  twrench('simulate', ...words, '--times', String(t)).trim().split('\n')[1].split(',').slice(1, 10).map(Number);

/** The n-th field of what moves in the body: hx, hy, hz, tau. */
const field = (n, kind) => `#interior .field:nth-child(${n}) input[${kind}]`;
const text = (n) => field(n, 'inputmode=decimal');
const slider = (n) => field(n, 'type=range');

const isShown = (page, id) => page.$eval(id, (element) => element.offsetParent !== null);
const isInLink = (page, pair) =>
  page.waitForFunction((expected) => decodeURIComponent(location.hash).slice(1).split('&').includes(expected), {}, pair);

const tests = {
  async 'the motion is that of the reference to 1e-12, forward and back'() {
    const cases = JSON.parse(readFileSync(join(dirname(process.env.REFERENCE), 'constant_momentum.json')));
    const { page, quiet } = await open(flip, still);
    for (const c of cases) {
      const interior = { wheel: (c.rotor ?? [0, 0, 0]).map(Number), energyLossTime: Number(c.tau ?? 0) || null };
      const found = await page.evaluate(
        (inertia, omega, { wheel, energyLossTime }, times) => {
          const motion = globalThis.twrench.core.motion(inertia, omega, { wheel, energyLossTime: energyLossTime ?? Infinity });
          const forward = times.map((t) => motion.at(t));
          const back = [...times].reverse().map((t) => motion.at(t));
          return { kind: motion.facts.kind, forward, back: back.reverse() };
        },
        c.inertia.flat().map(Number), c.omega0.map(Number), interior, c.samples.map((s) => s.t),
      );
      assert.equal(found.kind, null);
      assert.deepEqual(found.back, found.forward);
      c.samples.forEach((expected, i) => {
        assert.ok(distance(found.forward[i].X, expected.X.flat().map(Number)) <= 1e-12, `${c.name} X(${expected.t})`);
        assert.ok(distance(found.forward[i].omega, expected.omega.map(Number)) <= 1e-12, `${c.name} omega(${expected.t})`);
      });
    }
    assert.equal(cases.length, 4);
    quiet();
  },

  async 'a closed form is used where there is one, and the integrated motion has an end'() {
    const { page, quiet } = await open(flip, still);
    const found = await page.evaluate(() => {
      const { core } = globalThis.twrench;
      const symmetric = core.motion([2, 0, 0, 0, 2, 0, 0, 0, 3], [0.1, 0, 1], { wheel: [0, 0, 1], energyLossTime: Infinity });
      const other = core.motion([2, 0, 0, 0, 3, 0, 0, 0, 4], [0.1, 0, 1], { wheel: [0, 0, 1], energyLossTime: Infinity });
      const messages = [];
      for (const t of [-1, 1e9, NaN]) {
        try {
          other.at(t);
        } catch (error) {
          messages.push(error.message);
        }
      }
      return { far: symmetric.at(1e9).X, kind: symmetric.facts.kind, longest: other.facts.longest, messages, X: other.at(10).X };
    });
    assert.notEqual(found.kind, null);
    assert.ok(found.far.every(Number.isFinite));
    assert.equal(found.messages.length, 3);
    for (const message of found.messages) assert.match(message, /^t: /);
    assert.ok(found.longest > 1e4 && found.longest < 1e6);
    assert.ok(distance(found.X, simulated(10, '--inertia', '2,3,4', '--omega', '0.1,0,1', '--wheel', '0,0,1', ...tight)) <= 1e-12);
    quiet();
  },

  async 'the page of a film that compares wheels begins with the last, and the sliders change it'() {
    const { page, quiet } = await open(dualSpin, still);
    const held = (await sample(page, 40)).X;
    assert.ok(distance(held, simulated(40, 'dual-spin', '--wheel', '4e7,0,0', ...tight)) <= 1e-11);
    assert.match(await shown(page, '#readout'), /does not turn over/);
    assert.equal(await isShown(page, '#poinsot'), false, 'the ellipsoid');
    assert.equal(await isShown(page, '#sphere'), true, 'the sphere');
    assert.match(await shown(page, '#holding'), /1\.9·10⁷/);
    await page.focus(slider(1));
    await page.keyboard.press('ArrowLeft');
    await settle(page);
    assert.ok(distance((await sample(page, 40)).X, held) > 1e-3, 'slider');
    await page.click('#compared button:nth-child(1)');
    await settle(page);
    assert.match(await shown(page, '#readout'), /flips: 0 · next in/);
    assert.equal(await isShown(page, '#poinsot'), true, 'the ellipsoid of the rigid body');
    assert.deepEqual((await sample(page, 40)).X, simulated(40, 'dual-spin', '--method', 'exact'));
    await enter(page, text(1), '4e7');
    assert.deepEqual((await sample(page, 40)).X, held);
    await enter(page, text(2), '-3e6');
    await isInLink(page, 'wheel=40000000,-3000000,0');
    assert.ok(distance((await sample(page, 40)).X, simulated(40, 'dual-spin', '--wheel', '4e7,-3e6,0', ...tight)) <= 1e-11);
    quiet();
  },

  async 'flips are those of the integrated motion'() {
    const { page, quiet } = await open(writePage('t.html', 't-handle', '--wheel', '1000,0,0', '--duration', '8'), still);
    const study = JSON.parse(twrench('study', 't-handle', '--wheel', '1000,0,0', '--duration', '8', '--methods', 'taylor', '--tolerances', '1e-15', '--format', 'json'));
    const times = study.methods[0].runs[0].flips;
    assert.equal(times.length, 6);
    for (const t of times) {
      await page.click('#flip-on');
      await settle(page);
      const now = await page.$eval('#timeline', (element) => Number(element.getAttribute('aria-valuenow')));
      assert.ok(Math.abs(now - t) < 1e-5, `${now} in place of ${t}`);
    }
    await page.click('#flip-back');
    await settle(page);
    assert.match(await shown(page, '#readout'), new RegExp(`flips: ${times.length - 1} · next in`));
    quiet();
  },

  async 'energy is lost over a timeline of five time constants, and impossible times are reported'() {
    const { page, quiet } = await open(flip, still);
    await enter(page, text(4), '40');
    await isInLink(page, 'energy_loss_time=40');
    assert.equal(await page.$eval('#length', (input) => input.value), '200');
    const { X } = await sample(page, 100);
    assert.ok(distance(X, simulated(100, '--energy-loss-time', '40', ...tight)) <= 1e-11);
    assert.match(await shown(page, '#readout'), /energy: 100\.0 %/);
    await enter(page, '#t', '200');
    assert.match(await shown(page, '#readout'), /energy: 6\d\.\d %/);
    assert.equal(await page.$eval('#flip-on', (button) => button.disabled), true);
    await isInLink(page, 't=200');
    const link = await page.evaluate(() => location.hash);
    await enter(page, text(4), '0.1');
    assert.match(await shown(page, '#interior-note'), /^energy_loss_time: is 0.1 s, but must be above/);
    assert.deepEqual((await sample(page, 100)).X, X, 'the motion goes on');
    assert.equal(await page.evaluate(() => location.hash), link);
    await page.click('input[name=body][value=moments]');
    for (const n of [1, 2, 3]) await enter(page, `#moments .field:nth-child(${n}) input[inputmode=decimal]`, '800');
    assert.match(await shown(page, '#interior-note'), /no single axis of greatest moment/);
    await enter(page, text(4), '∞');
    assert.equal(await shown(page, '#interior-note'), '');
    await page.click('#reset');
    await settle(page);
    assert.equal(await page.$eval('#length', (input) => input.value), '96');
    assert.deepEqual((await sample(page, 50)).X, simulated(50, '--method', 'exact'));
    quiet();
  },

  async 'the geometric phase of a rigid body is stated and shaded'() {
    const { page, quiet } = await open(flip, still);
    const numbers = async () => (await shown(page, '#phase')).match(/−?\d[\d.]*/g).map((text) => Number(text.replace('−', '-')));
    for (const omega of ['1,0.05,0', '0.2,0.1,1']) {
      for (const [i, value] of omega.split(',').entries()) await enter(page, `#omega .field:nth-child(${i + 1}) input[inputmode=decimal]`, value);
      const scene = join(folder, 'phase.toml');
      writeFileSync(scene, `[body]\nmoments = [982.2713030224087, 722.6710300807721, 1578.650308428871]\n[motion]\nomega = [${omega}]\n`);
      const { phase } = JSON.parse(twrench('inertia', scene, '--format', 'json')),
        [period, ...angles] = await numbers();
      assert.ok(Math.abs(period / phase.period - 1) < 0.005, `${period}`);
      ['total', 'dynamic', 'geometric'].forEach((name, i) =>
        assert.ok(Math.abs(angles[i] - phase[name]) <= 1e-5 * Math.abs(phase[name]), `${name}: ${angles[i]} in place of ${phase[name]}`),
      );
    }
    await page.$eval('#sphere', (view) => view.scrollIntoView());
    await settle(page);
    const plain = await page.$eval('#sphere canvas', (canvas) => canvas.toDataURL());
    await page.click('#show label:has([data-word=feature_phase]) input');
    await page.waitForFunction(() => location.hash.includes('phase'));
    await page.$eval('#sphere', (view) => view.scrollIntoView()); // the click scrolled it away, and hidden views are not drawn
    await page.waitForFunction((before) => document.querySelector('#sphere canvas').toDataURL() !== before, {}, plain);
    const command = await copied(page, '#copy-command');
    assert.match(command, /--show phase/);
    const words = command.split(' ').slice(1, -2);
    twrench(...words, '--size', '96x64', '--frames', '0', '--no-video', '--progress', 'none', '--frames-dir', join(folder, 'phase'));
    await enter(page, text(3), '100');
    assert.equal(await isShown(page, '#phase'), false, 'no closed curve with a wheel');
    assert.equal(await isShown(page, '#show label:has([data-word=feature_phase])'), false);
    quiet();
  },

  async 'a link holds the wheel and the energy loss, and reports impossible ones'() {
    const state = '#t=12&wheel=10,-20,30.5&energy_loss_time=40&length=200';
    const { page, quiet } = await open(flip, { ...still, hash: state });
    const link = await copied(page, '#copy-link');
    const pairs = (hash) => new Set(decodeURIComponent(hash.slice(hash.indexOf('#') + 1)).split('&'));
    assert.deepEqual(pairs(link), pairs(state));
    const again = await open(flip, { ...still, hash: link.slice(link.indexOf('#')) });
    const { X } = await sample(again.page, 30);
    assert.deepEqual(X, (await sample(page, 30)).X);
    assert.ok(distance(X, simulated(30, '--wheel', '10,-20,30.5', '--energy-loss-time', '40', ...tight)) <= 1e-12);
    assert.deepEqual(await page.$$eval('#interior input[inputmode=decimal]', (all) => all.map(({ value }) => value)), ['10', '-20', '30.5', '40']);
    quiet();
    const lossy = writePage('lossy.html', '--energy-loss-time', '40');
    const without = await open(lossy, { ...still, hash: '#energy_loss_time=inf' });
    assert.deepEqual((await sample(without.page, 50)).X, simulated(50, '--method', 'exact'));
    assert.match(await copied(without.page, '#copy-link'), /#energy_loss_time=inf$/);
    for (const [hash, message] of [
      ['#wheel=1,2', /wheel=1,2/],
      ['#wheel=1,2,1e99', /wheel=1,2,1e99/],
      ['#energy_loss_time=-3', /energy_loss_time=-3/],
      ['#energy_loss_time=Infinity', /energy_loss_time=Infinity/],
      ['#energy_loss_time=0.01', /energy_loss_time: is 0.01 s, but must be above/],
      ['#wheel=100,0,0&t=1e9', /t: the motion is computed up to \d+/],
    ]) {
      const bad = await open(flip, { ...still, hash });
      assert.match(await shown(bad.page, '#note'), message);
      assert.deepEqual((await sample(bad.page, 50)).X, simulated(50, '--method', 'exact'), hash);
      bad.quiet();
    }
  },

  async 'the copied command and the scene file make this very motion'() {
    writeFileSync(join(folder, 'shown.toml'), `[body]\nmoments = [3, 4, 5]\n[overlay]\nview = "poinsot"\nshow = ["hud", "tilt", "drift", "moments"]\ncompare = ["exact", "rk4"]\n`);
    for (const [words, hash] of [
      [['dzhanibekov'], '#wheel=100,0,0&show=floor,plane'],
      [[join(folder, 'shown.toml')], '#compare=off&energy_loss_time=40'],
      [['dual-spin'], ''],
      [['dual-spin'], '#wheel=0,0,0'],
      [['t-handle', '--wheel', '6000,0,0'], '#wheel=0,0,0'],
      [['t-handle', '--wheel', '6000,0,0'], '#wheel=3000,10,-10&compare=beside&methods=rk4,cf4&step=0.001'],
    ]) {
      const { page, quiet } = await open(writePage('copied.html', ...words), { ...still, hash });
      const command = await copied(page, '#copy-command');
      const frames = join(folder, `copied-${Math.random()}`);
      const line = command.replace(/^twrench/, '"$TWRENCH"').replace(/-o flip\.mp4$/, '');
      execFileSync('sh', ['-c', `${line} --no-video --frames 0,7,200 --size 64x36 --progress none --frames-dir ${frames}`], { cwd: folder });
      const manifest = JSON.parse(readFileSync(join(frames, 'manifest.json'), 'utf8'));
      assert.equal(manifest.frames.length, 3);
      for (const frame of manifest.frames) {
        const apart = distance((await sample(page, frame.t)).X, frame.X);
        assert.ok(apart <= 1e-12, `${command}: ${apart} at ${frame.t} s`);
      }
      const integrated = !/wheel=0,0,0|compare=beside/.test(hash);
      assert.equal(/--tolerance 1e-15/.test(command), integrated, command);
      quiet();
      if (words[0] === 't-handle') continue; // its mesh is not beside the copied file
      writeFileSync(join(folder, 'copied.toml'), await copied(page, '#copy-scene'));
      assert.ok(distance((await sample(page, 5)).X, simulated(5, join(folder, 'copied.toml'))) <= 1e-11, `the scene file of ${words} ${hash}`);
      execFileSync('sh', ['-c', `"$TWRENCH" render copied.toml --no-video --frames 1 --size 64x36 --progress none --frames-dir ${frames} --overwrite`], { cwd: folder });
    }
  },

  async 'the saved data are those of twrench simulate'() {
    for (const [words, hash] of [
      [['--wheel', '100,0,0', '--duration', '5'], ''],
      [['--energy-loss-time', '40', '--duration', '5'], ''],
    ]) {
      const { page, quiet } = await open(writePage('data.html', ...words), { ...still, hash });
      const rows = (await saved(page, '#save-csv')).trim().split('\n'),
        expected = twrench('simulate', ...words, ...tight).trim().split('\n');
      assert.equal(rows[0], expected[0]);
      assert.equal(rows.length, expected.length);
      rows.slice(1).forEach((row, i) => {
        const numbers = row.split(',').map(Number), others = expected[i + 1].split(',').map(Number);
        numbers.forEach((x, k) => assert.ok(Math.abs(x - others[k]) <= 1e-12 * Math.max(1, Math.abs(x)), `${x} and ${others[k]} in row ${i}`));
      });
      quiet();
    }
  },

  async 'methods are compared with taylor, because there is no closed form'() {
    const { page, quiet } = await open(flip, { ...still, hash: '#energy_loss_time=40&compare=beside&methods=exact,rk4&step=0.25&t=20' });
    await page.waitForFunction(() => /\d/.test(document.querySelector('#errors tbody tr:nth-child(1) td:nth-child(3)').textContent));
    assert.equal(await page.$eval('#method-a', (select) => select.value), 'taylor');
    assert.equal(await page.$eval('#method-a option[value=exact]', (option) => option.disabled), true);
    assert.match(await shown(page, '#errors caption'), /taylor/);
    const cells = await page.$$eval('#errors tbody tr', (rows) => rows.filter((row) => !row.hidden).map((row) => [...row.cells].map((cell) => cell.textContent)));
    assert.deepEqual(cells.map(([head]) => head), ['attitude, rad', 'energy drift', 'momentum', '|XᵀX − 1|', 'steps']);
    const number = (cell) => Number(cell.replace('−', '-').replace('·10', 'e').replace(/[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]/g, (c) => '-0123456789'['⁻⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(c)]));
    assert.ok(Math.abs(number(cells[1][2])) < 1e-2, `energy that is lost is no error: ${cells[1][2]}`);
    assert.ok(Math.abs(number(cells[0][2])) > 1e-6, 'rk4 is not exact');
    await enter(page, text(4), '∞');
    assert.match(await shown(page, '#errors caption'), /exact/);
    assert.equal(await page.$eval('#method-a option[value=exact]', (option) => option.disabled), false);
    quiet();
  },

  async 'a time beyond the end is limited'() {
    const { page, quiet } = await open(dualSpin, still);
    await page.click('#compared button:nth-child(1)');
    await enter(page, '#t', '1000000000');
    await enter(page, text(1), '4e7');
    assert.equal(await isShown(page, '#poinsot'), false);
    assert.equal(await page.$eval(text(1), (input) => input.value), '40000000');
    assert.ok((await page.$eval('#t', (input) => Number(input.value))) < 1e6);
    assert.equal(await shown(page, '#note'), '');
    quiet();
  },
};

await run(tests);
