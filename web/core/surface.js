/** A body in the core: the values of the uniforms with which it and the floor below it are drawn. */
import { Held } from './motion.js';
import { floatsAt } from './pictures.js';

/** @typedef {import('./core.js').Core} Core */
/** @typedef {import('./pictures.js').Camera} Camera */
/** @typedef {import('../picture/surface.js').Surface} Surface */

/**
 * Uniforms of all parts, and of each, by their names in the shaders.
 * @typedef {{eye: Float32Array, clip_from_stage: Float32Array, stage_from_body: Float32Array, stage_normal_from_body: Float32Array, parts: PartUniforms[]}} BodyUniforms
 */
/** @typedef {{part_lift: Float32Array, part_radii: Float32Array, side_axis: Float32Array, across_from_body: Float32Array, occluders_from: Float32Array, occluders_to: Float32Array, occluder_tints: Float32Array}} PartUniforms */

export class CoreSurface {
  /** @param {Core} core @param {Surface} surface @param {number[][]} tints of the parts */
  constructor({ instance }, surface, tints) {
    this.instance = instance;
    this.parts = surface.parts.length;
    this.occluders = Math.max(...surface.parts.map((part) => part.occluders.length));
    const numbers = [
      surface.radius,
      surface.parts.length,
      ...surface.parts.flatMap(({ radii, axis, across, occluders }, i) => [
        ...radii,
        ...axis,
        ...across,
        ...tints[i],
        occluders.length,
        ...occluders.flatMap(({ from, to, radius, meets, part }) => [
          ...from, ...to, radius, meets ? 1 : 0, part,
        ]),
      ]),
      surface.balls.length,
      ...surface.balls.flatMap(({ centre, radius }) => [...centre, radius]),
    ];
    /** @type {Held} */
    this.held = new Held(
      instance,
      () => {
        instance.scratch(numbers.length).set(numbers);
        return instance.call('surface_new');
      },
      'surface_free',
    );
  }

  /** @param {string} name @param {Camera} camera @param {number[]} X @param {number[]} rest */
  #floats(name, { attitude, distance, projection }, X, ...rest) {
    const pointer = this.held.get();
    this.instance.scratch(35).set([...attitude, distance, ...projection, ...X]);
    return floatsAt(this.instance, this.instance.call(name, pointer, ...rest));
  }

  /**
   * The uniforms of the body in the attitude X, or of its image in the floor.
   * @param {Camera} camera @param {number[]} X @param {boolean} mirrored
   * @returns {BodyUniforms}
   */
  uniforms(camera, X, mirrored) {
    const take = taking(this.#floats('surface_uniforms', camera, X, mirrored ? 1 : 0)),
      arrays = 4 * this.occluders;
    return {
      eye: take(3),
      clip_from_stage: take(16),
      stage_from_body: take(9),
      stage_normal_from_body: take(9),
      parts: Array.from({ length: this.parts }, () => ({
        part_lift: take(1),
        part_radii: take(3),
        side_axis: take(3),
        across_from_body: take(8),
        occluders_from: take(arrays),
        occluders_to: take(arrays),
        occluder_tints: take(arrays),
      })),
    };
  }

  /** The uniforms of the floor. @param {Camera} camera @param {number[]} X */
  floor(camera, X) {
    const floats = this.#floats('floor_uniforms', camera, X),
      take = taking(floats);
    return { floor_from_place: take(9), right_and_height: take(4), balls: floats.subarray(13) };
  }

  release() {
    this.held.release();
  }
}

/** Takes numbers one after another. @param {Float32Array} floats */
function taking(floats) {
  let at = 0;
  return (/** @type {number} */ count) => floats.subarray(at, (at += count));
}
