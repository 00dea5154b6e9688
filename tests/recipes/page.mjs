// page.mjs PAGE: the examples of the recipes in a page of examples.toml. Its own core computes with the
// method and the shape, and draws the overlay; its data and words have the theme. Needs no browser.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { gunzipSync } from 'node:zlib';
import { Core } from '../../web/core/core.js';
import { Pictures } from '../../web/core/pictures.js';

const html = readFileSync(process.argv[2], 'utf8');
const script = (id) => html.match(new RegExp(`<script [^>]*id="${id}">([^<]*)</script>`))[1];
const data = JSON.parse(script('scene'));
const core = await Core.load(gunzipSync(Buffer.from(script('core'), 'base64')));
const pictures = new Pictures(core);

assert.equal(data.scene.look.theme, 'night');
assert.ok('night' in data.themes && pictures.names.themes.includes('night'));
for (const name of ['night', 'natt', 'axis of rotation', 'rotasjonsakse']) {
  assert.ok(html.includes(name), `${name} is not among the words`);
}

assert.equal(data.scene.part[0].shape, 'hemisphere');
const { inertia } = core.massProperties([
  { shape: 'hemisphere', radius: 2, density: 3, position: [0, 0, 0], body_from_part: [1, 0, 0, 0, 1, 0, 0, 0, 1] },
]);
const mass = 16 * Math.PI;
[83 / 320, 83 / 320, 2 / 5].forEach((share, i) => {
  assert.ok(Math.abs(inertia[4 * i] / (4 * mass * share) - 1) < 1e-12);
});

const motion = core.motion(data.inertia, data.scene.motion.omega);
const error = (step) => {
  const { X } = motion.integrate('ralston3', { step, tolerance: 1e-10 }, [10]);
  return Math.hypot(...motion.at(10).X.map((x, i) => x - X[i]));
};
assert.ok(Math.abs(Math.log2(error(0.02) / error(0.01)) - 3) < 0.2);

const settings = {
  width: 640, height: 360, thinnest: 1, theme: 'night', frame: 'space', azimuth: 0, elevation: 0.2, distance: 1,
  fieldOfView: 0.5, interval: 0.01, radius: 3, trailLength: 2, trailX: 1, trailY: 0, trailZ: 0, curveBegin: 0, curveEnd: 10,
  stress: [],
};
const { X, omega } = motion.at(0);
const vertices = (show) => {
  const contents = pictures.body(motion, { ...settings, show }, { azimuth: 0, elevation: 0.2, zoom: 1 }, { t: [0], X, omega });
  return contents.translucent.vertices.length;
};
assert.ok(vertices(['spin']) > vertices([]), 'the overlay draws nothing');

assert.ok(html.includes('id="rates"') && pictures.names.insets.includes('rates'));
const home = pictures.home('rates', motion, { ...settings, show: [] });
const inset = pictures.inset('rates', motion, { ...settings, show: [] }, { ...home, zoom: 1 }, [{ t: [0], X, omega }]);
assert.ok(inset.opaque.vertices.length > 0, 'the view draws nothing');
