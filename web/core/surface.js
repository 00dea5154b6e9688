/** A body in the core, which computes the uniforms for drawing it and the floor below it. */
import { Held } from './motion.js';
import { floatsAt } from './pictures.js';

/** @import { Core } from './core.js' */
/** @import { Camera } from './types' */
/** @import { Surface } from '../app/types' */

/** Values by the names of uniforms in the shaders. @typedef {Record<string, Float32Array>} Uniforms */

// The uniforms in the order in which the core writes them, with the number of floats of each.
const sizesOfBody = { eye: 3, clip_from_stage: 16, stage_from_body: 9, stage_normal_from_body: 9 };
const sizesOfPart = { part_lift: 1, part_is_solid: 1, part_radii: 3, side_axis: 3, across_from_body: 8 };
const sizesOfFloor = { floor_from_place: 9, right_and_height: 4 };

export class CoreSurface {
  /** @param {Core} core @param {Surface} surface @param {number[][]} tints of the parts */
  constructor({ instance }, { parts, occluder_count, model }, tints) {
    const numbers = [...model, ...tints.flat()],
      floats = 4 * occluder_count;
    this.instance = instance;
    this.sizes = parts.map(() => ({
      ...sizesOfPart,
      occluders_from: floats,
      occluders_to: floats,
      occluder_tints: floats,
    }));
    this.held = new Held(instance, () => instance.callWith(numbers, 'surface_new'), 'surface_free');
  }

  /** @param {string} name @param {Camera} camera @param {number[]} X @param {number[]} rest */
  #floats(name, { attitude, distance, projection }, X, ...rest) {
    const pointer = this.held.get();
    const numbers = [...attitude, distance, ...projection, ...X];
    return floatsAt(this.instance, this.instance.callWith(numbers, name, pointer, ...rest));
  }

  /**
   * The uniforms of the body in the attitude X, or of its image in the floor: those of all parts, and of
   * each.
   * @param {Camera} camera @param {number[]} X @param {boolean} mirrored
   */
  uniforms(camera, X, mirrored) {
    const take = taking(this.#floats('surface_uniforms', camera, X, mirrored ? 1 : 0));
    return { body: take(sizesOfBody), parts: this.sizes.map(take) };
  }

  /** The uniforms of the floor. @param {Camera} camera @param {number[]} X @returns {Uniforms} */
  floor(camera, X) {
    const floats = this.#floats('floor_uniforms', camera, X);
    return { ...taking(floats)(sizesOfFloor), balls: floats.subarray(13) };
  }

  release() {
    this.held.release();
  }
}

/** Takes the next floats by their names. @param {Float32Array} floats */
function taking(floats) {
  let at = 0;
  return (/** @type {Record<string, number>} */ sizes) => {
    /** @type {Uniforms} */
    const values = {};
    for (const name in sizes) values[name] = floats.subarray(at, (at += sizes[name]));
    return values;
  };
}
