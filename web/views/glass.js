import { clamp, dot, normalized, subtract } from '../math/linear.js';

/** @typedef {import("../math/linear.js").Vec3} Vec3 */

const through = 0.22,
  ramp = 0.12;

/**
 * How visible a point on a closed convex surface of glass is from `eye`: 1 on the near side, less on
 * the far side.
 * @param {Vec3} place @param {Vec3} outward The surface's normal. @param {Vec3} eye
 */
export function shown(place, outward, eye) {
  const facing = dot(normalized(outward), normalized(subtract(eye, place)));
  const t = clamp(0.5 + facing / ramp, 0, 1);
  return through + (1 - through) * t * t * (3 - 2 * t);
}
