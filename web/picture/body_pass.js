// Draws the body in stage coordinates: the camera's axes, with the body's centre at the origin and its
// bounding radius scaled to 1. As src/draw/body_pass.cpp, but for a framebuffer with several
// samples a pixel, so that edges need no quads of their own.
import body_frag from '../../shaders/body.frag';
import body_vert from '../../shaders/body.vert';
import brush from '../../shaders/brush.glsl';
import colored_frag from '../../shaders/colored.glsl';
import colored_vert from '../../shaders/colored.vert';
import marked from '../../shaders/marked.glsl';
import matte from '../../shaders/matte.glsl';
import metal from '../../shaders/metal.glsl';
import occluders_frag from '../../shaders/occluders.glsl';
import occluders_vert from '../../shaders/occluders.vert';
import plain_frag from '../../shaders/plain.glsl';
import plain_vert from '../../shaders/plain.vert';
import studio from '../../shaders/studio.glsl';
import tone from '../../shaders/tone.glsl';
import unmarked from '../../shaders/unmarked.glsl';
import unoccluded_frag from '../../shaders/unoccluded.glsl';
import unoccluded_vert from '../../shaders/unoccluded.vert';
import { add, cofactors, product, scale, times } from '../math/linear.js';
import { Program, setAttributes } from './program.js';

/** @typedef {import("./surface.js").Surface} Surface */
/**
 * As GLSL, see src/page/theme_json.h; whether vertices have colours, and the colour of what it reflects.
 * @typedef {{constants: string, metal: boolean, colored: boolean, tint: number[]}} Material
 */
/** @typedef {import("../math/camera.js").Camera} Camera */
/** Of the picture in pixels. @typedef {{width: number, height: number}} Size */

// Attributes that only edge quads need, and the colours of vertices.
const shiftLocation = 2,
  colorLocation = 3,
  fadeLocation = 4;

/**
 * @param {WebGL2RenderingContext} gl @param {Surface} surface
 * @param {Material} material @param {boolean} ofOneMaterial
 */
function programOf(gl, surface, material, ofOneMaterial) {
  const count = Math.max(...surface.parts.map((part) => part.occluders.length));
  const constants = `${material.constants}const int occluder_count = ${count};
const bool is_of_one_material = ${ofOneMaterial};
`;
  const alone = count === 0,
    colored = material.colored && surface.colors !== null; // not the box of given moments
  return new Program(
    gl,
    [
      constants,
      alone ? unoccluded_vert : occluders_vert,
      colored ? colored_vert : plain_vert,
      body_vert,
    ],
    [
      constants,
      studio,
      colored ? colored_frag : plain_frag,
      alone ? unoccluded_frag : occluders_frag,
      tone,
      brush,
      surface.marked ? marked : unmarked,
      material.metal ? metal : matte,
      body_frag,
    ],
  );
}

