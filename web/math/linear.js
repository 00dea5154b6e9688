// Vectors as arrays of 3 numbers, matrices as arrays of 9, row by row.

/** @typedef {ArrayLike<number>} Vec3 */
/** @typedef {ArrayLike<number>} Mat3 */

/** @type {(a: Vec3, b: Vec3) => number[]} */
export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];

/** @type {(s: number, v: Vec3) => number[]} */
export const scale = (s, v) => [s * v[0], s * v[1], s * v[2]];

/** @type {(a: Vec3, b: Vec3) => number} */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** @type {(a: Vec3, b: Vec3) => number[]} */
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** @type {(m: Mat3, v: Vec3) => number[]} */
export const times = (m, v) => [0, 3, 6].map((row) => m[row] * v[0] + m[row + 1] * v[1] + m[row + 2] * v[2]);

/** @type {(v: Vec3) => number} */
export const norm = (v) => Math.hypot(v[0], v[1], v[2]);

/** @type {(value: number, low: number, high: number) => number} */
export const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

/** @type {(m: Mat3, i: number) => number[]} */
export const column = (m, i) => [m[i], m[3 + i], m[6 + i]];
