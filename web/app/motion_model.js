// The motion that is shown, with what the views need of it, computed once.
import { add, clamp, column, norm, scale, transposed } from '../math/linear.js';
import { brief } from '../words/words.js';

/** @typedef {import("../core/core.js").Core} Core */
/** @typedef {import("../core/core.js").Sample} Sample */

const radiansOfTrail = 12; // how far the body rotates in the time that a trail covers
const along = 1 - 1e-9;

/**
 * The body's principal axes as the momentum views show them, least moment first: each with its
 * largest component positive, so that they are left-handed as often as not.
 * @typedef {object} PrincipalFrame
 * @property {number[]} axes body_from_own
 * @property {string[]} names
 * @property {number[]} moments
 */

/** @param {number[]} axes @param {number[]} moments @returns {PrincipalFrame} */
function principalFrame(axes, moments) {
  const columns = [0, 1, 2].map((i) => column(axes, i));
  const largest = columns.map((axis) =>
    axis.reduce((best, x, i) => (Math.abs(x) > Math.abs(axis[best]) ? i : best), 0),
  );
  const own = columns.every((axis, i) => Math.abs(axis[largest[i]]) > along);
  const positive = columns.map((axis, i) => (axis[largest[i]] < 0 ? scale(-1, axis) : axis));
  return {
    axes: transposed(positive.flat()),
    names: own ? largest.map((i) => 'xyz'[i]) : ['I₁', 'I₂', 'I₃'],
    moments,
  };
}

export class MotionModel {
  /**
   * @param {Core} core @param {number[]} inertia 9 numbers, g cm^2 @param {number[]} omega rad/s
   * @param {number} [trailLength] s; by default that of a rotation by 12 rad
   */
  constructor(core, inertia, omega, trailLength) {
    this.motion = core.motion(inertia, omega);
    this.omega = omega;
    const { facts } = this.motion;
    this.facts = facts;
    this.momentum = norm(facts.momentum);
    this.atRest = this.momentum === 0;
    this.principal = principalFrame(facts.axes, facts.moments);
    this.flips = facts.flips && facts.flips.turnsOver ? facts.flips : null;
    const rate = norm(omega);
    this.trailLength = trailLength ?? (rate > 0 ? radiansOfTrail / rate : 1);
  }

  /** Flips up to the time t, from 0. @param {number} t */
  flipsUntil(t) {
    if (!this.flips || !Number.isFinite(this.flips.first) || t < this.flips.first) return 0;
    if (!Number.isFinite(this.flips.interval)) return 1;
    return 1 + Math.floor((t - this.flips.first) / this.flips.interval);
  }

  /** @param {number} t @returns {number | null} */
  nextFlip(t) {
    return this.flips ? this.motion.nextFlip(t) : null;
  }

  /** @param {number} t @returns {number | null} */
  previousFlip(t) {
    return this.flips ? this.motion.previousFlip(t) : null;
  }

  release() {
    this.motion.release();
  }
}

/**
 * The angular velocity about a principal axis, as fast as the motion is, with a push to the side.
 * @param {MotionModel} model @param {number} i Index of the axis, least moment first.
 * @param {number} push As a share of the rate.
 */
export function spunAbout({ principal, omega }, i, push) {
  const rate = norm(omega) || 1;
  const axis = column(principal.axes, i),
    side = column(principal.axes, i === 0 ? 1 : 0);
  return add(scale(rate, axis), scale(push * rate, side)).map((x) => Number(x.toPrecision(6)));
}

/**
 * What the tour says of a motion in numbers.
 * @param {MotionModel} model
 * @returns {Record<string, string>}
 */
export function figuresOf({ facts, omega }) {
  const [least, middle, greatest] = facts.moments;
  const rate = norm(omega) * Math.sqrt(((greatest - middle) * (middle - least)) / (least * greatest));
  return {
    interval: brief(facts.flips?.interval ?? Infinity),
    first: brief(facts.flips?.first ?? Infinity),
    doubling: brief(Math.LN2 / rate),
    moments: facts.moments.map((moment) => brief(moment)).join(', '),
  };
}

/**
 * Evenly spaced times of a trail that ends at t and begins no earlier than 0, about 0.03 rad apart.
 * @param {number} t @param {number} length s @param {number} rate rad/s
 */
export function trailTimes(t, length, rate) {
  const points = clamp(Math.ceil((length * rate) / 0.03), 50, 600);
  const step = length / points;
  const first = Math.max(0, Math.ceil((t - length) / step));
  const times = Array.from({ length: points + 1 }, (_, i) => (first + i) * step);
  return [...times.filter((time) => time < t), t];
}

/**
 * The motion as the command line that the page gives has it computed: exactly, or by the first of
 * the methods that are compared. Throws a CoreError where that method cannot.
 * @param {import("./state.js").State} state @param {MotionModel} model @param {number[]} times
 */
export function samplesShown({ compare, methods, step, tolerance }, { motion }, times) {
  return compare === 'off'
    ? motion.samples(times)
    : motion.integrate(methods[0], { step, tolerance }, times);
}

/**
 * The samples of a trail as objects.
 * @param {import("../core/core.js").Samples} samples
 * @returns {Sample[]}
 */
export function listed(samples) {
  const list = [];
  for (let i = 0; i < samples.t.length; ++i) {
    const o = samples.omega;
    list.push({
      t: samples.t[i],
      X: Array.from(samples.X.subarray(9 * i, 9 * i + 9)),
      omega: /** @type {[number, number, number]} */ ([o[3 * i], o[3 * i + 1], o[3 * i + 2]]),
    });
  }
  return list;
}
