// The surface of a body as the picture needs it: the program's own for the scene, and a box for a
// body that is given by its moments.
import { add, scale } from '../math/linear.js';
import { unpacked } from './unpacking.js';

/** `meets` if it is a cylinder drawn before, which the part touches. @typedef {{from: number[], to: number[], radius: number, meets: boolean, part: number}} Capsule */
/** @typedef {{centre: number[], radius: number}} Ball  casts shadow; body axes, cm */

/**
 * Index ranges and uniforms of a part; see src/draw/body_pass.cpp.
 * @typedef {object} SurfacePart
 * @property {number} side_begin In indices, where the side of a cylinder begins; else `end`.
 * @property {number} end
 * @property {number[]} [tint] The mean colour of its vertices, if they have colours.
 * @property {number} material Index in the materials of a theme.
 * @property {number[]} radii
 * @property {number[]} axis Of a cylinder, else 0.
 * @property {number[]} across Two vec4.
 * @property {Capsule[]} occluders
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
 * @property {Ball[]} balls
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

const edgeShare = 0.08; // of the smallest half size: the radius of the rounded edges
const chordsOfEdge = 4;

/**
 * The sizes of the box of density 1 with these principal moments, cm; see
 * src/body/mass_properties.cpp.
 * @param {number[]} moments
 */
export function equimomentalBox(moments) {
  const sum = moments[0] + moments[1] + moments[2];
  const s = moments.map((moment) => Math.max(sum - 2 * moment, 1e-6 * sum));
  const mass = (6 ** 1.5 * Math.sqrt(s[0] * s[1] * s[2])) ** 0.4;
  return s.map((x) => Math.sqrt((6 / mass) * x));
}

/**
 * @param {number[]} moments about the body's x, y and z axes, g cm^2
 * @returns {Surface}
 */
export function boxSurface(moments) {
  const size = equimomentalBox(moments);
  const half = scale(0.5, size);
  const radius = Math.hypot(...half);
  const { vertices, indices } = roundedBox(half);
  const longest = half.indexOf(Math.max(...half));
  const capsuleRadius = (half[0] + half[1] + half[2] - half[longest]) / 2;
  const part = {
    side_begin: indices.length,
    end: indices.length,
    material: 0,
    axis: [0, 0, 0],
    occluders: [],
    radii: [capsuleRadius / radius, 0, 0],
    across: [0, 0, 0, 0, 0, 0, 0, 0],
  };
  const trail = [0, 0, 0];
  trail[longest] = 1.06 * half[longest];
  return {
    vertices,
    indices,
    colors: null,
    parts: [part],
    marked: false,
    radius,
    trail_point: trail,
    balls: ballsAlong(half, longest, capsuleRadius),
  };
}

/** @param {number[]} half @param {number} longest @param {number} radius */
function ballsAlong(half, longest, radius) {
  const reach = Math.max(0, half[longest] - radius / 2);
  const gaps = Math.round(Math.min((2 * reach) / ((Math.PI / 2) * radius), 60));
  const balls = [];
  for (let i = 0; i <= gaps; ++i) {
    const centre = [0, 0, 0];
    centre[longest] = reach * (gaps > 0 ? (2 * i) / gaps - 1 : 0);
    balls.push({ centre, radius });
  }
  return balls;
}

/**
 * A box with rounded edges: a sphere cut into octants that are moved apart, ring by ring.
 * @param {number[]} half
 */
function roundedBox(half) {
  const bevel = edgeShare * Math.min(...half);
  const inner = half.map((h) => h - bevel);
  const quarter = Math.PI / 2;
  const vertices = [];
  for (const end of [-1, 1]) {
    for (let j = 0; j <= chordsOfEdge; ++j) {
      const latitude = quarter * (end < 0 ? j / chordsOfEdge - 1 : j / chordsOfEdge);
      for (let octant = 0; octant < 4; ++octant) {
        const corner = [
          octant === 0 || octant === 3 ? inner[0] : -inner[0],
          octant < 2 ? inner[1] : -inner[1],
          end * inner[2],
        ];
        for (let i = 0; i <= chordsOfEdge; ++i) {
          const longitude = quarter * (octant + i / chordsOfEdge);
          const normal = [
            Math.cos(latitude) * Math.cos(longitude),
            Math.cos(latitude) * Math.sin(longitude),
            Math.sin(latitude),
          ];
          vertices.push(...add(corner, scale(bevel, normal)), ...normal);
        }
      }
    }
  }
  const around = 4 * (chordsOfEdge + 1);
  return {
    vertices: Float32Array.from(vertices),
    indices: Uint32Array.from(ringIndices(2 * (chordsOfEdge + 1), around)),
  };
}

/** Quads between rings, and fans that fill the first and the last. @param {number} rings @param {number} around */
function ringIndices(rings, around) {
  const indices = [];
  const last = (rings - 1) * around;
  for (let i = 1; i + 1 < around; ++i) indices.push(0, i + 1, i, last, last + i, last + i + 1);
  for (let low = 0; low < last; low += around) {
    for (let i = 0; i < around; ++i) {
      const next = (i + 1) % around;
      indices.push(low + i, low + next, low + around + next, low + i, low + around + next, low + around + i);
    }
  }
  return indices;
}
