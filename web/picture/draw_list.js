// Lines, arrows and plain surfaces in space as a camera sees them, as triangles in the order in
// which they were added: src/render/overlay/draw_list.h for a framebuffer with several samples a
// pixel, so that only lines and dots need an antialiased edge of their own.
import {add, clamp, column, dot, frameWithZAlong, inverse, norm, normalized, scale, subtract, times, transposed} from "../math/linear.js";
import {clipFromSpace, eyeOf, transformed} from "../math/camera.js";

/** @typedef {import("../math/linear.js").Vec3} Vec3 */
/** @typedef {{color: number[], opacity: number}} Ink  sRGB from 0 to 255, and 0 to 1 */
/** @typedef {{place: Vec3, width: number, ink: Ink}} Point  of a line; width in pixels */

const floatsOfVertex = 11;  // clip 4, paint 4, edge 3
const noEdge = [0, 0, 1e6];

// Of an arrow: the length of the head and the radius of its base in radii of the shaft; the outline.
const headLength = 5.5, headRadius = 2.4;
const outlineWidth = 0.3, leastOutline = 1, outlineOpacity = 0.9;
const aroundArrow = 28, aroundOutline = 16, aroundGhost = 10, aroundDisc = 96;

/** By how many pixels a halo reaches beyond something that is so many pixels wide. @param {number} width */
export const haloOf = (width) => Math.max(0.4 * width, 1);

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
  return {color, opacity: ink.opacity};
}

/** The ink that looks like `top` over `ground`. @param {Ink} top @param {Ink} ground @returns {Ink} */
function over(top, ground) {
  const behind = (1 - top.opacity) * ground.opacity, opacity = top.opacity + behind;
  if (!(opacity > 0)) return top;
  return {opacity, color: top.color.map((value, i) => (top.opacity * value + behind * ground.color[i]) / opacity)};
}

/** @param {number} value sRGB, 0 to 255 */
function linearFromSrgb(value) {
  const s = value / 255;
  return s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4;
}

/** Black or white, whichever has the higher contrast. @param {number[]} color */
function contrasting([red, green, blue]) {
  const luminance = 0.2126 * linearFromSrgb(red) + 0.7152 * linearFromSrgb(green) + 0.0722 * linearFromSrgb(blue);
  return luminance > 0.179 ? [8, 9, 12] : [255, 255, 255];
}

/**
 * A cone or a part of one, with its axis along z of its frame.
 * @typedef {object} Cone
 * @property {number[]} frame @property {number[]} from Centre of its base.
 * @property {number} length @property {number} base @property {number} top Radii.
 * @property {Ink} ink @property {number} around @property {boolean} shaded
 */