export class BodyPass {
  /**
   * @param {WebGL2RenderingContext} gl @param {Surface} surface
   * @param {Material[]} materials of a theme, to which parts refer by their index
   */
  constructor(gl, surface, materials) {
    this.gl = gl;
    this.surface = surface;
    this.materials = materials;
    this.ofOneMaterial = materials.length === 1 && !materials[0].colored;
    this.programs = materials.map((material) => programOf(gl, surface, material, this.ofOneMaterial));
    this.array = gl.createVertexArray();
    this.vertices = gl.createBuffer();
    this.indices = gl.createBuffer();
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.vertices);
    gl.bufferData(gl.ARRAY_BUFFER, surface.vertices, gl.STATIC_DRAW);
    setAttributes(gl, [3, 3]);
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
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.indices);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, surface.indices, gl.STATIC_DRAW);
    gl.bindVertexArray(null);
  }

  /**
   * Draws the body in the pose X, space_from_body, to the bound framebuffer. Parts that touch parts
   * drawn before are lifted over them by a pixel and fade where they enter them.
   * @param {Camera} camera @param {number[]} X @param {Size} size
   */
  draw(camera, X, size) {
    this.#begin(camera, X, 0, size);
    this.gl.frontFace(this.gl.CCW);
    this.#drawParts(camera, X, true);
  }

  /**
   * Draws the body as a ghost over what is there: its near side only, in front of everything.
   * @param {Camera} camera @param {number[]} X @param {Size} size @param {number} opacity 0 to 1
   */
  drawGhost(camera, X, size, opacity) {
    const { gl } = this;
    gl.clear(gl.DEPTH_BUFFER_BIT);
    gl.colorMask(false, false, false, false);
    this.draw(camera, X, size);
    gl.colorMask(true, true, true, true);
    gl.depthFunc(gl.LEQUAL);
    this.#begin(camera, X, 0, size);
    gl.blendColor(0, 0, 0, opacity);
    gl.blendFunc(gl.CONSTANT_ALPHA, gl.ONE_MINUS_CONSTANT_ALPHA);
    this.#drawParts(camera, X, true);
    gl.depthFunc(gl.LESS);
  }

  /**
   * Draws the body's image in a horizontal mirror.
   * @param {Camera} camera @param {number[]} X @param {number} height of the mirror, y in space, cm
   * @param {Size} size
   */
  drawMirrored(camera, X, height, size) {
    this.#begin(camera, X, height, size);
    this.gl.frontFace(this.gl.CW); // a mirror reverses the winding
    this.#drawParts(camera, X, false);
    this.gl.frontFace(this.gl.CCW);
  }

  /** @param {Camera} camera @param {number[]} X @param {number} mirrorHeight 0 for no mirror @param {Size} size */
  #begin(camera, X, mirrorHeight, { width, height }) {
    const { gl } = this;
    const { radius } = this.surface;
    const seen = seenFromStage(camera, mirrorHeight / radius);
    const cameraFromBody = product(camera.attitude, X);
    const eye = add(times(seen.turn, [0, 0, camera.distance / radius]), seen.shift);
    for (const program of this.programs) {
      program.use();
      program.set('eye', eye);
      program.setMatrix('clip_from_stage', clipFromStage(camera, radius, seen));
      program.setMatrix('stage_from_body', scale9(1 / radius, cameraFromBody));
      program.setMatrix('stage_normal_from_body', cofactors(cameraFromBody));
      program.set('picture', [width / 2, height / 2, 0.5]);
    }
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.CULL_FACE);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  }

  /** @param {Camera} camera @param {number[]} X @param {boolean} lifts whether parts are lifted over those that they touch */
  #drawParts(camera, X, lifts) {
    const { gl, surface } = this;
    const stageFromBody = scale9(1 / surface.radius, product(camera.attitude, X));
    gl.bindVertexArray(this.array);
    let begin = 0;
    const drawTo = (
      /** @type {Program} */ program,
      /** @type {number} */ end,
      /** @type {number[]} */ axis,
    ) => {
      if (end > begin) {
        program.set('side_axis', scale(surface.radius, times(stageFromBody, axis)));
        gl.drawElements(gl.TRIANGLES, end - begin, gl.UNSIGNED_INT, 4 * begin);
      }
      begin = end;
    };
    for (const part of surface.parts) {
      const program = this.programs[part.material];
      program.use();
      this.#setOccluders(program, part.occluders, stageFromBody, lifts);
      program.set('part_lift', lifts && part.occluders.some(({ meets }) => meets) ? 1 : 0);
      program.set('part_radii', part.radii);
      program.set('across_from_body', part.across);
      drawTo(program, part.side_begin, [0, 0, 0]);
      drawTo(program, part.end, part.axis);
    }
    gl.disable(gl.BLEND);
    gl.disable(gl.CULL_FACE);
    gl.bindVertexArray(null);
  }

  /** @param {Program} program @param {import("./surface.js").Capsule[]} capsules @param {number[]} stageFromBody @param {boolean} lifts */
  #setOccluders(program, capsules, stageFromBody, lifts) {
    const count = Math.max(...this.surface.parts.map((part) => part.occluders.length));
    if (count === 0) return;
    const from = [],
      to = [];
    for (let i = 0; i < count; ++i) {
      const capsule = capsules[i];
      // Unused ones are too small and far away to be visible.
      from.push(
        ...(capsule
          ? [...times(stageFromBody, capsule.from), capsule.radius / this.surface.radius]
          : [0, 0, -1e4, 1e-6]),
      );
      to.push(
        ...(capsule
          ? [...times(stageFromBody, capsule.to), lifts && capsule.meets ? 1 : 0]
          : [0, 1, -1e4, 0]),
      );
    }
    program.set('occluders_from', from);
    program.set('occluders_to', to);
    if (this.ofOneMaterial) return;
    const tint = (/** @type {number} */ i) => (capsules[i] ? this.#tint(capsules[i].part) : [1, 1, 1]);
    program.set('occluder_tints', Array.from({ length: count }, (_, i) => [...tint(i), 1]).flat());
  }

  /** The colour of the light that a part reflects. @param {number} part */
  #tint(part) {
    const { material, tint } = this.surface.parts[part];
    return tint ?? this.materials[material].tint;
  }

  free() {
    const { gl } = this;
    gl.deleteVertexArray(this.array);
    gl.deleteBuffer(this.vertices);
    gl.deleteBuffer(this.indices);
    gl.deleteBuffer(this.colors);
    for (const { program } of this.programs) gl.deleteProgram(program);
  }
}

/** @type {(s: number, m: number[]) => number[]} */
const scale9 = (s, m) => m.map((x) => s * x);

/**
 * The stage as it is seen in a mirror at that height, in stage units; as it is for the height 0.
 * @param {Camera} camera @param {number} height
 */
function seenFromStage(camera, height) {
  if (height === 0) return { turn: [1, 0, 0, 0, 1, 0, 0, 0, 1], shift: [0, 0, 0] };
  const up = [camera.attitude[1], camera.attitude[4], camera.attitude[7]];
  const turn = [];
  for (let i = 0; i < 3; ++i) {
    for (let k = 0; k < 3; ++k) turn.push((i === k ? 1 : 0) - 2 * up[i] * up[k]);
  }
  return { turn, shift: scale(2 * height, up) };
}

/** @param {Camera} camera @param {number} radius @param {{turn: number[], shift: number[]}} seen */
function clipFromStage(camera, radius, { turn, shift }) {
  const p = camera.projection;
  const result = [];
  for (let row = 0; row < 16; row += 4) {
    const r = [radius * p[row], radius * p[row + 1], radius * p[row + 2]];
    for (let i = 0; i < 3; ++i) result.push(r[0] * turn[i] + r[1] * turn[3 + i] + r[2] * turn[6 + i]);
    result.push(
      r[0] * shift[0] + r[1] * shift[1] + r[2] * shift[2] + p[row + 3] - camera.distance * p[row + 2],
    );
  }
  return result;
}
