// The film's perspective camera, which looks at the origin of space. Matrices of 16 numbers are row
// by row, for column vectors in OpenGL's conventions: clip = projection * view * point.
import { add, clamp, cross, dot, normalized, scale, times, transposed } from './linear.js';

/** @typedef {import("./linear.js").Vec3} Vec3 */
/** @typedef {import("./linear.js").Mat3} Mat3 */

/**
 * @typedef {object} Camera
 * @property {number[]} attitude camera_from_space, a rotation of 9 numbers.
 * @property {number} distance From the origin to the eye, cm.
 * @property {number[]} projection clip_from_camera, 16 numbers.
 */

/**
 * What a camera should have in view.
 * @typedef {object} Framing
 * @property {number} fieldOfView Along the shorter side of the picture, rad.
 * @property {number} aspect Width / height.
 * @property {number} radius Of the sphere about the origin that must be in view, cm.
 * @property {number} distance In units of the one at which the sphere just fits.
 * @property {number[]} centre Of the picture, in units of half the shorter side, y up.
 */

const framingMargin = 1.08; // around the sphere: 4 % of the picture on each side

/**
 * The unit vector from the origin to the eye; angles in rad.
 * @param {number} azimuth
 * @param {number} elevation
 */
export function directionOf(azimuth, elevation) {
  const c = Math.cos(elevation);
  return [Math.sin(azimuth) * c, Math.sin(elevation), Math.cos(azimuth) * c];
}

/** @param {Vec3} direction towards the eye */
function attitudeTowards(direction) {
  const back = normalized(direction);
  const fromThePole = Math.hypot(back[0], back[2]) < 1e-18;
  const up = fromThePole ? [0, 0, -Math.sign(back[1])] : [0, 1, 0];
  const right = normalized(cross(up, back));
  return [...right, ...cross(back, right), ...back];
}

/**
 * @param {number} tanX @param {number} tanY @param {number} near @param {number} far
 */
const perspective = (tanX, tanY, near, far) => [
  1 / tanX,
  0,
  0,
  0,
  0,
  1 / tanY,
  0,
  0,
  0,
  0,
  -(far + near) / (far - near),
  (-2 * far * near) / (far - near),
  0,
  0,
  -1,
  0,
];

/** Half the picture's sides in units of half the shorter one. @param {number} aspect */
const halfSides = (aspect) => [Math.max(aspect, 1), Math.max(1 / aspect, 1)];

/**
 * The camera whose picture holds the sphere with a margin at the nearer pair of edges.
 * @param {Framing} framing
 * @param {Vec3} direction from the origin to the eye, of any length
 * @returns {Camera}
 */
export function frameSphere(framing, direction) {
  const half = framing.fieldOfView / 2;
  const distance = (framing.distance * framingMargin * framing.radius) / Math.sin(half);
  const sides = halfSides(framing.aspect);
  const tangent = Math.tan(half);
  const projection = perspective(tangent * sides[0], tangent * sides[1], 0.05 * distance, 20 * distance);
  projection[2] = framing.centre[0] / sides[0];
  projection[6] = framing.centre[1] / sides[1];
  return { attitude: attitudeTowards(direction), distance, projection };
}

/**
 * What a picture should hold: [left, right, bottom, top] in units of half its shorter side.
 * @param {Framing} framing @param {Vec3[]} directions @param {Vec3[]} points
 */
