// Lines and dots of a draw list, which face the eye: src/picture/overlay/draw_list_line.cpp.
import { transformed } from '../math/camera.js';

/** @typedef {import("../math/linear.js").Vec3} Vec3 */
/** @typedef {import("./draw_list.js").DrawList} DrawList */
/** @typedef {import("./draw_list.js").Ink} Ink */
/** @typedef {{place: Vec3, width: number, ink: Ink}} Point  of a line; width in pixels */

/** By how many pixels a halo reaches beyond something that is so many pixels wide. @param {number} width */
export const haloOf = (width) => Math.max(0.4 * width, 1);

/** Adds an antialiased line that faces the eye, with round ends if it is not closed. @param {DrawList} list @param {Point[]} points */
export function addLine(list, points) {
  addLineTo(list, points, list.faces);
}

/** Adds a line on a halo, which keeps it visible. @param {DrawList} list @param {Point[]} points @param {number[]} halo its colour */
export function addLineOnHalo(list, points, halo) {
  addLine(
    list,
    points.map(({ place, width, ink }) => ({
      place,
      width: width + 2 * haloOf(width),
      ink: { color: halo, opacity: ink.opacity },
    })),
  );
  addLine(list, points);
}

/** @param {DrawList} list @param {Point[]} points @param {number[]} faces the list's faces to add it to */
export function addLineTo(list, points, faces) {
  let run = [];
  for (const point of points) {
    const clip = transformed(list.clipFromSpace, point.place);
    if (clip[3] > 1e-6 * Math.abs(clip[2])) {
      run.push({
        point,
        clip,
        x: (list.halfSize[0] * clip[0]) / clip[3],
        y: (list.halfSize[1] * clip[1]) / clip[3],
      });
    } else {
      addRun(list, run, faces);
      run = [];
    }
  }
  addRun(list, run, faces);
}

/** @param {DrawList} list @param {{point: Point, clip: number[], x: number, y: number}[]} run @param {number[]} faces */
function addRun(list, run, faces) {
  if (run.length === 0) return;
  const first = run[0],
    last = run[run.length - 1];
  const open = run.length === 1 || Math.hypot(first.x - last.x, first.y - last.y) > 1;
  let acrossX = 0,
    acrossY = 1,
    previous = null;
  for (let i = 0; i < run.length; ++i) {
    const here = run[i],
      before = run[Math.max(i - 1, 0)],
      after = run[Math.min(i + 1, run.length - 1)];
    if (previous && i + 1 < run.length && Math.hypot(here.x - previous.x, here.y - previous.y) < 0.5)
      continue;
    const x = after.x - before.x,
      y = after.y - before.y,
      length = Math.hypot(x, y);
    const oldX = acrossX,
      oldY = acrossY;
    if (length > 1e-3) [acrossX, acrossY] = [-y / length, x / length];
    if (!previous) {
      if (open) addSides(list, here, acrossX, acrossY, -1);
    } else if (oldX * acrossX + oldY * acrossY < 0.5) {
      // its two sides would cross
      addSides(list, previous, oldX, oldY, 1);
      joinSides(list, faces);
      addSides(list, previous, acrossX, acrossY, 0);
    }
    addSides(list, here, acrossX, acrossY, 0);
    if (open || previous) joinSides(list, faces);
    previous = here;
  }
  if (open) {
    addSides(list, last, acrossX, acrossY, 1);
    joinSides(list, faces);
  }
}

/**
 * The two sides of a line at a point, or half its width beyond it (1) or before it (-1).
 * @param {DrawList} list @param {{point: Point, clip: number[]}} here @param {number} acrossX @param {number} acrossY @param {number} beyond
 */
function addSides(list, { point, clip }, acrossX, acrossY, beyond) {
  const half = 0.5 * Math.max(point.width, 1),
    reach = half + 1;
  const ink = { color: point.ink.color, opacity: point.ink.opacity * Math.min(point.width, 1) };
  for (const side of [1, -1]) {
    const x = reach * (side * acrossX + beyond * acrossY),
      y = reach * (side * acrossY - beyond * acrossX);
    const corner = [
      clip[0] + (clip[3] * x) / list.halfSize[0],
      clip[1] + (clip[3] * y) / list.halfSize[1],
      clip[2],
      clip[3],
    ];
    list.add(corner, ink, [side * reach, reach * Math.abs(beyond), half]);
  }
}

/** Joins the last two pairs of sides. @param {DrawList} list @param {number[]} faces */
function joinSides(list, faces) {
  const n = list.count;
  faces.push(n - 4, n - 3, n - 2, n - 2, n - 3, n - 1);
}

/** Adds an antialiased dot. @param {DrawList} list @param {Vec3} place @param {number} radius in pixels @param {Ink} ink */
export function addDot(list, place, radius, ink) {
  const clip = transformed(list.clipFromSpace, place);
  if (!(clip[3] > 1e-6 * Math.abs(clip[2]))) return;
  const r = radius + 1,
    n = list.count;
  for (const [x, y] of [
    [-1, -1],
    [1, -1],
    [-1, 1],
    [1, 1],
  ]) {
    const corner = [
      clip[0] + (r * clip[3] * x) / list.halfSize[0],
      clip[1] + (r * clip[3] * y) / list.halfSize[1],
      clip[2],
      clip[3],
    ];
    list.add(corner, ink, [r * x, r * y, radius]);
  }
  list.faces.push(n, n + 1, n + 2, n + 2, n + 1, n + 3);
}
