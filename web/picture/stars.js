// The stars of space. Where the film's own camera looks, they are those of its still background
// (src/picture/look/background.cpp); around that, others as bright are spread evenly.
import stars_frag from './stars.frag';
import stars_vert from './stars.vert';
import { normalized, times, transposed } from '../math/linear.js';
import { mersenneTwister } from '../math/mersenne_twister.js';
import { Program, setAttributes } from './program.js';

/** @typedef {import("../math/camera.js").Camera} Camera */

/** @param {Camera} home The film's camera at t = 0. @param {number} count In its picture. */
function starsAround(home, count) {
  const random = mersenneTwister(1);
  const p = home.projection,
    spaceFromCamera = transposed(home.attitude);
  const stars = [];
  for (let i = 0; i < count; ++i) {
    const x = 2 * random() - 1,
      y = 1 - 2 * random();
    const brightness = random() ** 5,
      tint = 0.94 + 0.06 * random();
    const direction = normalized(times(spaceFromCamera, [(x + p[2]) / p[0], (y + p[6]) / p[5], -1]));
    stars.push(...direction, brightness, tint);
  }
  // As many to the solid angle as there are in the picture.
  const all = Math.min(Math.round(count * Math.PI * p[0] * p[5]), 6000);
  for (let i = 0; i < all; ++i) {
    const height = 1 - (2 * (i + random())) / all,
      across = Math.sqrt(Math.max(0, 1 - height * height));
    const angle = 2 * Math.PI * random();
    const brightness = random() ** 5,
      tint = 0.94 + 0.06 * random();
    const direction = [across * Math.cos(angle), height, across * Math.sin(angle)];
    const seen = times(home.attitude, direction);
    const inPicture =
      seen[2] < 0 &&
      Math.abs((p[0] * seen[0]) / -seen[2] - p[2]) < 1 &&
      Math.abs((p[5] * seen[1]) / -seen[2] - p[6]) < 1;
    if (!inPicture) stars.push(...direction, brightness, tint);
  }
  return Float32Array.from(stars);
}

export class Stars {
  /** @param {WebGL2RenderingContext} gl */
  constructor(gl) {
    this.gl = gl;
    this.program = new Program(gl, [stars_vert], [stars_frag]);
    this.array = gl.createVertexArray();
    this.buffer = gl.createBuffer();
    this.count = 0;
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    setAttributes(gl, [3, 2]);
    gl.bindVertexArray(null);
  }

  /** @param {Camera} home @param {number} count */
  place(home, count) {
    const { gl } = this;
    const stars = starsAround(home, count);
    this.count = stars.length / 5;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, stars, gl.STATIC_DRAW);
  }

  /** @param {Camera} camera @param {number} height of the picture in pixels */
  draw(camera, height) {
    if (this.count === 0) return;
    const { gl, program } = this;
    const p = camera.projection;
    program.use();
    program.setMatrix('camera_from_space', camera.attitude);
    program.set('lens', [p[0], p[5], p[2], p[6]]);
    program.set('height', height);
    gl.bindVertexArray(this.array);
    gl.disable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE);
    gl.drawArrays(gl.POINTS, 0, this.count);
    gl.disable(gl.BLEND);
    gl.bindVertexArray(null);
  }
}