function extentOf(framing, directions, points) {
  const tanHalf = Math.tan(framing.fieldOfView / 2);
  const extent = [Infinity, -Infinity, Infinity, -Infinity];
  const extend = (/** @type {number} */ x, /** @type {number} */ y) => {
    extent[0] = Math.min(extent[0], x);
    extent[1] = Math.max(extent[1], x);
    extent[2] = Math.min(extent[2], y);
    extent[3] = Math.max(extent[3], y);
  };
  for (const direction of directions) {
    const camera = frameSphere({ ...framing, centre: [0, 0] }, direction);
    const sine = framing.radius / camera.distance;
    const silhouette = (framingMargin * sine) / Math.sqrt(1 - sine * sine) / tanHalf;
    extend(silhouette, silhouette);
    extend(-silhouette, -silhouette);
    for (const point of points) {
      const p = times(camera.attitude, point);
      const depth = Math.max(camera.distance - p[2], 1e-3 * camera.distance);
      const share = framingMargin / (depth * tanHalf);
      extend(share * p[0], share * p[1]);
    }
  }
  return extent;
}

/**
 * The framing from as near as possible, at least the distance 1, at which the sphere and all points
 * are in view from each of the directions, and together in the middle.
 * @param {Framing} framing @param {Vec3[]} directions @param {Vec3[]} points
 * @returns {Framing}
 */
export function fitted(framing, directions, points) {
  const sides = halfSides(framing.aspect);
  const result = { ...framing, distance: 1 };
  let extent = extentOf(result, directions, points);
  for (let attempt = 0; attempt < 60; ++attempt) {
    const excess = Math.max(
      (extent[1] - extent[0]) / (2 * sides[0]),
      (extent[3] - extent[2]) / (2 * sides[1]),
    );
    if (excess <= 1 + 1e-9) break;
    result.distance *= excess;
    extent = extentOf(result, directions, points);
  }
  result.centre = [(extent[0] + extent[1]) / 2, (extent[2] + extent[3]) / 2];
  return result;
}

/** The camera for space of one that stands in a frame with that attitude, space_from_frame.
 * @param {Camera} camera @param {Mat3} spaceFromFrame @returns {Camera}
 */
export function carried(camera, spaceFromFrame) {
  const rows = [0, 3, 6].map((i) => times(spaceFromFrame, camera.attitude.slice(i, i + 3)));
  return { ...camera, attitude: rows.flat() };
}

/** The position of the eye in space, cm. @param {Camera} camera */
export const eyeOf = (camera) => scale(camera.distance, camera.attitude.slice(6));

/**
 * clip_from_space, 16 numbers row by row.
 * @param {Camera} camera
 */
export function clipFromSpace({ attitude, distance, projection: p }) {
  const result = [];
  for (let row = 0; row < 16; row += 4) {
    for (let i = 0; i < 3; ++i) {
      result.push(p[row] * attitude[i] + p[row + 1] * attitude[3 + i] + p[row + 2] * attitude[6 + i]);
    }
    result.push(p[row + 3] - distance * p[row + 2]);
  }
  return result;
}

/**
 * @param {number[]} m 16 numbers, row by row
 * @param {Vec3} v
 * @returns {number[]} m * (v, 1)
 */
export const transformed = (m, v) => [
  m[0] * v[0] + m[1] * v[1] + m[2] * v[2] + m[3],
  m[4] * v[0] + m[5] * v[1] + m[6] * v[2] + m[7],
  m[8] * v[0] + m[9] * v[1] + m[10] * v[2] + m[11],
  m[12] * v[0] + m[13] * v[1] + m[14] * v[2] + m[15],
];

/**
 * Where a ray through a point of the picture meets the sphere of that radius about the origin; on
 * its silhouette where the ray misses it.
 * @param {Camera} camera @param {number} x -1 to 1 across @param {number} y -1 to 1, up @param {number} radius
 */
export function pickSphere(camera, x, y, radius) {
  const p = camera.projection;
  const ray = normalized(times(transposed(camera.attitude), [(x + p[2]) / p[0], (y + p[6]) / p[5], -1]));
  const eye = eyeOf(camera);
  const along = -dot(eye, ray);
  const aside = Math.max(dot(eye, eye) - along * along, 0);
  const depth = along - Math.sqrt(clamp(radius * radius - aside, 0, radius * radius));
  return scale(radius, normalized(add(eye, scale(depth, ray))));
}
