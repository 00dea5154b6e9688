// The surface of a body as the picture needs it: the program's own for the scene, and the core's box for
// a body that is given by its moments.
import { unpacked } from './unpacking.js';

/**
 * @typedef {object} SurfacePart
 * @property {number} side_begin In indices, where the side of a cylinder begins; else `end`.
 * @property {number} end
 * @property {number[]} [tint] The mean colour of its vertices, if they have colours.
 * @property {number} material Index in the materials of a theme.
 */

/**
 * @typedef {object} Surface
 * @property {Float32Array} vertices Positions in body axes, cm, each with its normal.
 * @property {Uint32Array} indices
 * @property {Uint16Array | null} colors Linear, of the vertices, if a part has colours of its own.
 * @property {SurfacePart[]} parts
 * @property {boolean} marked Whether a stripe shows how a body of revolution turns.
 * @property {number} radius Bounding radius, cm.
 * @property {number[]} trail_point The point of the body that draws the trail.
 * @property {number} occluder_count The most occluders of a part.
 * @property {number[]} model The numbers from which the core computes uniforms.
 */

/**
 * The surface that src/page/surface_json.h wrote.
 * @param {any} json
 * @returns {Promise<Surface>}
 */
export async function surfaceOf(json) {
  const integers = await unpacked(json.vertices, Int16Array, 6);
  const vertices = Float32Array.from(integers, (x, i) => (x / 32767) * (i % 6 < 3 ? json.radius : 1));
  const indices = await unpacked(json.indices, Uint32Array, 1);
  const colors = json.colors ? await unpacked(json.colors, Uint16Array, 3) : null;
  return { ...json, vertices, indices, colors };
}

/**
 * @param {import('../core/core.js').Core} core
 * @param {number[]} moments about the body's x, y and z axes, g cm^2
 * @returns {Surface}
 */
export function boxSurface({ instance }, moments) {
  instance.scratch(3).set(moments);
  const count = instance.call('box_surface');
  const [vertices, vertexCount, indices, end, x, y, z, ...model] = instance.scratch(count);
  const { buffer } = instance.exports.memory;
  return {
    vertices: new Float32Array(buffer, vertices, 6 * vertexCount).slice(),
    indices: new Uint32Array(buffer, indices, end).slice(),
    colors: null,
    parts: [{ side_begin: end, end, material: 0 }],
    marked: false,
    radius: model[0],
    trail_point: [x, y, z],
    occluder_count: 0,
    model,
  };
}
