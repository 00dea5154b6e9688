// Runs the two compared methods along the motion, and computes their deviation from it.
import { recorded } from '../core/motion.js';
import { word } from '../words/words.js';
import { messageOf } from './dom.js';

/** @import { Recording, Run } from '../core/core.js' */
/** @import { MotionModel } from './motion_model.js' */
/** @import { State } from './types' */

const millisecondsOfFrame = 6; // that both methods together may use
const stepsAtOnce = 400;

/** The name of a method for the reader. @param {string} method */
export const nameOf = (method) => (method === recorded ? word('recorded') : method);

/** Runs a method. */
class Runner {
  /** @param {MotionModel} model @param {string} method @param {{step: number, tolerance: number}} control */
  constructor(model, method, control) {
    this.model = model;
    this.method = method;
    this.exact = method === 'exact';
    /** The error that stopped it. */
    this.failure = '';
    this.reached = 0;
    /** @type {Run | Recording | null} */
    this.run = null;
    try {
      if (!this.exact) this.run = model.motion.run(method, control);
    } catch (error) {
      this.failure = messageOf(error);
    }
  }

  /** Advances towards t until the deadline. @param {number} t s @param {number} deadline ms */
  advance(t, deadline) {
    if (!this.run || this.failure || this.reached >= t) return;
    try {
      do {
        this.reached = this.run.advance(t, stepsAtOnce);
      } while (this.reached < t && performance.now() < deadline);
    } catch (error) {
      this.failure = messageOf(error);
    }
  }

  /** Whether it has reached t. @param {number} t */
  knows(t) {
    return this.exact || (this.reached >= t && t >= 0);
  }

  /**
   * The samples at those of the times that it has reached.
   * @param {number[]} times ascending
   */
  samples(times) {
    if (!this.run) return this.model.motion.samples(this.exact ? times : [0]);
    const known = times.filter((time) => time >= 0 && this.knows(time));
    return this.run.samples(known.length ? known : [this.reached]);
  }

  /** The flips until t in the method's solution. @param {number} t */
  flipsUntil(t) {
    if (!this.run) return this.exact ? this.model.flipsUntil(t) : 0;
    return this.run.flipTimes().filter((time) => time <= t).length;
  }

  /** NaN if it has none. */
  get steps() {
    return this.exact ? NaN : (this.run?.steps ?? 0);
  }

  release() {
    this.run?.release();
  }
}

export class Runs {
  constructor() {
    /** @type {Runner[]} */
    this.runners = [];
    this.key = '';
  }

  /**
   * Restarts the methods of the state if something they depend on has changed.
   * @param {State} state @param {MotionModel} model
   */
  prepare({ compare, methods, step, tolerance }, model) {
    const key = compare === 'off' ? '' : [methods, step, tolerance].join();
    if (key === this.key && model === this.model) return;
    this.stop();
    this.key = key;
    this.model = model;
    if (key) this.runners = methods.map((method) => new Runner(model, method, { step, tolerance }));
  }

  /** Ends the methods; must be called before their motion is released. */
  stop() {
    for (const runner of this.runners) runner.release();
    this.runners = [];
    this.key = '';
  }

  /**
   * Advances the methods towards t.
   * @param {number} t
   * @returns {boolean} whether any of them still has to reach it
   */
  advance(t) {
    const start = performance.now();
    this.runners.forEach((runner, i) =>
      runner.advance(t, start + (millisecondsOfFrame * (i + 1)) / this.runners.length),
    );
    return this.runners.some((runner) => !runner.failure && !runner.knows(t));
  }
}
