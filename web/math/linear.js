// Vectors as arrays of 3 numbers, matrices as arrays of 9, row by row.

/** @typedef {ArrayLike<number>} Vec3 */
/** @typedef {ArrayLike<number>} Mat3 */

/** @type {(a: Vec3, b: Vec3) => number} */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** @type {(a: Vec3, b: Vec3) => number[]} */
export const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** @type {(a: Vec3, b: Vec3) => number[]} */
export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];

/** @type {(a: Vec3, b: Vec3) => number[]} */
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

/** @type {(s: number, v: Vec3) => number[]} */
export const scale = (s, v) => [s * v[0], s * v[1], s * v[2]];

/** @type {(v: Vec3) => number} */
export const norm = (v) => Math.hypot(v[0], v[1], v[2]);

/**
 * The unit vector along `v`; 0 for the vector 0.
 * @param {Vec3} v
 * @returns {number[]}
 */
export function normalized(v) {
  const length = norm(v);
  return length > 0 ? [v[0] / length, v[1] / length, v[2] / length] : [0, 0, 0];
}

/** @type {(from: number, to: number, share: number) => number} */
export const mix = (from, to, share) => from + (to - from) * share;

/** @type {(value: number, low: number, high: number) => number} */
export const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

export const identity = [1, 0, 0, 0, 1, 0, 0, 0, 1];

/** @type {(m: Mat3, v: Vec3) => number[]} */
export const times = (m, v) => [
  m[0] * v[0] + m[1] * v[1] + m[2] * v[2],
  m[3] * v[0] + m[4] * v[1] + m[5] * v[2],
  m[6] * v[0] + m[7] * v[1] + m[8] * v[2],
];

/** @type {(m: Mat3) => number[]} */
export const transposed = (m) => [m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]];

/** @type {(m: Mat3, i: number) => number[]} */
export const column = (m, i) => [m[i], m[3 + i], m[6 + i]];

/** @type {(a: Vec3, b: Vec3, c: Vec3) => number[]} */
export const fromColumns = (a, b, c) => [a[0], b[0], c[0], a[1], b[1], c[1], a[2], b[2], c[2]];

/**
 * @param {Mat3} a
 * @param {Mat3} b
 * @returns {number[]}
 */
export function product(a, b) {
  const result = new Array(9);
  for (let row = 0; row < 9; row += 3) {
    for (let i = 0; i < 3; ++i) {
      result[row + i] = a[row] * b[i] + a[row + 1] * b[3 + i] + a[row + 2] * b[6 + i];
    }
  }
  return result;
}

/** @type {(s: Vec3) => number[]} */
export const diagonal = (s) => [s[0], 0, 0, 0, s[1], 0, 0, 0, s[2]];

/**
 * The matrix that transforms normals with a surface: of the cofactors, for a rotation the rotation
 * itself.
 * @param {Mat3} m
 */
export function cofactors(m) {
  const [a, b, c] = [column(m, 0), column(m, 1), column(m, 2)];
  return fromColumns(cross(b, c), cross(c, a), cross(a, b));
}

/** @param {Mat3} m */
export function inverse(m) {
  const c = cofactors(m);
  const determinant = m[0] * c[0] + m[3] * c[3] + m[6] * c[6];
  return transposed(c).map((x) => x / determinant);
}

/**
 * A rotation whose z axis is along `axis` (Duff et al., "Building an Orthonormal Basis, Revisited",
 * JCGT 2017).
 * @param {Vec3} axis
 */
export function frameWithZAlong(axis) {
  const [x, y, z] = normalized(axis);
  const sign = z < 0 || Object.is(z, -0) ? -1 : 1;
  const a = -1 / (sign + z);
  const b = x * y * a;
  return fromColumns([1 + sign * x * x * a, sign * b, -sign * x], [b, sign + y * y * a, -y], [x, y, z]);
}

/**
 * The rotation by the angle |v| rad about v: Rodrigues' formula.
 * @param {Vec3} v
 */
export function rotation(v) {
  const angle = norm(v);
  const [x, y, z] = normalized(v);
  const s = Math.sin(angle);
  const h = 2 * Math.sin(angle / 2) ** 2; // 1 - cos, without cancellation
  return [
    1 - h * (y * y + z * z),
    h * x * y - s * z,
    h * x * z + s * y,
    h * x * y + s * z,
    1 - h * (x * x + z * z),
    h * y * z - s * x,
    h * x * z - s * y,
    h * y * z + s * x,
    1 - h * (x * x + y * y),
  ];
}
