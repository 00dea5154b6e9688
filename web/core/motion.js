/** One motion: exact at any t, and as methods step along it. */
/** @typedef {import('./core.js').Core} Core */
/** @typedef {import('./core.js').Diagnostics} Diagnostics */
/** @typedef {import('./core.js').Facts} Facts */
/** @typedef {import('./core.js').Kind} Kind */
/** @typedef {import('./core.js').Matrix} Matrix */
/** @typedef {import('./core.js').Sample} Sample */
/** @typedef {import('./core.js').Samples} Samples */
/** @typedef {import('./core.js').StepControl} StepControl */
/** @typedef {import('./core.js').Vector} Vector */
/** @typedef {import('./instance.js').Instance} Instance */

const kinds = /** @type {Kind[]} */ (['steady', 'about_least', 'about_greatest', 'separatrix']);

/** @param {Float64Array} numbers @param {number} from @returns {Vector} */
export const vector = (numbers, from) => [numbers[from], numbers[from + 1], numbers[from + 2]];

/** @param {Float64Array} numbers @param {number} from @returns {Matrix} */
export const matrix = (numbers, from) => [...numbers.subarray(from, from + 9)];

/** Something in C++ that is made again when the instance was replaced. */
export class Held {
  /** @param {Instance} instance @param {() => number} make @param {string} free */
  constructor(instance, make, free) {
    this.instance = instance;
    this.make = make;
    this.free = free;
    this.pointer = make();
    this.generation = instance.generation;
  }

  /** The pointer to it. */
  get() {
    this.instance.revive();
    if (this.generation !== this.instance.generation) {
      this.pointer = this.make();
      this.generation = this.instance.generation;
    }
    return this.pointer;
  }

  release() {
    if (this.generation === this.instance.generation) this.instance.call(this.free, this.pointer);
    this.generation = -1;
  }
}

/** A motion; release() gives its memory back. */
export class Motion {
  /** @param {Core} core @param {readonly number[]} inertia @param {readonly number[]} omega */
  constructor(core, inertia, omega) {
    const { instance } = core;
    this.core = core;
    this.inertia = [...inertia];
    this.omega = [...omega];
    /** @type {Held} */
    this.held = new Held(
      instance,
      () => {
        instance.scratch(12).set([...inertia, ...omega]);
        return instance.call('motion_new');
      },
      'motion_free',
    );
    /** @type {Facts} */
    this.facts = this.#facts();
  }

  #facts() {
    const r = this.core.instance.compute(22, [], 'motion_facts', this.held.get());
    const moments = vector(r, 4);
    const flips = {
      interval: r[18],
      first: r[19],
      asymptoticInterval: r[20],
      swing: r[21],
      turnsOver: r[21] >= Math.PI / 2,
    };
    return {
      kind: kinds[r[16]],
      momentum: vector(r, 0),
      energy: r[3],
      moments,
      axes: matrix(r, 7),
      flips: r[17] ? flips : null,
      isReal: moments[2] <= (moments[0] + moments[1]) * (1 + 1e-12),
    };
  }

  /** The exact motion at t s, of either sign. @param {number} t @returns {Sample} */
  at(t) {
    const { X, omega } = this.samples([t]);
    return { t, X: [...X], omega: vector(omega, 0) };
  }

  /** The exact motion at times of either sign and in any order, s. @param {ArrayLike<number>} times */
  samples(times) {
    return samplesOf(this.core.instance, times, 'motion_samples', this.held.get());
  }

  /**
   * The motion as a method computes it, at exactly these times: what `twrench simulate --times` runs.
   * Throws, for instance, where the step is longer than a turn of the body.
   * @param {string} method
   * @param {StepControl} control
   * @param {ArrayLike<number>} times s, in any order and of either sign
   * @param {number} [mostSteps]
   */
  integrate(method, control, times, mostSteps = 5e6) {
    const { core } = this;
    const index = core.methods.indexOf(core.method(method));
    const { step, tolerance } = control;
    return samplesOf(
      core.instance, times, 'motion_integrate', this.held.get(), index, step, tolerance, mostSteps,
    );
  }

  /** How far samples are from the exact motion. @param {Samples} samples @returns {Diagnostics} */
  diagnose(samples) {
    const n = samples.t.length;
    const numbers = new Float64Array(13 * n);
    numbers.set(samples.t);
    numbers.set(samples.X, n);
    numbers.set(samples.omega, 10 * n);
    const r = this.core.instance.compute(5 * n, numbers, 'motion_diagnose', this.held.get(), n);
    return {
      energy: r.slice(0, n),
      energyDrift: r.slice(n, 2 * n),
      orthogonalityError: r.slice(2 * n, 3 * n),
      momentumError: r.slice(3 * n, 4 * n),
      error: r.slice(4 * n),
    };
  }

  /**
   * The instants of the flips with from < t <= to, s, both of either sign: at most the first `most`.
   * @param {number} from @param {number} to @param {number} [most]
   */
  flipTimes(from, to, most = 1000) {
    const { flips } = this.facts;
    /** @type {number[]} */
    const times = [];
    if (!flips || !Number.isFinite(flips.first)) return times;
    const { first, interval } = flips;
    if (!Number.isFinite(interval)) return from < first && first <= to ? [first] : times;
    let n = Math.floor((from - first) / interval);
    if (!Number.isSafeInteger(n)) return times;  // two flips are not two numbers there
    for (; times.length < most; ++n) {
      const t = first + n * interval;
      if (t > to) break;
      if (t > from) times.push(t);
    }
    return times;
  }

  /** The first flip after t, s; null if there is none. @param {number} t @returns {number | null} */
  nextFlip(t) {
    return this.flipTimes(t, Infinity, 1)[0] ?? null;
  }

  /** The last flip before t, s, also before 0; null if there is none. @param {number} t */
  previousFlip(t) {
    const { flips } = this.facts;
    if (!flips || !Number.isFinite(flips.first)) return null;
    const { first, interval } = flips;
    if (!Number.isFinite(interval)) return first < t ? first : null;
    let n = Math.ceil((t - first) / interval);
    if (!Number.isSafeInteger(n)) return null;
    while (first + n * interval >= t) --n;
    return first + n * interval;
  }

  /**
   * A method that goes along the motion, forward from t = 0, and remembers its steps.
   * @param {string} method @param {StepControl} control
   */
  run(method, control) {
    return new Run(this, method, control);
  }

  release() {
    this.held.release();
  }
}

