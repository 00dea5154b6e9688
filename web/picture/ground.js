// Draws what is behind the body: the theme's gradient and the floor with light, shadow and
// reflection.
import fullscreen_vert from './fullscreen.vert';
import ground_frag from './ground.frag';
import soften_frag from './soften.frag';
import { clamp } from '../math/linear.js';
import { Program } from './program.js';
import { SoftTarget } from './soft_target.js';

/** @typedef {import("../core/pictures.js").Camera} Camera */
/**
 * A theme's ground, as page_json writes it; colours are sRGB from 0 to 255.
 * @typedef {object} GroundStyle
 * @property {{above: number[], below: number[], vignette: number, stars: number}} backdrop
 * @property {{light: number[], shadow: number, reflection: number, clouds: number} | null} floor
 */

const mostColumns = 2048, // of a texture: every WebGL 2 has as many
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
   * @param {import("./body_pass.js").BodyPass} body @param {Camera} camera @param {number[]} X
   * @param {number} aspect
   */
  reflect(body, camera, X, aspect) {
    const { gl } = this;
    const width = clamp(Math.round(gridRows * aspect), 1, mostColumns);
    this.sharp.begin(width, gridRows);
    body.drawMirrored(camera, X, { width, height: gridRows });
    this.soft.begin(width, gridRows);
    this.soften.use();
    this.soften.setTexture('sharp', 0);
    gl.bindTexture(gl.TEXTURE_2D, this.sharp.texture);
    this.#drawTriangle();
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  /**
   * @param {GroundStyle} style @param {Camera} camera @param {number[]} X space_from_body
   * @param {import("./body_pass.js").BodyPass} body
   * @param {{width: number, height: number, inner: number[], floor: boolean, turned: boolean}} pane
   */
  draw(style, camera, X, body, { width, height, inner, floor, turned }) {
    const { gl, program } = this;
    program.use();
    program.set('above', style.backdrop.above);
    program.set('below', style.backdrop.below);
    program.set('vignette', style.backdrop.vignette);
    program.set('picture', [width, height]);
    program.set('inner', inner);
    const share = floor && style.floor ? clamp(camera.attitude[7] / 0.03, 0, 1) : 0;
    program.set('floor_share', share);
    if (share > 0 && style.floor) {
      program.set('floor_light', style.floor.light);
      program.set('floor_style', [
        style.floor.shadow,
        style.floor.reflection,
        turned ? style.floor.clouds : 0,
      ]);
      this.#setFloor(body.own.floor(camera, X));
    }
    gl.bindTexture(gl.TEXTURE_2D, this.soft.texture);
    this.#drawTriangle();
  }

  /** @param {{floor_from_place: Float32Array, right_and_height: Float32Array, balls: Float32Array}} uniforms */
  #setFloor(uniforms) {
    const { gl, program } = this;
    const { length } = uniforms.balls;
    program.setColumns('floor_from_place', uniforms.floor_from_place);
    program.set('right_and_height', uniforms.right_and_height);
    program.set('balls', length > 4 ? uniforms.balls : [...uniforms.balls, 0, -1, 0, 0, 0, -1, 0, 0].slice(0, 8));
    gl.uniform1i(gl.getUniformLocation(program.program, 'ball_count'), length / 4);
    program.setTexture('reflection', 0);
  }

  #drawTriangle() {
    const { gl } = this;
    gl.bindVertexArray(this.array);
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.bindVertexArray(null);
  }
}
