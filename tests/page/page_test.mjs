// Tests pages in a real browser: they draw, they compute the same numbers as the program, they make no
// network requests, and they run no foreign scripts.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, statSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { join } from 'node:path';
import { browser, folder, open, run, twrench, watch, writePage } from './browser.mjs';

const flip = writePage('flip.html');

const simulated = (...words) => {
  const [head, ...rows] = twrench('simulate', ...words).trim().split('\n');
  const columns = head.split(',');
  return rows.map((row) => {
    const value = Object.fromEntries(row.split(',').map((text, i) => [columns[i], Number(text)]));
    return {
      t: value.t,
      X: columns.slice(1, 10).map((name) => value[name]),
      omega: [value.wx, value.wy, value.wz],
    };
  });
};

const distance = (a, b) => Math.max(...a.map((x, i) => Math.abs(x - b[i])));

// Edges are drawn differently and may be displaced by a pixel. At most 8 of 1000 other pixels may
// differ by more than 8 of 255. This bound is twice the measured share (2.3 of 1000, and 3.6 for the
// racket's strings), because browsers change their renderers. Wrong light or a wrong colour changes the whole
// body, which is a twentieth of the picture or more.
async function expectPictureOfFilm(page, scene, frame, theme) {
  const frames = join(folder, `${scene.replace(/\W/g, '')}-${theme}`);
  const show = ['floor', 'momentum', 'omega', 'trail'];
  twrench('render', scene, '--method', 'exact', '--size', '960x540', '--theme', theme, '--no-video', '--frames', String(frame),
    '--bare', '--show', show.join(), '--frames-dir', frames, '--progress', 'none', '--overwrite');
  const manifest = JSON.parse(readFileSync(join(frames, 'manifest.json')));
  const { t } = manifest.frames.find((each) => each.frame === frame);
  const shown = { width: 960, height: 540, t, theme, show };
  const url = await page.evaluate((options) => globalThis.twrench.picture(options), shown);
  const picture = join(folder, 'picture.png');
  writeFileSync(picture, Buffer.from(url.split(',')[1], 'base64'));
  execFileSync('convert', [picture, '-alpha', 'off', `PNG24:${picture}`]);
  twrench('compare', join(frames, `frame_${String(frame).padStart(6, '0')}.png`), picture,
    '--threshold', '8', '--edges', '1', '--share', '0.008');
}

const coloredCube = `ply
format ascii 1.0
element vertex 8
property float x
property float y
property float z
property uchar red
property uchar green
property uchar blue
element face 12
property list uchar int vertex_indices
end_header
${[0, 1, 2, 3, 4, 5, 6, 7].map((i) => [1, 2, 4].map((bit) => (i & bit ? 0.5 : -0.5)).join(' ') + ' ' + [1, 2, 4].map((bit) => (i & bit ? 255 : 20)).join(' ')).join('\n')}
${['0 2 1', '1 2 3', '4 5 6', '5 7 6', '0 1 4', '1 5 4', '2 6 3', '3 6 7', '0 4 2', '2 4 6', '1 3 5', '3 7 5'].map((face) => `3 ${face}`).join('\n')}
`;

const sceneOfShapes = [
  'shape = "torus"\nradius = 1.6\ntube_radius = 0.4\nmaterial = "brass"\ndensity = 8.5',
  'shape = "tube"\nradius = 0.5\ninner_radius = 0.35\nlength = 4.0\naxis = [1.0, 0.3, 0.0]\nposition = [0.0, 0.0, 1.2]\nmaterial = "plastic"\ncolor = "#c03030"\ndensity = 1.2',
  'shape = "capsule"\nradius = 0.3\nlength = 2.5\naxis = [0.0, 1.0, 0.2]\nposition = [0.0, 0.4, -1.2]\nmaterial = "steel"\ndensity = 7.8',
  'shape = "cone"\nradius = 0.7\nlength = 1.5\ntop_radius = 0.2\nposition = [1.6, 0.0, -1.0]\nmaterial = "wood"\ndensity = 0.7',
  'shape = "box"\nsize = [0.8, 0.8, 0.8]\nposition = [-1.6, -0.4, -0.9]\nmaterial = "rubber"\ndensity = 1.1',
  'shape = "mesh"\nfile = "cube.ply"\nunit = "cm"\nposition = [0.0, -1.5, 0.9]\ndensity = 1.0',
].map((part) => `[[part]]\n${part}\n`).join('') + '[motion]\nomega = [0.3, 1.0, 0.1]\nduration = 30.0\n';

