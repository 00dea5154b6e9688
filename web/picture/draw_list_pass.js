// Renders draw lists as premultiplied colour: src/draw/draw_list_pass.cpp.
import draw_list_frag from '../../shaders/draw_list.frag';
import draw_list_vert from '../../shaders/draw_list.vert';
import { Program, VertexArray } from './program.js';

/** @import { Contents, DrawList } from '../core/types' */
/**
 * How triangles are drawn: the faces; whether they write depth; whether only hidden parts are drawn; the
 * offset of z in clip space.
 * @typedef {{faces?: "all" | "near" | "far", writesDepth?: boolean, hidden?: boolean, opacity?: number, clipZ?: number}} Mode
 */

const faintest = 0.25,
  steps = 5,
  deepest = 0.01; // of what the body hides; the last, of the pane's height

export class DrawListPass {
  /** @param {WebGL2RenderingContext} gl */
  constructor(gl) {
    this.gl = gl;
    this.program = new Program(gl, [draw_list_vert], [draw_list_frag]);
    this.array = new VertexArray(gl, [4, 4, 3]);
  }

  /** Draws all items of a view without a body. @param {Contents} contents */
  draw(contents) {
    this.drawOpaque(contents);
    this.drawTranslucent(contents);
  }

  /** Draws the hidden parts of items faintly over the body, which must be the only thing drawn so far. @param {Contents} contents */
  drawGhosts({ opaque: list, clipZNearer }) {
    this.#draw(list, list.ghosts.faces, [{ faces: 'near', hidden: true, opacity: faintest }]);
    this.#draw(list, list.ghosts.edgeQuads, [{ hidden: true, opacity: faintest }]);
    // Each step is moved towards the eye by less, so that the opacities add up towards the front.
    const shown = (/** @type {number} */ step) => faintest + ((1 - faintest) * step) / (steps + 1);
    /** @type {Mode[]} */
    const fade = [];
    for (let step = 1; step <= steps; ++step) {
      fade.push({
        faces: 'near',
        opacity: (shown(step) - shown(step - 1)) / (1 - shown(step - 1)),
        clipZ: clipZNearer * deepest * ((steps + 1 - step) / steps),
      });
    }
    this.#draw(list, list.ghosts.faces, fade);
  }

  /** @param {Contents} contents */
  drawOpaque({ opaque: list }) {
    this.#draw(list, list.items.faces, [{ writesDepth: true }]);
    this.#draw(list, list.outlines.faces, [{ faces: 'far' }]);
    this.#draw(list, list.outlines.edgeQuads, [{}]);
    this.#draw(list, list.items.edgeQuads, [{}]);
  }

  /** @param {Contents} contents */
  drawTranslucent({ translucent: list }) {
    this.#draw(list, list.items.faces, [{}]);
  }

  /** @param {DrawList} list @param {Uint32Array} indices @param {Mode[]} modes */
  #draw(list, indices, modes) {
    if (indices.length === 0) return;
    const { gl, program } = this;
    this.array.fill(list.vertices, indices, gl.STREAM_DRAW);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    for (const { faces = 'all', writesDepth = false, hidden = false, opacity = 1, clipZ = 0 } of modes) {
      program.use({ opacity, clip_z: clipZ });
      gl.depthFunc(hidden ? gl.GREATER : gl.LESS);
      gl.depthMask(writesDepth);
      if (faces === 'all') gl.disable(gl.CULL_FACE);
      else gl.enable(gl.CULL_FACE);
      gl.frontFace(faces === 'far' ? gl.CW : gl.CCW);
      gl.drawElements(gl.TRIANGLES, indices.length, gl.UNSIGNED_INT, 0);
    }
    gl.depthFunc(gl.LESS);
    gl.depthMask(true);
    gl.frontFace(gl.CCW);
    gl.disable(gl.CULL_FACE);
    gl.disable(gl.BLEND);
  }
}
