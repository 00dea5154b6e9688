// Compares the contents of the views in core.wasm with those of the program's build for random states in
// each theme and view: the triangles are the same, and the numbers agree to six digits. Needs no browser:
// CORE and RANDOM_VIEWS name core.wasm and the program, WEB the folder of the scripts.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

const states = 50,
  tolerance = 1e-6;

const script = (name) => import(pathToFileURL(`${process.env.WEB}/core/${name}`).href);
const { Core } = await script('core.js'),
  { Pictures } = await script('pictures.js');
const core = await Core.load(readFileSync(process.env.CORE)),
  pictures = new Pictures(core);

const written = execFileSync(process.env.RANDOM_VIEWS, [String(states)], { maxBuffer: 1 << 30 });

/** Compares numbers relative to the largest in each row of `width`, such as the position of a vertex. */
function expectClose(found, expected, width, what) {
  for (let i = 0; i < expected.length; i += width) {
    let scale = 1e-3;
    for (let k = i; k < i + width; ++k) scale = Math.max(scale, Math.abs(expected[k]));
    for (let k = i; k < i + width; ++k) {
      const error = Math.abs(found[k] - expected[k]) / scale;
      assert.ok(error <= tolerance, `${what}: ${found[k]} in place of ${expected[k]} at ${k}`);
    }
  }
}

/** The arrays of a draw list, in the order in which the program writes them. */
const arraysOf = ({ opaque, translucent }) =>
  [opaque, translucent].flatMap(({ vertices, items, outlines, ghosts }) => [
    vertices,
    ...[items, outlines, ghosts].flatMap(({ faces, edgeQuads }) => [faces, edgeQuads]),
  ]);

const names = ({ themes, frames, features }, { theme, frame, show, stress, ...rest }) => ({
  ...rest,
  theme: themes[theme],
  frame: frames[frame],
  show: features.filter((_, i) => (show >> i) & 1),
  stress: features.filter((_, i) => (stress >> i) & 1),
});

let at = 0,
  count = 0,
  bodies = 0,
  rigid = 0,
  vertices = 0;
while (at < written.length) {
  const end = written.indexOf('\n', at);
  const state = JSON.parse(written.subarray(at, end).toString());
  at = end + 1;
  const motion = core.motion(state.inertia, state.omega, { energyLossTime: Infinity, ...state.interior });
  const { view, from, instants } = state,
    settings = names(pictures.names, state.settings);
  const found =
    view === 'body'
      ? pictures.body(motion, settings, from, instants[0])
      : pictures.inset(view, motion, settings, from, instants);
  const what = `state ${count++}, ${view}`;
  if (view === 'body') ++bodies;
  if (view === 'poinsot') ++rigid; // the ellipsoid of no other body is shown
  expectClose([found.camera.distance], [state.distance], 1, what);
  expectClose(found.camera.attitude, state.attitude, 9, what);
  expectClose(found.camera.projection, state.projection, 16, what);
  assert.deepEqual(found.labels.map(({ text, color }) => [text, color]), state.labels.map(({ text, color }) => [text, color]), what);
  found.labels.forEach(({ anchor, away }, i) => {
    expectClose(anchor, state.labels[i].anchor, 2, what);
    expectClose(away, state.labels[i].away, 2, what);
  });
  if (view === 'body') {
    const paused = { ...settings, interval: settings.interval > 0 ? 0 : 0.01 };
    const camera = pictures.body(motion, paused, from, instants[0]).camera;
    assert.deepEqual(camera, found.camera, `${what}: the camera moves when the motion stops`);
    pictures.body(motion, settings, from, instants[0]);
  }
  arraysOf(found).forEach((array, i) => {
    const bytes = Uint8Array.from(written.subarray(at, at + state.sizes[i]));
    at += state.sizes[i];
    const expected = array instanceof Float32Array ? new Float32Array(bytes.buffer) : new Uint32Array(bytes.buffer);
    assert.equal(array.length, expected.length, `${what}, array ${i}`);
    if (array instanceof Float32Array) {
      vertices += array.length / 11;
      for (let k = 0; k < array.length; k += 11) {
        expectClose(array.subarray(k, k + 4), expected.subarray(k, k + 4), 4, `${what}, place of vertex ${k / 11}`);
        expectClose(array.subarray(k + 4, k + 8), expected.subarray(k + 4, k + 8), 4, `${what}, colour of vertex ${k / 11}`);
        expectClose(array.subarray(k + 8, k + 11), expected.subarray(k + 8, k + 11), 3, `${what}, edge of vertex ${k / 11}`);
      }
    } else {
      assert.ok(Buffer.from(array.buffer, array.byteOffset, array.byteLength).equals(Buffer.from(bytes)), `${what}, indices ${i}`);
    }
  });
  motion.release();
}
assert.equal(bodies, pictures.names.themes.length * states);
assert.ok(rigid > 0.2 * bodies && rigid < 0.8 * bodies, `${rigid} of ${bodies} bodies are rigid`);
assert.equal(count, pictures.names.insets.length * bodies + rigid);
console.log(`ok      the views of ${count} random states are those of the program: ${vertices} vertices`);