const tests = {
  async 'there is a live WebGL 2 context, and a picture that is not of one colour'() {
    const { page, quiet } = await open(flip);
    const renderer = await page.evaluate(() => {
      const gl = document.createElement('canvas').getContext('webgl2');
      return gl && gl.getParameter(gl.VERSION);
    });
    assert.match(String(renderer), /WebGL 2/);
    const colours = await page.evaluate(async () => {
      const image = new Image();
      image.src = await globalThis.twrench.picture({ width: 320, height: 180, t: 0 });
      await image.decode();
      const canvas = Object.assign(document.createElement('canvas'), { width: 320, height: 180 });
      const context = canvas.getContext('2d');
      context.drawImage(image, 0, 0);
      return new Set(new Uint32Array(context.getImageData(0, 0, 320, 180).data.buffer)).size;
    });
    assert.ok(colours > 500, `${colours} colours`);
    quiet();
  },

  async 'every reference case is met, to 2e-15 * max(1, |omega| t)'() {
    const cases = JSON.parse(readFileSync(process.env.REFERENCE));
    const { page, quiet } = await open(flip);
    const number = (x) => Number(x);
    let samples = 0;
    for (const c of cases) {
      const moments = (c.inertia_values_g_cm2 ?? c.inertia).map(number);
      const found = await page.evaluate(
        ([a, b, d], omega, times) => {
          const motion = globalThis.twrench.core.motion([a, 0, 0, 0, b, 0, 0, 0, d], omega);
          return times.map((t) => motion.at(t));
        },
        moments, c.omega0, c.samples.map((s) => s.t),
      );
      c.samples.forEach((expected, i) => {
        const bound = 2e-15 * Math.max(1, Math.hypot(...c.omega0) * expected.t);
        assert.ok(distance(found[i].X, expected.X.flat().map(number)) <= bound, `${c.name} X(${expected.t})`);
        assert.ok(distance(found[i].omega, expected.omega.map(number)) <= bound, `${c.name} omega(${expected.t})`);
        ++samples;
      });
    }
    assert.ok(samples >= 33);
    quiet();
  },

  async 'each method computes what the program computes'() {
    const methods = twrench('methods').trim().split('\n').map((line) => line.split(/\s+/)[0]);
    const { page, quiet } = await open(flip);
    const known = await page.evaluate(() => globalThis.twrench.core.methods.map((m) => m.name));
    assert.deepEqual(known, methods);
    for (const method of known) {
      const control = ['--method', method, '--step', '0.02', '--tolerance', '1e-9'];
      const expected = simulated('dzhanibekov', ...control, '--times', '0,1,7.3,20');
      const found = await page.evaluate((name, times) => {
        const { core } = globalThis.twrench;
        const motion = core.motion([982.2713030224087, 0, 0, 0, 722.6710300807721, 0, 0, 0, 1578.650308428871], [1, 0.05, 0]);
        const { X } = motion.integrate(name, { step: 0.02, tolerance: 1e-9 }, times);
        const run = motion.run(name, { step: 0.02, tolerance: 1e-9 }).samples(times);
        return [[...X], [...run.X]];
      }, method, expected.map((s) => s.t));
      // Two C libraries and two kinds of registers round differently; step control and the motion amplify it.
      const bound = method === 'exact' ? 0 : 1e-11;
      for (const X of found) {
        const apart = distance(X, expected.flatMap((sample) => sample.X));
        assert.ok(apart <= bound, `${method} is ${apart} away`);
      }
    }
    quiet();
  },

  async 'a C++ exception is reported with its message, and the core keeps running'() {
    const { page, quiet } = await open(flip);
    const found = await page.evaluate(() => {
      const { core } = globalThis.twrench;
      const motion = core.motion([1, 0, 0, 0, 2, 0, 0, 0, 3], [0.1, 2, 0.1]);
      const run = motion.run('rk4', { step: 0.01, tolerance: 1e-9 });
      const before = [motion.at(1e9).X, run.at(3).X];
      const said = [];
      for (const wrong of [
        () => core.motion([-1, 0, 0, 0, 2, 0, 0, 0, 3], [1, 0, 0]),
        () => motion.at(NaN),
        () => motion.run('rk4', { step: 100, tolerance: 1 }).at(1),
        () => motion.run('rk4', { step: -1, tolerance: 1 }),
        () => motion.run('rk45', { step: 1, tolerance: 1 }),
        () => run.at(-1),
        () => run.at(1e9),
      ]) {
        try {
          wrong();
        } catch (error) {
          said.push(`${error.name} ${error.quantity}`);
        }
      }
      return { before, after: [motion.at(1e9).X, run.at(3).X], said };
    });
    assert.deepEqual(found.after, found.before);
    assert.deepEqual(found.said, [
      'CoreError inertia', 'CoreError times[0]', 'CoreError method rk4', 'CoreError step',
      'CoreError method', 'CoreError t', 'CoreError method rk4',
    ]);
    quiet();
  },

  async 'sample(t) is the motion shown, as the program computes it'() {
    for (const [words, bound] of [
      [['dzhanibekov'], 0],
      // Registers of a different width sum in a different order, and an error of eps grows with |omega| t.
      [['stable-y', '--omega', '0.2,1.5,0.3'], 1.6 * 2e-15],
    ]) {
      const { page, quiet } = await open(writePage('other.html', ...words));
      for (const expected of simulated(...words, '--method', 'exact', '--times', '0,0.31,12.5,60,1e5')) {
        const found = await page.evaluate((t) => globalThis.twrench.sample(t), expected.t);
        assert.equal(found.t, expected.t);
        const apart = distance([...found.X, ...found.omega], [...expected.X, ...expected.omega]);
        assert.ok(apart <= bound * Math.max(1, expected.t), `${words[0]} at ${found.t} s is ${apart} away`);
      }
      quiet();
    }
  },

  async 'a picture is that of the film, in each theme'() {
    const { page, quiet } = await open(flip);
    for (const theme of ['studio', 'paper', 'space']) {
      for (const frame of [125, 500]) await expectPictureOfFilm(page, 'dzhanibekov', frame, theme);
    }
    quiet();
  },

  async 'so is that of a body of all shapes, of several materials, with colours, of many parts'() {
    const scene = join(folder, 'shapes.toml');
    writeFileSync(join(folder, 'cube.ply'), coloredCube);
    writeFileSync(scene, sceneOfShapes);
    const { page, quiet } = await open(writePage('shapes.html', scene));
    await expectPictureOfFilm(page, scene, 125, 'studio');
    await expectPictureOfFilm(page, scene, 40, 'paper');
    quiet();
    const racket = await open(writePage('racket.html', 'tennis-racket'));
    await expectPictureOfFilm(racket.page, 'tennis-racket', 125, 'studio');
    racket.quiet();
  },

  async 'so is that of print and of rock'() {
    for (const [scene, frame] of [['book', 126], ['toutatis', 200]]) {
      const { page, quiet } = await open(writePage(`${scene}.html`, scene));
      await expectPictureOfFilm(page, scene, frame, 'space');
      quiet();
    }
  },

  async 'a box in place of a body with colours is not black'() {
    writeFileSync(join(folder, 'cube.ply'), coloredCube);
    const scene = join(folder, 'cube.toml');
    writeFileSync(scene, `[[part]]\nshape = "mesh"\nfile = "cube.ply"\nunit = "cm"\ndensity = 1.0\n`);
    const { page, quiet } = await open(writePage('cube.html', scene), { hash: '#moments=2,3,4&theme=paper' });
    const brightest = await page.evaluate(async () => {
      const image = new Image();
      image.src = await globalThis.twrench.picture({ width: 160, height: 90, t: 0, show: [] });
      await image.decode();
      const canvas = Object.assign(document.createElement('canvas'), { width: 160, height: 90 });
      const context = canvas.getContext('2d');
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(70, 35, 20, 20);
      return Math.max(...data.filter((_, i) => i % 4 === 0));
    });
    assert.ok(brightest > 60, `${brightest} of 255`);
    quiet();
  },

  async 'it is one small file that asks nothing of the network'() {
    const size = statSync(flip).size;
    assert.ok(size <= 600_000, `${size} bytes`);
    const text = readFileSync(flip, 'utf8');
    assert.doesNotMatch(text, /\b(src|href)=["']?(https?:)?\/\//);
    const { page, quiet } = await open(flip);
    await page.setOfflineMode(true);
    await page.evaluate(() => globalThis.twrench.sample(1e9));
    quiet();
  },

  async 'it runs in a sandbox, and under a policy that allows only what is inline'() {
    const policy =
      "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; style-src 'unsafe-inline'; img-src data: blob:";
    const server = createServer((request, response) => {
      if (request.url === '/frame') {
        response.setHeader('content-type', 'text/html');
        response.end('<!doctype html><link rel="icon" href="data:,"><iframe sandbox="allow-scripts" src="/flip" width="1200" height="700">');
      } else {
        response.setHeader('content-type', 'text/html; charset=utf-8');
        response.setHeader('content-security-policy', policy);
        response.end(readFileSync(flip));
      }
    });
    await new Promise((done) => server.listen(0, '127.0.0.1', done));
    try {
      const page = await browser.newPage();
      const trouble = watch(page, flip);
      const address = `http://127.0.0.1:${server.address().port}`;
      await page.goto(`${address}/frame`);
      const frame = page.frames()[1];
      await frame.waitForFunction(() => globalThis.twrench);
      await frame.evaluate(() => globalThis.twrench.ready);
      const found = await frame.evaluate(() => globalThis.twrench.sample(50));
      assert.ok(distance(found.X, simulated('--method', 'exact', '--times', '50')[0].X) <= 2e-14);
      assert.deepEqual(trouble.filter((line) => !line.startsWith(`request: ${address}/`)), []);
    } finally {
      server.close();
    }
  },

  async 'hostile titles and names are text'() {
    const scene = join(folder, 'hostile.toml');
    const hostile = `</script></title><img src=x onerror='globalThis.broken=1'><!-- twrench:scene -->&amp;<script>globalThis.broken=1</script>`;
    writeFileSync(scene, `title = ${JSON.stringify(hostile)}
[[part]]
name = ${JSON.stringify(hostile)}
shape = "box"
size = [1.0, 2.0, 3.0]
density = 1.0
[motion]
omega = [0.1, 2.0, 0.1]
`);
    const { page, quiet } = await open(writePage('hostile.html', scene));
    assert.equal(await page.title(), hostile);
    assert.equal(await page.evaluate(() => globalThis.broken), undefined);
    quiet();
  },

  async 'a report has the page at its top, formulas and figures, and prints without'() {
    const report = join(folder, 'report.html');
    twrench('report', '--duration', '30', '-o', report);
    const page = await browser.newPage();
    const trouble = watch(page, report);
    await page.goto(`file://${report}`);
    const viewer = page.frames()[1];
    await viewer.waitForFunction(() => globalThis.twrench);
    await viewer.evaluate(() => globalThis.twrench.ready);
    const { X } = await viewer.evaluate(() => globalThis.twrench.sample(20));
    assert.deepEqual(X, simulated('--method', 'exact', '--times', '20')[0].X);
    assert.equal((await page.$$('math')).length, 15);
    assert.equal((await page.$$('figure svg')).length, 4);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    for (const [width, height] of [[1000, 900], [1000, 1000], [1280, 900]]) {
      await page.setViewport({ width, height });
      const [below, aside] = await viewer.evaluate(() => [
        document.getElementById('transport').getBoundingClientRect().bottom - innerHeight,
        document.documentElement.scrollWidth - innerWidth,
      ]);
      assert.ok(below <= 0 && aside <= 0, `the frame cuts off ${below} and ${aside} pixels of the lab in ${width}x${height}`);
    }
    await page.setViewport({ width: 900, height: 600 });
    await page.emulateMediaType('print');
    assert.equal(await page.$eval('.viewer iframe', (frame) => getComputedStyle(frame).display), 'none');
    assert.notEqual(await page.$eval('.viewer img', (image) => getComputedStyle(image).display), 'none');
    // Elements that must not be cut must fit a page: the smaller of A4 and Letter, without margins, is 912/96 inch high.
    await page.setViewport({ width: 670, height: 900 });
    for (const box of await page.$$eval('figure', (all) => all.map((figure) => figure.getBoundingClientRect().height))) {
      assert.ok(box <= 912, `${box} high`);
    }
    for (const format of ['A4', 'Letter']) {
      const pdf = Buffer.from(await page.pdf({ format })).toString('latin1');
      const pages = pdf.match(/\/Type\s*\/Page\b/g).length;
      assert.ok(pages >= 10 && pages <= 22, `${pages} pages of ${format}`);
    }
    assert.deepEqual(trouble, []);
  },

  async 'without scripts it says what it would do, with a picture'() {
    const page = await browser.newPage();
    await page.setJavaScriptEnabled(false);
    const trouble = watch(page, flip);
    await page.goto(`file://${flip}`);
    const seen = await page.$eval('body', (body) => body.innerText);
    assert.match(seen, /needs scripts/);
    const [width, height] = await page.$eval('img', (image) => [image.naturalWidth, image.naturalHeight]);
    assert.deepEqual([width, height], [800, 450]);
    assert.deepEqual(trouble, []);
  },
};

await run(tests, [
  'it is one small file that asks nothing of the network',
  'a report has the page at its top, formulas and figures, and prints without',
  'without scripts it says what it would do, with a picture',
]);
