// Tests of pages that play a recorded motion beside the exact one: the numbers, the first figure, and the
// copied command.
import assert from 'node:assert/strict';
import { statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { folder, open, run, twrench, writePage } from './browser.mjs';
import { copied, enter, sample, settle, shown, still } from './controls.mjs';

const degree = Math.PI / 180;
const file = join(folder, 'run.csv');
const tilted = ['--attitude', '0.8,0.6,0,0'];
twrench('simulate', 't-handle', ...tilted, '--method', 'midpoint', '--step', '0.01', '--duration', '4', '--fps', '50', '-o', file);
const recorded = writePage('recorded.html', 't-handle', '--motion', file);

/** X at t in columns of the CSV file that `simulate` writes. */
const simulated = (t, ...words) =>
  twrench('simulate', 't-handle', ...words, '--times', String(t)).trim().split('\n')[1].split(',').slice(1, 10).map(Number);
const distance = (a, b) => Math.max(...[...a].map((x, i) => Math.abs(x - b[i])));

/** The angle in rad of the rotation from one matrix to another. */
const angle = (a, b) => {
  const trace = a.reduce((sum, x, i) => sum + x * b[i], 0);
  return Math.acos(Math.min(1, (trace - 1) / 2));
};

const tests = {
  async 'it shows the rows of the recording, and the exact motion from their start'() {
    const { page, quiet } = await open(recorded, still);
    const rows = simulated(1.5, ...tilted, '--method', 'midpoint', '--step', '0.01');
    assert.ok(distance((await sample(page, 1.5)).X, rows) <= 2e-8, 'the matrices of the file are not quite orthogonal');
    const exact = await page.evaluate(() => {
      const { core } = globalThis.twrench;
      const { rows: instants } = JSON.parse(document.getElementById('scene').textContent).recording;
      const names = core.methods.map(({ name }) => name);
      return { names, X: core.recording.at(0).X, isPacked: typeof instants === 'string' };
    });
    assert.ok(exact.names.includes('recorded') && exact.isPacked);
    assert.ok(distance(exact.X, simulated(0, ...tilted, '--method', 'exact')) <= 1e-12);
    quiet();
  },

  async 'the first figure states the angle between them'() {
    const { page, quiet } = await open(recorded, { ...still, width: 1280, height: 800 });
    const [first] = await page.evaluate(() => globalThis.twrench.figures());
    assert.equal(first.id, 'recorded');
    assert.match(await page.$eval('#part-recorded .text', (text) => text.textContent), /run\.csv/);
    await enter(page, '#part-recorded .field input[inputmode]', '3');
    const [, apart] = await page.$$eval('#part-recorded .readout .number', (all) => all.map((one) => one.textContent));
    const ought = angle(simulated(3, ...tilted, '--method', 'midpoint', '--step', '0.01'), simulated(3, ...tilted, '--method', 'exact'));
    assert.ok(Math.abs(parseFloat(apart) * degree - ought) <= 0.01 * ought, `${apart} in place of ${ought / degree}`);
    quiet();
  },

  async 'the lab compares it, and the copied command films it'() {
    const { page, quiet } = await open(recorded, { ...still, width: 1280, height: 800 });
    assert.match(await shown(page, '#name-a'), /recorded/);
    assert.match(await shown(page, '#name-b'), /exact/);
    const command = await copied(page, '#copy-command');
    assert.match(command, /^twrench render t-handle --motion .*run\.csv /);
    assert.match(command, /--compare exact /);
    assert.doesNotMatch(command, /--(omega|attitude|method)/);
    await enter(page, '#omega .field:nth-child(1) input[inputmode]', '0.5');
    const other = await copied(page, '#copy-command');
    assert.doesNotMatch(other, /--motion/);
    assert.match(other, /--omega 0\.5,/);
    assert.match(other, /--attitude 0\.8,0\.6,0,0 /);
    await settle(page);
    quiet();
  },

  async 'the copied command leaves a recording to the scene file that names it'() {
    const scene = join(folder, 'own.toml');
    writeFileSync(scene, "[body]\nmoments = [2, 3, 4.5]\n[motion]\nfile = 'run.csv'\n");
    const { page, quiet } = await open(writePage('own.html', scene), { ...still, width: 1280, height: 800 });
    const command = await copied(page, '#copy-command');
    assert.match(command, /^twrench render \S*own\.toml .*--compare exact /);
    assert.doesNotMatch(command, /--(motion|omega|method)/);
    await enter(page, '#omega .field:nth-child(1) input[inputmode]', '0.5');
    // No option replaces the recording, so the command films the copied scene file.
    assert.match(await copied(page, '#copy-command'), /^# .*\ntwrench render flip\.toml -o flip\.mp4$/);
    await settle(page);
    quiet();
  },

  async 'a long recording leaves the page below a megabyte'() {
    const long = join(folder, 'long.csv');
    twrench('simulate', 'tennis-racket', '--method', 'rk4', '--duration', '30', '--fps', '600', '-o', long);
    const page = writePage('long.html', 'tennis-racket', '--motion', long);
    assert.ok(statSync(page).size < 1_000_000);
    const opened = await open(page, still);
    assert.ok(distance((await sample(opened.page, 20)).X, twrench('simulate', 'tennis-racket', '--method', 'rk4', '--times', '20').trim().split('\n')[1].split(',').slice(1, 10).map(Number)) < 1e-4);
    opened.quiet();
  },
};

await run(tests);