/** The cone whose faces lie that far outside. @param {Cone} cone @param {number} by @param {Ink} ink @returns {Cone} */
function grown(cone, by, ink) {
  const slant = Math.hypot(cone.length, cone.base - cone.top);
  const wider = (by * slant) / cone.length, slope = (by * (cone.base - cone.top)) / cone.length;
  return {frame: cone.frame, from: subtract(cone.from, scale(by, column(cone.frame, 2))), length: cone.length + 2 * by,
    base: cone.base + wider + slope, top: cone.top + wider - slope, ink, around: aroundOutline, shaded: false};
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
   */
  begin(camera, width, height) {
    this.clipFromSpace = clipFromSpace(camera);
    this.attitude = camera.attitude;
    this.eye = eyeOf(camera);
    this.halfSize = [width / 2, height / 2];
    this.hairline = Math.max(1, 0.0022 * Math.min(width, height));
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
  #add(clip, ink, edge) {
    const at = this.count * floatsOfVertex;
    if (at + floatsOfVertex > this.vertices.length) {
      const larger = new Float32Array(2 * this.vertices.length);
      larger.set(this.vertices);
      this.vertices = larger;
    }
    const v = this.vertices;
    const s = ink.opacity / 255;
    v[at] = clip[0]; v[at + 1] = clip[1]; v[at + 2] = clip[2]; v[at + 3] = clip[3];
    v[at + 4] = s * ink.color[0]; v[at + 5] = s * ink.color[1]; v[at + 6] = s * ink.color[2]; v[at + 7] = ink.opacity;
    v[at + 8] = edge[0]; v[at + 9] = edge[1]; v[at + 10] = edge[2];
    return this.count++;
  }

  /** @param {Vec3} place @param {Vec3} normal @param {Ink} ink @param {Ink} [ground] */
  #addLit(place, normal, ink, ground) {
    const toEye = times(this.attitude, normalized(subtract(this.eye, place)));
    const shaded = lit(ink, times(this.attitude, normal), toEye);
    return this.#add(transformed(this.clipFromSpace, place), ground ? over(shaded, ground) : shaded, noEdge);
  }

  /** @param {number} first @param {number} second @param {number} count @param {number[]} faces */
  #band(first, second, count, faces) {
    for (let i = 0; i < count; ++i) {
      const next = (i + 1) % count;
      faces.push(first + i, first + next, second + i, second + i, first + next, second + next);
    }
  }

  /** An antialiased line that faces the eye, with round ends if it is not closed. @param {Point[]} points */
  line(points) {
    this.#addLine(points, this.faces);
  }

  /** @param {Point[]} points @param {number[]} halo colour that keeps the line visible */
  lineOnHalo(points, halo) {
    this.line(points.map(({place, width, ink}) => ({place, width: width + 2 * haloOf(width), ink: {color: halo, opacity: ink.opacity}})));
    this.line(points);
  }

  /** @param {Point[]} points @param {number[]} faces */
  #addLine(points, faces) {
    let run = [];
    for (const point of points) {
      const clip = transformed(this.clipFromSpace, point.place);
      if (clip[3] > 1e-6 * Math.abs(clip[2])) {
        run.push({point, clip, x: (this.halfSize[0] * clip[0]) / clip[3], y: (this.halfSize[1] * clip[1]) / clip[3]});
      } else {
        this.#addRun(run, faces);
        run = [];
      }
    }
    this.#addRun(run, faces);
  }

  /** @param {{point: Point, clip: number[], x: number, y: number}[]} run @param {number[]} faces */
  #addRun(run, faces) {
    if (run.length === 0) return;
    const first = run[0], last = run[run.length - 1];
    const open = run.length === 1 || Math.hypot(first.x - last.x, first.y - last.y) > 1;
    let acrossX = 0, acrossY = 1, previous = null;
    for (let i = 0; i < run.length; ++i) {
      const here = run[i], before = run[Math.max(i - 1, 0)], after = run[Math.min(i + 1, run.length - 1)];
      if (previous && i + 1 < run.length && Math.hypot(here.x - previous.x, here.y - previous.y) < 0.5) continue;
      const x = after.x - before.x, y = after.y - before.y, length = Math.hypot(x, y);
      const oldX = acrossX, oldY = acrossY;
      if (length > 1e-3) [acrossX, acrossY] = [-y / length, x / length];
      if (!previous) {
        if (open) this.#addSides(here, acrossX, acrossY, -1);
      } else if (oldX * acrossX + oldY * acrossY < 0.5) {  // its two sides would cross
        this.#addSides(previous, oldX, oldY, 1);
        this.#joinSides(faces);
        this.#addSides(previous, acrossX, acrossY, 0);
      }
      this.#addSides(here, acrossX, acrossY, 0);
      if (open || previous) this.#joinSides(faces);
      previous = here;
    }
    if (open) {
      this.#addSides(last, acrossX, acrossY, 1);
      this.#joinSides(faces);
    }
  }

  /**
   * The two sides of a line at a point, or half its width beyond it (1) or before it (-1).
   * @param {{point: Point, clip: number[]}} here @param {number} acrossX @param {number} acrossY @param {number} beyond
   */
  #addSides({point, clip}, acrossX, acrossY, beyond) {
    const half = 0.5 * Math.max(point.width, 1), reach = half + 1;
    const ink = {color: point.ink.color, opacity: point.ink.opacity * Math.min(point.width, 1)};
    for (const side of [1, -1]) {
      const x = reach * (side * acrossX + beyond * acrossY), y = reach * (side * acrossY - beyond * acrossX);
      const corner = [clip[0] + (clip[3] * x) / this.halfSize[0], clip[1] + (clip[3] * y) / this.halfSize[1], clip[2], clip[3]];
      this.#add(corner, ink, [side * reach, reach * Math.abs(beyond), half]);
    }
  }

  /** Joins the last two pairs of sides. @param {number[]} faces */
  #joinSides(faces) {
    const n = this.count;
    faces.push(n - 4, n - 3, n - 2, n - 2, n - 3, n - 1);
  }

  /** @param {Vec3} place @param {number} radius in pixels @param {Ink} ink */
  dot(place, radius, ink) {
    const clip = transformed(this.clipFromSpace, place);
    if (!(clip[3] > 1e-6 * Math.abs(clip[2]))) return;
    const r = radius + 1, n = this.count;
    for (const [x, y] of [[-1, -1], [1, -1], [-1, 1], [1, 1]]) {
      const corner = [clip[0] + (r * clip[3] * x) / this.halfSize[0], clip[1] + (r * clip[3] * y) / this.halfSize[1], clip[2], clip[3]];
      this.#add(corner, ink, [r * x, r * y, radius]);
    }
    this.faces.push(n, n + 1, n + 2, n + 2, n + 1, n + 3);
  }

  /**
   * An opaque, shaded and outlined arrow with a shaft of that radius; one shorter than its head
   * consists of the head only.
   * @param {Vec3} from @param {Vec3} to @param {number} radius @param {number[]} color
   */
  arrow(from, to, radius, color) {
    const way = subtract(to, from), length = norm(way);
    if (!(length > 0)) return;
    const share = Math.min(1, length / (headLength * radius));
    const head = headLength * radius * share, shaft = length - head;
    const frame = frameWithZAlong(way), ink = {color, opacity: 1};
    const stem = {frame, from: [from[0], from[1], from[2]], length: shaft, base: radius, top: radius, ink, around: aroundArrow, shaded: true};
    const tip = {frame, from: add(from, scale(shaft, column(frame, 2))), length: head,
      base: headRadius * radius * share, top: 0, ink, around: aroundArrow, shaded: true};
    if (shaft > 0) this.#side(stem, this.faces);
    this.#side(tip, this.faces);
    this.#base(tip, this.faces);
    const size = this.pixels(tip.from);
    if (!(size > 0)) return;
    const outline = {color: contrasting(color), opacity: outlineOpacity};
    const width = share * Math.max(outlineWidth * radius, leastOutline / size);
    if (shaft > 0) this.#side(grown(stem, width, outline), this.outlines);
    this.#side(grown(tip, width, outline), this.outlines);
    this.#base(grown(tip, width, outline), this.outlines);
    this.#addGhost(stem, tip);
  }

  /** A plainer arrow, for what is hidden of it. @param {Cone} stem @param {Cone} tip */
  #addGhost(stem, tip) {
    const point = (/** @type {number} */ along) => {
      const axis = add(stem.from, scale(along, column(stem.frame, 2)));
      const place = add(axis, scale(stem.base, normalized(subtract(this.eye, axis))));
      return {place, width: Math.max(2 * stem.base * this.pixels(place) - 1, 0), ink: stem.ink};
    };
    if (stem.length > stem.base) this.#addLine([point(0), point(stem.length - stem.base)], this.ghosts);
    const plain = {...tip, around: aroundGhost};
    this.#side(plain, this.ghosts);
    this.#base(plain, this.ghosts);
  }

  /** @param {Cone} cone @param {number} angle @param {number} height @param {number} radius */
  #on(cone, angle, height, radius) {
    return add(cone.from, times(cone.frame, [radius * Math.cos(angle), radius * Math.sin(angle), height]));
  }

  /** @param {Cone} cone @param {number[]} place @param {number[]} normal */
  #addOn(cone, place, normal) {
    return cone.shaded ? this.#addLit(place, normal, cone.ink) : this.#add(transformed(this.clipFromSpace, place), cone.ink, noEdge);
  }

  /** @param {Cone} cone @param {number[]} faces */
  #side(cone, faces) {
    const first = this.count;
    for (const [height, radius] of [[0, cone.base], [cone.length, cone.top]]) {
      for (let i = 0; i < cone.around; ++i) {
        const angle = (2 * Math.PI * i) / cone.around;
        const normal = normalized([cone.length * Math.cos(angle), cone.length * Math.sin(angle), cone.base - cone.top]);
        this.#addOn(cone, this.#on(cone, angle, height, radius), times(cone.frame, normal));
      }
    }
    this.#band(first, first + cone.around, cone.around, faces);
  }

  /** @param {Cone} cone @param {number[]} faces */
  #base(cone, faces) {
    const outward = scale(-1, column(cone.frame, 2));
    const middle = this.#addOn(cone, cone.from, outward);
    for (let i = 0; i < cone.around; ++i) {
      this.#addOn(cone, this.#on(cone, (2 * Math.PI * i) / cone.around, 0, cone.base), outward);
      faces.push(middle, middle + 1 + ((i + 1) % cone.around), middle + 1 + i);
    }
  }

  /**
   * A flat disc whose colour changes from `middle` to `rim`.
   * @param {Vec3} centre @param {Vec3} normal @param {number} radius @param {Ink} middle @param {Ink} rim
   */
  disc(centre, normal, radius, middle, rim) {
    const frame = frameWithZAlong(normal);
    const hub = this.#add(transformed(this.clipFromSpace, centre), middle, noEdge);
    for (let i = 0; i < aroundDisc; ++i) {
      const angle = (2 * Math.PI * i) / aroundDisc;
      const place = add(centre, times(frame, [radius * Math.cos(angle), radius * Math.sin(angle), 0]));
      this.#add(transformed(this.clipFromSpace, place), rim, noEdge);
      this.faces.push(hub, hub + 1 + i, hub + 1 + ((i + 1) % aroundDisc));
    }
  }

  /**
   * The near side of the ellipsoid that `spaceFromUnit` maps the unit sphere to, as a glass shell:
   * its opacity rises to `rim` at the silhouette, and `ground` is behind it.
   * @param {number[]} spaceFromUnit @param {Ink} ink @param {number} rim @param {Ink} ground
   */
  ellipsoid(spaceFromUnit, ink, rim, ground) {
    const unitFromSpace = inverse(spaceFromUnit);
    const eye = times(unitFromSpace, this.eye), distance = norm(eye);
    if (!(distance > 1)) return;
    const frame = frameWithZAlong(eye), normalFromUnit = transposed(unitFromSpace);
    const size = Math.hypot(...spaceFromUnit) * this.pixels([0, 0, 0]);
    const rings = Math.round(clamp(1.1 * Math.sqrt(size), 8, 32)), around = 4 * rings;
    const first = this.count;
    for (let i = 0; i <= rings; ++i) {
      const fromPole = (Math.acos(1 / distance) * i) / rings;
      for (let j = 0; j < around; ++j) {
        const longitude = (2 * Math.PI * j) / around;
        const unit = times(frame, [Math.sin(fromPole) * Math.cos(longitude), Math.sin(fromPole) * Math.sin(longitude), Math.cos(fromPole)]);
        const normal = normalized(times(normalFromUnit, unit)), place = times(spaceFromUnit, unit);
        const facing = clamp(dot(normal, normalized(subtract(this.eye, place))), 0, 1);
        this.#addLit(place, normal, {color: ink.color, opacity: ink.opacity + (rim - ink.opacity) * (1 - facing) ** 3}, ground);
      }
      if (i > 0) this.#band(first + i * around, first + (i - 1) * around, around, this.faces);
    }
  }
}

export {floatsOfVertex};
