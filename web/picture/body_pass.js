// Draws the body as src/draw/body_pass.cpp does, but without edge quads: WebGL has several samples per
// pixel.
import body_frag from '../../shaders/body.frag';
import body_vert from '../../shaders/body.vert';
import brush from '../../shaders/brush.glsl';
import colored_frag from '../../shaders/colored.glsl';
import colored_vert from '../../shaders/colored.vert';
import marked_frag from '../../shaders/marked.glsl';
import marked_vert from '../../shaders/marked.vert';
import matte from '../../shaders/matte.glsl';
import metal from '../../shaders/metal.glsl';
import occluders_frag from '../../shaders/occluders.glsl';
import occluders_vert from '../../shaders/occluders.vert';
import plain_frag from '../../shaders/plain.glsl';
import plain_vert from '../../shaders/plain.vert';
import regolith from '../../shaders/regolith.glsl';
import studio from '../../shaders/studio.glsl';
import tone from '../../shaders/tone.glsl';
import unmarked_frag from '../../shaders/unmarked.glsl';
import unmarked_vert from '../../shaders/unmarked.vert';
import unoccluded_frag from '../../shaders/unoccluded.glsl';
import unoccluded_vert from '../../shaders/unoccluded.vert';
import { CoreSurface } from '../core/surface.js';
import { Program, VertexArray } from './program.js';

/** @import { Core } from '../core/core.js' */
/** @import { Camera } from '../core/types' */
/** @import { Uniforms } from '../core/surface.js' */
/** @import { Surface } from '../app/types' */
/**
 * A material: its constants as GLSL (see src/page/theme_json.h), whether vertices have colours, and the
 * colour of its reflection.
 * @typedef {{constants: string, metal: boolean, rock: boolean, colored: boolean, tint: number[]}} Material
 */
/** Size of the picture in pixels. @typedef {{width: number, height: number}} Size */

// Attributes that only edge quads need, and the colours of vertices.
const shiftLocation = 2,
  colorLocation = 3,
  fadeLocation = 4;

/** Returns the shader with the diffuse term. @param {Material} material */
function scatteringOf(material) {
  if (material.rock) return regolith;
  return material.metal ? metal : matte;
}

/**
 * @param {WebGL2RenderingContext} gl @param {Surface} surface
 * @param {Material} material @param {boolean} ofOneMaterial
 */
function programOf(gl, surface, material, ofOneMaterial) {
  const constants = `${material.constants}const int occluder_count = ${surface.occluder_count};
const bool is_of_one_material = ${ofOneMaterial};
`;
  const alone = surface.occluder_count === 0,
    colored = material.colored && surface.colors !== null; // false for the box of given moments
  return new Program(
    gl,
    [
      constants,
      alone ? unoccluded_vert : occluders_vert,
      colored ? colored_vert : plain_vert,
      surface.mark ? marked_vert : unmarked_vert,
      body_vert,
    ],
    [
      constants,
      studio,
      colored ? colored_frag : plain_frag,
      alone ? unoccluded_frag : occluders_frag,
      tone,
      brush,
      surface.mark ? marked_frag : unmarked_frag,
      scatteringOf(material),
      body_frag,
    ],
  );
}

export class BodyPass {
  /**
   * @param {WebGL2RenderingContext} gl @param {Core} core @param {Surface} surface
   * @param {Material[]} materials of a theme; parts refer to them by index
   */
  constructor(gl, core, surface, materials) {
    this.gl = gl;
    this.surface = surface;
    const tints = surface.parts.map(({ material, tint }) => materials[material].tint.map((x, i) => x * (tint?.[i] ?? 1)));
    this.own = new CoreSurface(core, surface, tints);
    const ofOneMaterial = materials.length === 1 && !materials[0].colored;
    this.programs = materials.map((material) => programOf(gl, surface, material, ofOneMaterial));
    this.array = new VertexArray(gl, [3, 3]);
    this.array.fill(surface.vertices, surface.indices, gl.STATIC_DRAW);
    for (const location of [shiftLocation, fadeLocation]) {
      gl.disableVertexAttribArray(location);
      gl.vertexAttrib4f(location, 0, 0, 0, 0);
    }
    this.colors = gl.createBuffer();
    if (surface.colors) {
      gl.bindBuffer(gl.ARRAY_BUFFER, this.colors);
      gl.bufferData(gl.ARRAY_BUFFER, surface.colors, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(colorLocation);
      gl.vertexAttribPointer(colorLocation, 3, gl.UNSIGNED_SHORT, true, 6, 0);
    }
  }

  /**
   * Draws the body in the pose X, space_from_body, to the bound framebuffer. A part that touches parts
   * drawn before is moved one pixel nearer than these, and fades where it enters them.
   * @param {Camera} camera @param {number[]} X @param {Size} size
   */
  draw(camera, X, size) {
    this.gl.frontFace(this.gl.CCW);
    this.#drawParts(this.own.uniforms(camera, X, false), size);
  }

  /**
   * Draws the body as a ghost over the picture: only its near side, in front of everything.
   * @param {Camera} camera @param {number[]} X @param {Size} size @param {number} opacity 0 to 1
   */
  drawGhost(camera, X, size, opacity) {
    const { gl } = this;
    gl.clear(gl.DEPTH_BUFFER_BIT);
    gl.colorMask(false, false, false, false);
    this.draw(camera, X, size);
    gl.colorMask(true, true, true, true);
    gl.depthFunc(gl.LEQUAL);
    gl.blendColor(0, 0, 0, opacity);
    this.#drawParts(this.own.uniforms(camera, X, false), size, [
      gl.CONSTANT_ALPHA,
      gl.ONE_MINUS_CONSTANT_ALPHA,
    ]);
    gl.depthFunc(gl.LESS);
  }

  /**
   * Draws the body's image in the floor.
   * @param {Camera} camera @param {number[]} X @param {Size} size
   */
  drawMirrored(camera, X, size) {
    this.gl.frontFace(this.gl.CW); // a mirror reverses the winding
    this.#drawParts(this.own.uniforms(camera, X, true), size);
    this.gl.frontFace(this.gl.CCW);
  }

  /**
   * @param {{body: Uniforms, parts: Uniforms[]}} uniforms @param {Size} size
   * @param {[number, number]} [blending]
   */
  #drawParts({ body, parts }, { width, height }, blending = [this.gl.ONE, this.gl.ONE_MINUS_SRC_ALPHA]) {
    const { gl } = this;
    const ofAll = { ...body, picture: [width / 2, height / 2, 0.5], mark_from_body: this.surface.mark ?? [] };
    for (const program of this.programs) program.use(ofAll);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.CULL_FACE);
    gl.enable(gl.BLEND);
    gl.blendFunc(...blending);
    this.array.bind();
    let begin = 0;
    const drawTo = (/** @type {number} */ end) => {
      if (end > begin) gl.drawElements(gl.TRIANGLES, end - begin, gl.UNSIGNED_INT, 4 * begin);
      begin = end;
    };
    this.surface.parts.forEach(({ material, side_begin, end }, i) => {
      const program = this.programs[material];
      program.use({ ...parts[i], side_axis: [0, 0, 0] });
      drawTo(side_begin);
      program.use({ side_axis: parts[i].side_axis });
      drawTo(end);
    });
    gl.disable(gl.BLEND);
    gl.disable(gl.CULL_FACE);
  }

  free() {
    this.array.free();
    this.gl.deleteBuffer(this.colors);
    for (const { program } of this.programs) this.gl.deleteProgram(program);
    this.own.release();
  }
}
