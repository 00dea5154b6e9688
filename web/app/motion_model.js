// The motion that is shown, with the data that several views need, computed once.
import { add, clamp, column, norm, scale } from '../math/linear.js';

/** @import { Motion } from '../core/core.js' */
/** @import { State } from './types' */

const radiansOfTrail = 12; // rotation of the body in the time that a trail covers

export class MotionModel {
  /**
   * @param {Motion} motion
   * @param {number} [trailLength] s; default: the time of a rotation by 12 rad
   */
  constructor(motion, trailLength) {
    const { facts, omega } = motion;
    this.motion = motion;
    this.omega = omega;
    this.facts = facts;
    this.atRest = norm(facts.momentum) === 0;
    const rate = norm(omega) || facts.rate;
    this.trailLength = trailLength ?? (rate > 0 ? radiansOfTrail / rate : 1);
  }

  /** Flips up to the time t, from 0. @param {number} t */
  flipsUntil(t) {
    return this.facts.turnsOver ? this.motion.flipsUntil(t) : 0;
  }

  /** @param {number} t @returns {number | null} */
  nextFlip(t) {
    return this.facts.turnsOver ? this.motion.nextFlip(t) : null;
  }

  /** @param {number} t @returns {number | null} */
  previousFlip(t) {
    return this.facts.turnsOver ? this.motion.previousFlip(t) : null;
  }

  /** The energy at t as a fraction of that at 0. @param {number} t */
  energyLeft(t) {
    return this.motion.diagnose(this.motion.samples([t])).energy[0] / (this.facts.energy || 1);
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
 * The motion as the command line shown on the page computes it: the one shown, or that of the first
 * of the compared methods. Throws a CoreError if that method cannot compute it.
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
