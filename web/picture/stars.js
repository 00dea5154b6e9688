// The stars of space.
import stars_frag from './stars.frag';
import stars_vert from './stars.vert';
import { Program, setAttributes } from './program.js';

/** @typedef {import("../core/pictures.js").Camera} Camera */

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

  /** @param {Float32Array} stars Direction, brightness and tint of each. */
  place(stars) {
    const { gl } = this;
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
    program.setRows('camera_from_space', camera.attitude);
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
