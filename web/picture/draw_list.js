// Lines, arrows and plain surfaces in space as a camera sees them, as triangles in the order in
// which they were added: src/picture/overlay/draw_list.h for a framebuffer with several samples a
// pixel, so that only lines and dots need an antialiased edge of their own.
import { add, dot, normalized, subtract, times } from '../math/linear.js';
import { clipFromSpace, eyeOf, transformed } from '../math/camera.js';

/** @typedef {import("../math/linear.js").Vec3} Vec3 */
/** @typedef {{color: number[], opacity: number}} Ink  sRGB from 0 to 255, and 0 to 1 */

export const floatsOfVertex = 11; // clip 4, paint 4, edge 3
export const noEdge = [0, 0, 1e6];

const key = normalized([0.45, 0.75, 0.5]);
const fill = normalized([-0.8, 0.1, 0.6]);

/** @param {Ink} ink @param {Vec3} normal camera axes @param {Vec3} toEye @returns {Ink} */
function lit(ink, normal, toEye) {
  const light = 0.72 + 0.3 * Math.max(dot(normal, key), 0) + 0.12 * Math.max(dot(normal, fill), 0);
  const gleam = 0.35 * Math.max(dot(normal, normalized(add(key, toEye))), 0) ** 40;
  const color = ink.color.map((value) => {
    const base = Math.min(light * value, 255);
    return base + gleam * (255 - base);
  });
  return { color, opacity: ink.opacity };
}

/** The ink that looks like `top` over `ground`. @param {Ink} top @param {Ink} ground @returns {Ink} */
function over(top, ground) {
  const behind = (1 - top.opacity) * ground.opacity,
    opacity = top.opacity + behind;
  if (!(opacity > 0)) return top;
  return {
    opacity,
    color: top.color.map((value, i) => (top.opacity * value + behind * ground.color[i]) / opacity),
  };
}

/** Joins two rings of `count` vertices by triangles. @param {number} first @param {number} second @param {number} count @param {number[]} faces */
export function band(first, second, count, faces) {
  for (let i = 0; i < count; ++i) {
    const next = (i + 1) % count;
    faces.push(first + i, first + next, second + i, second + i, first + next, second + next);
  }
}

export class DrawList {
  vertices = new Float32Array(4096 * floatsOfVertex);
  count = 0;
  /** @type {number[]} */ faces = [];
  /** @type {number[]} */ outlines = [];
  /** @type {number[]} */ ghosts = [];
  /** @type {number[]} */ clipFromSpace = [];
  /** @type {number[]} */ attitude = [];
  /** The eye in space. @type {number[]} */ eye = [0, 0, 1];
  /** Of the picture, in pixels. */ halfSize = [1, 1];
  /** The width of a thin line in pixels. */ hairline = 1;
  /** Pixels per unit length at distance 1. */ scale = 1;
  /** What brings an item nearer by the picture's height, in clip space. */ clipZNearer = 0;

  /**
   * Clears the list; later items are seen by `camera`, whose picture has that size in pixels.
   * @param {import("../math/camera.js").Camera} camera @param {number} width @param {number} height
   * @param {number} [thinnest] Width of the thinnest line in pixels.
   */
  begin(camera, width, height, thinnest = 1) {
    this.clipFromSpace = clipFromSpace(camera);
    this.attitude = camera.attitude;
    this.eye = eyeOf(camera);
    this.halfSize = [width / 2, height / 2];
    this.hairline = Math.max(thinnest, 0.0022 * Math.min(width, height));
    const p = camera.projection;
    this.scale = p[5] * this.halfSize[1];
    this.clipZNearer = (2 * p[11]) / p[5];
    this.count = 0;
    for (const list of [this.faces, this.outlines, this.ghosts]) list.length = 0;
  }

  /** The size in pixels of a unit length at `place`; 0 behind the eye. @param {Vec3} place */
  pixels(place) {
    const depth = transformed(this.clipFromSpace, place)[3];
    return depth > 0 ? this.scale / depth : 0;
  }

  /** @param {ArrayLike<number>} clip @param {Ink} ink @param {number[]} edge */
  add(clip, ink, edge) {
    const at = this.count * floatsOfVertex;
    if (at + floatsOfVertex > this.vertices.length) {
      const larger = new Float32Array(2 * this.vertices.length);
      larger.set(this.vertices);
      this.vertices = larger;
    }
    const v = this.vertices;
    const s = ink.opacity / 255;
    v[at] = clip[0];
    v[at + 1] = clip[1];
    v[at + 2] = clip[2];
    v[at + 3] = clip[3];
    v[at + 4] = s * ink.color[0];
    v[at + 5] = s * ink.color[1];
    v[at + 6] = s * ink.color[2];
    v[at + 7] = ink.opacity;
    v[at + 8] = edge[0];
    v[at + 9] = edge[1];
    v[at + 10] = edge[2];
    return this.count++;
  }

  /** @param {Vec3} place @param {Vec3} normal @param {Ink} ink @param {Ink} [ground] */
  addLit(place, normal, ink, ground) {
    const toEye = times(this.attitude, normalized(subtract(this.eye, place)));
    const shaded = lit(ink, times(this.attitude, normal), toEye);
    return this.add(transformed(this.clipFromSpace, place), ground ? over(shaded, ground) : shaded, noEdge);
  }
}
