// The stars of space.
import stars_frag from './stars.frag';
import stars_vert from './stars.vert';
import { Program, VertexArray } from './program.js';

/** @import { Camera } from '../core/types' */

export class Stars {
  /** @param {WebGL2RenderingContext} gl */
  constructor(gl) {
    this.gl = gl;
    this.program = new Program(gl, [stars_vert], [stars_frag]);
    this.array = new VertexArray(gl, [3, 2]);
    this.count = 0;
  }

  /** @param {Float32Array} stars Direction, brightness and tint of each. */
  place(stars) {
    this.count = stars.length / 5;
    this.array.fill(stars, new Uint32Array(), this.gl.STATIC_DRAW);
  }

  /** @param {Camera} camera @param {number} height of the picture in pixels */
  draw({ attitude, projection: p }, height) {
    if (this.count === 0) return;
    const { gl } = this;
    this.program.use({ camera_rows: attitude, lens: [p[0], p[5], p[2], p[6]], height });
    this.array.bind();
    gl.disable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE);
    gl.drawArrays(gl.POINTS, 0, this.count);
    gl.disable(gl.BLEND);
  }
}
