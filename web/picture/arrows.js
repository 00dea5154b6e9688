// Arrows of a draw list: src/picture/overlay/draw_list_arrow.cpp.
import { add, column, frameWithZAlong, norm, normalized, scale, subtract, times } from '../math/linear.js';
import { transformed } from '../math/camera.js';
import { band, noEdge } from './draw_list.js';
import { addLineTo } from './lines.js';

/** @typedef {import("../math/linear.js").Vec3} Vec3 */
/** @typedef {import("./draw_list.js").DrawList} DrawList */
/** @typedef {import("./draw_list.js").Ink} Ink */

// Of an arrow: the length of the head and the radius of its base in radii of the shaft; the outline.
const headLength = 5.5,
  headRadius = 2.4;
const outlineWidth = 0.3,
  leastOutline = 1,
  outlineOpacity = 0.9;
const aroundArrow = 28,
  aroundOutline = 16,
  aroundGhost = 10;

/** @param {number} value sRGB, 0 to 255 */
function linearFromSrgb(value) {
  const s = value / 255;
  return s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4;
}

/** Black or white, whichever has the higher contrast. @param {number[]} color */
function contrasting([red, green, blue]) {
  const luminance =
    0.2126 * linearFromSrgb(red) + 0.7152 * linearFromSrgb(green) + 0.0722 * linearFromSrgb(blue);
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
  const wider = (by * slant) / cone.length,
    slope = (by * (cone.base - cone.top)) / cone.length;
  return {
    frame: cone.frame,
    from: subtract(cone.from, scale(by, column(cone.frame, 2))),
    length: cone.length + 2 * by,
    base: cone.base + wider + slope,
    top: cone.top + wider - slope,
    ink,
    around: aroundOutline,
    shaded: false,
  };
}

/**
 * Adds an opaque, shaded and outlined arrow with a shaft of that radius; one shorter than its head
 * consists of the head only.
 * @param {DrawList} list @param {Vec3} from @param {Vec3} to @param {number} radius @param {number[]} color
 */
export function addArrow(list, from, to, radius, color) {
  const way = subtract(to, from),
    length = norm(way);
  if (!(length > 0)) return;
  const share = Math.min(1, length / (headLength * radius));
  const head = headLength * radius * share,
    shaft = length - head;
  const frame = frameWithZAlong(way),
    ink = { color, opacity: 1 };
  const stem = {
    frame,
    from: [from[0], from[1], from[2]],
    length: shaft,
    base: radius,
    top: radius,
    ink,
    around: aroundArrow,
    shaded: true,
  };
  const tip = {
    frame,
    from: add(from, scale(shaft, column(frame, 2))),
    length: head,
    base: headRadius * radius * share,
    top: 0,
    ink,
    around: aroundArrow,
    shaded: true,
  };
  if (shaft > 0) addSide(list, stem, list.faces);
  addSide(list, tip, list.faces);
  addBase(list, tip, list.faces);
  const size = list.pixels(tip.from);
  if (!(size > 0)) return;
  const outline = { color: contrasting(color), opacity: outlineOpacity };
  const width = share * Math.max(outlineWidth * radius, leastOutline / size);
  if (shaft > 0) addSide(list, grown(stem, width, outline), list.outlines);
  addSide(list, grown(tip, width, outline), list.outlines);
  addBase(list, grown(tip, width, outline), list.outlines);
  addGhost(list, stem, tip);
}

/** Adds a plainer arrow, for what is hidden of it. @param {DrawList} list @param {Cone} stem @param {Cone} tip */
function addGhost(list, stem, tip) {
  const point = (/** @type {number} */ along) => {
    const axis = add(stem.from, scale(along, column(stem.frame, 2)));
    const place = add(axis, scale(stem.base, normalized(subtract(list.eye, axis))));
    return { place, width: Math.max(2 * stem.base * list.pixels(place) - 1, 0), ink: stem.ink };
  };
  if (stem.length > stem.base) addLineTo(list, [point(0), point(stem.length - stem.base)], list.ghosts);
  const plain = { ...tip, around: aroundGhost };
  addSide(list, plain, list.ghosts);
  addBase(list, plain, list.ghosts);
}

/** @param {Cone} cone @param {number} angle @param {number} height @param {number} radius */
function on(cone, angle, height, radius) {
  return add(cone.from, times(cone.frame, [radius * Math.cos(angle), radius * Math.sin(angle), height]));
}

/** @param {DrawList} list @param {Cone} cone @param {number[]} place @param {number[]} normal */
function addOn(list, cone, place, normal) {
  return cone.shaded
    ? list.addLit(place, normal, cone.ink)
    : list.add(transformed(list.clipFromSpace, place), cone.ink, noEdge);
}

/** @param {DrawList} list @param {Cone} cone @param {number[]} faces */
function addSide(list, cone, faces) {
  const first = list.count;
  for (const [height, radius] of [
    [0, cone.base],
    [cone.length, cone.top],
  ]) {
    for (let i = 0; i < cone.around; ++i) {
      const angle = (2 * Math.PI * i) / cone.around;
      const normal = normalized([
        cone.length * Math.cos(angle),
        cone.length * Math.sin(angle),
        cone.base - cone.top,
      ]);
      addOn(list, cone, on(cone, angle, height, radius), times(cone.frame, normal));
    }
  }
  band(first, first + cone.around, cone.around, faces);
}

/** @param {DrawList} list @param {Cone} cone @param {number[]} faces */
function addBase(list, cone, faces) {
  const outward = scale(-1, column(cone.frame, 2));
  const middle = addOn(list, cone, cone.from, outward);
  for (let i = 0; i < cone.around; ++i) {
    addOn(list, cone, on(cone, (2 * Math.PI * i) / cone.around, 0, cone.base), outward);
    faces.push(middle, middle + 1 + ((i + 1) % cone.around), middle + 1 + i);
  }
}
