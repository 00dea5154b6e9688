// The body of the article's figures, and the motions in which they show it.
import { diagonal } from '../core/core.js';
import { MotionModel, spunAbout } from '../app/motion_model.js';
import { add, column, cross, dot, norm, scale } from '../math/linear.js';

/** @import { Core } from '../core/core.js' */
/** @import { Interior, Matrix } from '../core/types' */
/** @import { PageData } from '../app/types' */

const usualPush = 0.05; // deviation from the axis, as a fraction of the angular velocity
const threeMoments = [700, 1000, 1500]; // g cm^2, of a box that replaces a body with nearly equal moments
const leastDifference = 0.01; // of two moments, as a fraction of the greatest

/** Whether two moments of the scene's body differ too little for the article's figures. @param {Core} core @param {PageData} data */
export function isReplaced(core, { inertia, scene }) {
  const motion = core.motion(inertia, scene.motion.omega),
    [least, middle, greatest] = motion.facts.moments;
  motion.release();
  return Math.min(middle - least, greatest - middle) < leastDifference * greatest;
}

/** The index of an axis, least moment first. @typedef {0 | 1 | 2} Axis */

export class Body {
  /** @param {Core} core @param {PageData} data @param {boolean} asBox Whether a box replaces the scene's body. */
  constructor(core, data, asBox) {
    this.core = core;
    this.trailLength = data.scene.overlay.trail_length;
    /** @type {number[] | null} */
    this.moments = asBox ? threeMoments : null;
    const { omega } = data.scene.motion;
    this.inertia = data.inertia;
    const scene = this.model(omega);
    if (asBox) this.inertia = diagonal(threeMoments);
    // The rate about the axis about which the scene's body mainly spins.
    const along = [0, 1, 2].map((i) => Math.abs(dot(column(scene.facts.axes, i), omega)));
    this.rate = Math.max(...along) || 1;
    scene.release();
    this.own = this.model([this.rate, 0, 0]);
    this.facts = this.own.facts;
    const flipping = this.model(this.spun(1, usualPush));
    /** The time between flips after the usual push, s. */
    this.interval = flipping.facts.flips?.interval ?? 1;
    flipping.release();
  }

  /** @param {number[]} omega rad/s, body axes @param {Interior} [interior] @param {Matrix} [attitude] */
  model(omega, interior, attitude) {
    return new MotionModel(this.core.motion(this.inertia, omega, interior, attitude), this.trailLength);
  }

  /** A wheel along the rotation about the middle axis. @param {number} momentum g cm^2/s @returns {Interior["wheel"]} */
  wheel(momentum) {
    const omega = this.spun(1, 0);
    return scale(momentum / norm(omega), omega);
  }

  /** The least wheel, g cm^2/s, that makes the rotation about the middle axis stable (docs/theory.md). */
  get holdingWheel() {
    const [, middle, greatest] = this.facts.moments;
    return (greatest - middle) * this.rate;
  }

  /**
   * The time constant of the energy loss, s. It is above the threshold of docs/theory.md, and so short that a
   * rotation about the axis of least moment ends soon.
   */
  get lossTime() {
    const [least, middle, greatest] = this.facts.moments,
      p = 1 / least - 1 / greatest,
      q = 1 / middle - 1 / greatest,
      threshold = (p - q) / ((p + q) * least * this.rate * Math.sqrt(p * q));
    return Math.max(this.interval / 5, 2 * threshold);
  }

  /** The angular velocity about an axis with a push to the side. @param {Axis} axis @param {number} push As a fraction of the rate. */
  spun(axis, push) {
    return spunAbout(this.own, axis, push);
  }

  /** The principal axis, in body axes; the three are right-handed. @param {number} i */
  axis(i) {
    const [least, middle] = [0, 1].map((k) => column(this.facts.axes, k));
    return [least, middle, cross(least, middle)][i];
  }

  /**
   * The angular velocity in a direction on the way from the axis of least moment over the middle one to
   * that of the greatest.
   * @param {number} angle rad, 0 to pi
   */
  between(angle) {
    const along = [Math.max(Math.cos(angle), 0), Math.sin(angle), Math.max(-Math.cos(angle), 0)];
    return this.#along(along.map((share) => this.rate * share));
  }

  /** The angular velocity for which the middle axis leans from L, in the direction in which the lean grows. @param {number} lean rad */
  leaning(lean) {
    const { direction } = this.tug,
      { moments } = this.facts,
      momentum = moments[1] * this.rate;
    const shares = [Math.sin(lean) * direction[0], Math.cos(lean), Math.sin(lean) * direction[2]];
    return this.#along(shares.map((share, i) => (momentum * share) / moments[i]));
  }

  /** The vector with these components along the principal axes. @param {number[]} components */
  #along(components) {
    return components.reduce((sum, value, i) => add(sum, scale(value, this.axis(i))), [0, 0, 0]);
  }

  /**
   * The tug-of-war about the middle axis: the direction of the growing lean along the principal axes, and
   * the sums of m r^2 along the axis of the spin and along this direction (T0' of docs/theory.md).
   */
  get tug() {
    const { moments } = this.facts,
      [least, middle, greatest] = moments,
      half = (least + middle + greatest) / 2;
    // With i the middle axis, j that of the greatest and k that of the least moment.
    const b = middle / least - 1,
      sigma = this.stability(1).rate / this.rate,
      length = Math.hypot(b, sigma);
    const direction = [sigma / length, 0, -b / length];
    return {
      direction,
      along: half - middle,
      across: direction[0] ** 2 * (half - least) + direction[2] ** 2 * (half - greatest),
    };
  }

  /** For each principal axis the index of the body axis with its colour, as on the momentum sphere. */
  get bodyAxes() {
    const sizes = [0, 1, 2].map((i) => column(this.facts.axes, i).map(Math.abs)),
      areOwn = sizes.every((size) => Math.max(...size) > 1 - 1e-9);
    return sizes.map((size, i) => (areOwn ? size.indexOf(Math.max(...size)) : i));
  }

  /** @param {Axis} axis */
  stability(axis) {
    return this.core.stability(this.facts.moments, axis, this.rate);
  }
}
