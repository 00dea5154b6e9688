// Draws the background of the body: the theme's gradient and the floor with light, shadow and
// reflection.
import fullscreen_vert from './fullscreen.vert';
import ground_frag from './ground.frag';
import soften_frag from './soften.frag';
import { clamp } from '../math/linear.js';
import { Program } from './program.js';
import { SoftTarget } from './soft_target.js';

/** @import { Camera } from '../core/types' */
/** @import { BodyPass } from './body_pass.js' */
/**
 * A theme's ground, as page_json writes it; colours are sRGB from 0 to 255.
 * @typedef {object} GroundStyle
 * @property {{above: number[], below: number[], vignette: number, stars: number}} backdrop
 * @property {{light: number[], shadow: number, reflection: number, clouds: number} | null} floor
 */

const mostColumns = 2048, // of a texture: every WebGL 2 implementation supports as many
  gridRows = 180;

export class Ground {
  /** @param {WebGL2RenderingContext} gl */
  constructor(gl) {
    this.gl = gl;
    this.program = new Program(gl, [fullscreen_vert], [ground_frag]);
    this.soften = new Program(gl, [fullscreen_vert], [soften_frag]);
    this.sharp = new SoftTarget(gl, true);
    this.soft = new SoftTarget(gl, false);
    this.array = gl.createVertexArray();
  }

  /**
   * Draws the body's reflection for the next draw().
   * @param {BodyPass} body @param {Camera} camera @param {number[]} X @param {number} aspect
   */
  reflect(body, camera, X, aspect) {
    const { gl } = this;
    const width = clamp(Math.round(gridRows * aspect), 1, mostColumns);
    this.sharp.begin(width, gridRows);
    body.drawMirrored(camera, X, { width, height: gridRows });
    this.soft.begin(width, gridRows);
    this.soften.use({});
    gl.bindTexture(gl.TEXTURE_2D, this.sharp.texture);
    this.#drawTriangle();
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  /**
   * @param {GroundStyle} style @param {Camera} camera @param {number[]} X space_from_body
   * @param {BodyPass} body
   * @param {{width: number, height: number, inner: number[], floor: boolean, turned: boolean}} pane
   */
  draw({ backdrop, floor: style }, camera, X, body, { width, height, inner, floor, turned }) {
    const { gl, program } = this;
    const share = floor && style ? clamp(camera.attitude[7] / 0.03, 0, 1) : 0;
    program.use({ ...backdrop, picture: [width, height], inner, floor_share: share });
    if (share > 0 && style) {
      const uniforms = body.own.floor(camera, X);
      program.use({
        ...uniforms,
        ball_count: uniforms.balls.length / 4,
        floor_light: style.light,
        floor_style: [style.shadow, style.reflection, turned ? style.clouds : 0],
      });
    }
    gl.bindTexture(gl.TEXTURE_2D, this.soft.texture);
    this.#drawTriangle();
  }

  #drawTriangle() {
    const { gl } = this;
    gl.bindVertexArray(this.array);
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}
