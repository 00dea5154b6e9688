// The surface of a body for the picture: the scene's from the program, or a box from the core for a body
// given by its moments.
import { unpacked } from './unpacking.js';

/** @import { Surface } from '../app/types' */

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
  const [vertices, vertexCount, indices, end, x, y, z, ...numbers] = instance.scratch(count);
  const mark = numbers.splice(0, 12);
  const { buffer } = instance.exports.memory;
  return {
    vertices: new Float32Array(buffer, vertices, 6 * vertexCount).slice(),
    indices: new Uint32Array(buffer, indices, end).slice(),
    colors: null,
    parts: [{ side_begin: end, end, material: 0 }],
    mark,
    radius: numbers[0],
    trail_point: [x, y, z],
    occluder_count: 0,
    model: numbers,
  };
}
