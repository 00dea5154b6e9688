// Plain surfaces of a draw list: discs, and ellipsoids of glass.
import {
  add,
  clamp,
  dot,
  frameWithZAlong,
  inverse,
  norm,
  normalized,
  subtract,
  times,
  transposed,
} from '../math/linear.js';
import { transformed } from '../math/camera.js';
import { band, noEdge } from './draw_list.js';

/** @typedef {import("../math/linear.js").Vec3} Vec3 */
/** @typedef {import("./draw_list.js").DrawList} DrawList */
/** @typedef {import("./draw_list.js").Ink} Ink */

const aroundDisc = 96;

/**
 * Adds a flat disc whose colour changes from `middle` to `rim`.
 * @param {DrawList} list @param {Vec3} centre @param {Vec3} normal @param {number} radius @param {Ink} middle @param {Ink} rim
 */
export function addDisc(list, centre, normal, radius, middle, rim) {
  const frame = frameWithZAlong(normal);
  const hub = list.add(transformed(list.clipFromSpace, centre), middle, noEdge);
  for (let i = 0; i < aroundDisc; ++i) {
    const angle = (2 * Math.PI * i) / aroundDisc;
    const place = add(centre, times(frame, [radius * Math.cos(angle), radius * Math.sin(angle), 0]));
    list.add(transformed(list.clipFromSpace, place), rim, noEdge);
    list.faces.push(hub, hub + 1 + i, hub + 1 + ((i + 1) % aroundDisc));
  }
}

/**
 * Adds the near side of the ellipsoid that `spaceFromUnit` maps the unit sphere to, as a glass shell:
 * its opacity rises to `rim` at the silhouette, and `ground` is behind it.
 * @param {DrawList} list @param {number[]} spaceFromUnit @param {Ink} ink @param {number} rim @param {Ink} ground
 */
export function addEllipsoid(list, spaceFromUnit, ink, rim, ground) {
  const unitFromSpace = inverse(spaceFromUnit);
  const eye = times(unitFromSpace, list.eye),
    distance = norm(eye);
  if (!(distance > 1)) return;
  const frame = frameWithZAlong(eye),
    normalFromUnit = transposed(unitFromSpace);
  const size = Math.hypot(...spaceFromUnit) * list.pixels([0, 0, 0]);
  const rings = Math.round(clamp(1.1 * Math.sqrt(size), 8, 32)),
    around = 4 * rings;
  const first = list.count;
  for (let i = 0; i <= rings; ++i) {
    const fromPole = (Math.acos(1 / distance) * i) / rings;
    for (let j = 0; j < around; ++j) {
      const longitude = (2 * Math.PI * j) / around;
      const unit = times(frame, [
        Math.sin(fromPole) * Math.cos(longitude),
        Math.sin(fromPole) * Math.sin(longitude),
        Math.cos(fromPole),
      ]);
      const normal = normalized(times(normalFromUnit, unit)),
        place = times(spaceFromUnit, unit);
      const facing = clamp(dot(normal, normalized(subtract(list.eye, place))), 0, 1);
      list.addLit(
        place,
        normal,
        { color: ink.color, opacity: ink.opacity + (rim - ink.opacity) * (1 - facing) ** 3 },
        ground,
      );
    }
    if (i > 0) band(first + i * around, first + (i - 1) * around, around, list.faces);
  }
}
