// The motion that is shown, with the data that several views need, computed once.
import { add, clamp, column, norm, scale } from '../math/linear.js';
import { brief, duration } from '../words/words.js';

/** @import { Core } from '../core/core.js' */
/** @import { State } from './types' */

const radiansOfTrail = 12; // rotation of the body in the time that a trail covers

export class MotionModel {
  /**
   * @param {Core} core @param {number[]} inertia 9 numbers, g cm^2 @param {number[]} omega rad/s
   * @param {number} [trailLength] s; default: the time of a rotation by 12 rad
   */
  constructor(core, inertia, omega, trailLength) {
    this.motion = core.motion(inertia, omega);
    this.omega = omega;
    const { facts } = this.motion;
    this.facts = facts;
    this.atRest = norm(facts.momentum) === 0;
    this.flips = facts.flips?.turnsOver ? facts.flips : null;
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

/** A principal axis, its largest component positive. @param {MotionModel} model @param {number} i */
function principalAxis({ facts }, i) {
  const axis = column(facts.axes, i);
  const largest = axis.reduce((best, x) => (Math.abs(x) > Math.abs(best) ? x : best));
  return scale(largest < 0 ? -1 : 1, axis);
}

/**
 * An angular velocity about a principal axis with the same rate as the motion, and a push to the side.
 * @param {MotionModel} model @param {number} i Index of the axis, least moment first.
 * @param {number} push As a fraction of the rate.
 */
export function spunAbout(model, i, push) {
  const rate = norm(model.omega) || 1,
    side = principalAxis(model, i === 0 ? 1 : 0);
  const omega = add(scale(rate, principalAxis(model, i)), scale(push * rate, side));
  return omega.map((x) => Number(x.toPrecision(6)));
}

/**
 * The numbers of a motion that the tour's texts contain.
 * @param {MotionModel} model
 * @returns {Record<string, string>}
 */
export function figuresOf({ facts, omega }) {
  const [least, middle, greatest] = facts.moments;
  const rate = norm(omega) * Math.sqrt(((greatest - middle) * (middle - least)) / (least * greatest));
  return {
    interval: duration(facts.flips?.interval ?? Infinity),
    first: duration(facts.flips?.first ?? Infinity),
    doubling: duration(Math.LN2 / rate),
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
 * The motion as the command line shown on the page computes it: exactly, or by the first of the
 * compared methods. Throws a CoreError if that method cannot compute it.
 * @param {State} state @param {MotionModel} model @param {number[]} times
 */
export function samplesShown({ compare, methods, step, tolerance }, { motion }, times) {
  return compare === 'off'
    ? motion.samples(times)
    : motion.integrate(methods[0], { step, tolerance }, times);
}

/** Evenly spaced times, both ends included. @param {number} from @param {number} to @param {number} intervals */
export const evenly = (from, to, intervals) =>
  Array.from({ length: intervals + 1 }, (_, i) => from + ((to - from) * i) / intervals);