/** A method under way. It throws where the method cannot go on; what was computed can still be seen. */
export class Run {
  /** @param {Motion} motion @param {string} method @param {StepControl} control */
  constructor(motion, method, control) {
    const { instance } = motion.core;
    this.motion = motion;
    this.method = motion.core.method(method);
    this.control = { ...control };
    /** @type {Held} */
    this.held = new Held(
      instance,
      () =>
        instance.call(
          'run_new',
          motion.held.get(),
          motion.core.methods.indexOf(this.method),
          control.step,
          control.tolerance,
        ),
      'run_free',
    );
  }

  /**
   * Goes on until t or for `steps` steps, whichever comes first, and returns the time reached, s:
   * for a page that must not be held up. Keeps at most half a million steps, and throws beyond.
   * @param {number} t @param {number} [steps]
   */
  advance(t, steps = 20000) {
    return this.motion.core.instance.call('run_advance', this.held.get(), t, steps);
  }

  /** The time reached, s. */
  get reached() {
    return this.motion.core.instance.call('run_reached', this.held.get());
  }

  /** The number of steps so far, rejected ones too. */
  get steps() {
    return this.motion.core.instance.call('run_steps', this.held.get());
  }

  /** Evaluations of omega so far. */
  get evaluations() {
    return this.motion.core.instance.call('run_evaluations', this.held.get());
  }

  /** @param {number} t s, >= 0; goes on until there if need be @returns {Sample} */
  at(t) {
    const { X, omega } = this.samples([t]);
    return { t, X: [...X], omega: vector(omega, 0) };
  }

  /** @param {ArrayLike<number>} times s, >= 0, in any order; goes on until the last if need be */
  samples(times) {
    return samplesOf(this.motion.core.instance, times, 'run_samples', this.held.get());
  }

  /** The instants of the flips in the method's own solution so far, s. @returns {Float64Array} */
  flipTimes() {
    const { instance } = this.motion.core;
    const count = instance.call('run_flips', this.held.get());
    return instance.scratch(count).slice();
  }

  release() {
    this.held.release();
  }
}

/**
 * @param {Instance} instance @param {ArrayLike<number>} times @param {string} name
 * @param {number} pointer @param {number[]} values
 * @returns {Samples}
 */
function samplesOf(instance, times, name, pointer, ...values) {
  const n = times.length;
  const r = instance.compute(12 * n, times, name, pointer, n, ...values);
  return { t: Float64Array.from(times), X: r.slice(0, 9 * n), omega: r.slice(9 * n) };
}
