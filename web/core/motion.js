/** A motion: at any t, or integrated by a method. */
/** @import { Core } from './core.js' */
/** @import { Diagnostics, Facts, Interior, Kind, Matrix, RecordedRows, Sample, Samples, StepControl, Vector } from './types' */
/** @import { Instance } from './instance.js' */

const kinds = /** @type {Kind[]} */ (['steady', 'about_least', 'about_greatest', 'separatrix']);

/** @param {Float64Array} numbers @param {number} from @returns {Vector} */
export const vector = (numbers, from) => [numbers[from], numbers[from + 1], numbers[from + 2]];

/** @param {Float64Array} numbers @param {number} from @returns {Matrix} */
export const matrix = (numbers, from) => [...numbers.subarray(from, from + 9)];

/** A C++ object that is created again after the instance was replaced. */
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

/** The sample at the first time. @param {Samples} samples @returns {Sample} */
export const firstOf = ({ t, X, omega }) => ({ t: t[0], X: matrix(X, 0), omega: vector(omega, 0) });

/** A motion or a run in C++; release() frees its memory. */
class Sampled {
  /** @param {Instance} instance @param {() => number} make @param {"motion" | "run" | "recording"} kind */
  constructor(instance, make, kind) {
    this.instance = instance;
    this.kind = kind;
    this.held = new Held(instance, make, `${kind}_free`);
  }

  /** Calls a C++ function with this object. @param {string} name @param {number[]} values */
  call(name, ...values) {
    return this.instance.call(`${this.kind}_${name}`, this.held.get(), ...values);
  }

  /** The sample at t s. @param {number} t */
  at(t) {
    return firstOf(this.samples([t]));
  }

  /**
   * The samples at times in any order, s. A motion in closed form has them also before 0; a run
   * advances to the last time if necessary.
   * @param {ArrayLike<number>} times
   */
  samples(times) {
    return this.compute('samples', times);
  }

  /** @param {string} name @param {ArrayLike<number>} times @param {number[]} values @returns {Samples} */
  compute(name, times, ...values) {
    const n = times.length,
      pointer = this.held.get();
    const r = this.instance.compute(12 * n, times, `${this.kind}_${name}`, pointer, n, ...values);
    return { t: Float64Array.from(times), X: r.slice(0, 9 * n), omega: r.slice(9 * n) };
  }

  release() {
    this.held.release();
  }
}

export class Motion extends Sampled {
  /**
   * @param {Core} core @param {readonly number[]} inertia @param {readonly number[]} omega @param {Interior} interior
   * @param {Matrix} attitude X(0)
   */
  constructor(core, inertia, omega, { wheel, energyLossTime }, attitude) {
    const { instance } = core,
      numbers = [...inertia, ...omega, ...wheel, energyLossTime, ...attitude];
    super(instance, () => instance.callWith(numbers, 'motion_new'), 'motion');
    this.core = core;
    this.inertia = [...inertia];
    this.omega = [...omega];
    this.interior = { wheel, energyLossTime };
    /** @type {Facts} */
    this.facts = this.#facts(Number.isFinite(energyLossTime));
  }

  /** @param {boolean} losesEnergy @returns {Facts} */
  #facts(losesEnergy) {
    const r = this.instance.compute(27, [], 'motion_facts', this.held.get());
    const moments = vector(r, 4);
    const common = {
      momentum: vector(r, 0),
      energy: r[3],
      moments,
      axes: matrix(r, 7),
      isReal: moments[2] <= (moments[0] + moments[1]) * (1 + 1e-12),
      losesEnergy,
    };
    if (!r[16]) {
      const [longest, rate, turnsOver] = r.slice(17, 20);
      return { ...common, kind: null, longest, rate, flips: null, phase: null, turnsOver: turnsOver > 0 };
    }
    const [kind, period, total, dynamic, hasFlips, interval, first, asymptoticInterval, swing, turnsOver] =
      r.slice(17, 27);
    return {
      ...common,
      kind: kinds[kind],
      longest: Infinity,
      rate: Math.hypot(...this.omega),
      flips: hasFlips ? { interval, first, asymptoticInterval, swing } : null,
      phase: period ? { period, total, dynamic, geometric: total - dynamic } : null,
      turnsOver: hasFlips > 0 && turnsOver > 0,
    };
  }

  /**
   * The motion computed by a method at exactly these times, as by `twrench simulate --times`. Throws, for
   * instance, if the step is longer than a turn of the body.
   * @param {string} method
   * @param {StepControl} control
   * @param {ArrayLike<number>} times s, in any order and of either sign
   * @param {number} [mostSteps]
   */
  integrate(method, { step, tolerance }, times, mostSteps = 5e6) {
    if (method === recorded && this.core.recording) return this.core.recording.samples(times);
    const index = this.core.methods.indexOf(this.core.method(method));
    return this.compute('integrate', times, index, step, tolerance, mostSteps);
  }

  /** The deviations of samples from the motion and from the conserved quantities. @param {Samples} samples @returns {Diagnostics} */
  diagnose(samples) {
    const n = samples.t.length;
    const numbers = new Float64Array(13 * n);
    numbers.set(samples.t);
    numbers.set(samples.X, n);
    numbers.set(samples.omega, 10 * n);
    const r = this.instance.compute(5 * n, numbers, 'motion_diagnose', this.held.get(), n);
    return {
      energy: r.slice(0, n),
      energyDrift: r.slice(n, 2 * n),
      orthogonalityError: r.slice(2 * n, 3 * n),
      momentumError: r.slice(3 * n, 4 * n),
      error: r.slice(4 * n),
    };
  }

  /** Flip n, s, counted from the first one after 0; NaN if there is none. @param {number} n */
  #flip(n) {
    if (!this.facts.kind) return n >= 0 && this.facts.turnsOver ? this.call('flip', n) : NaN;
    const { first = NaN, interval = NaN } = this.facts.flips ?? {};
    const t = n === 0 ? first : first + n * interval; // on the separatrix there is only one
    return Number.isFinite(t) ? t : NaN;
  }

  /** The number of a flip near t; NaN if numbers that large are no longer exact. @param {number} t */
  #flipNear(t) {
    if (!this.facts.kind) return Math.max(this.flipsUntil(t) - 1, 0);
    const { first = NaN, interval = NaN } = this.facts.flips ?? {};
    const n = Math.floor((t - first) / interval);
    return Number.isSafeInteger(n) ? n : NaN;
  }

  /** The number of flips from 0 to t, s. @param {number} t */
  flipsUntil(t) {
    const { kind, flips, turnsOver, longest } = this.facts;
    if (!kind) return turnsOver ? this.call('flips_until', Math.min(t, longest)) : 0;
    if (!flips || !Number.isFinite(flips.first) || t < flips.first) return 0;
    if (!Number.isFinite(flips.interval)) return 1;
    return 1 + Math.floor((t - flips.first) / flips.interval);
  }

  /**
   * The times of the flips with from < t <= to, s: at most the first `most`. Both limits may be negative.
   * @param {number} from @param {number} to @param {number} [most]
   */
  flipTimes(from, to, most = 1000) {
    /** @type {number[]} */
    const times = [];
    for (let n = this.#flipNear(from); times.length < most && this.#flip(n) <= to; ++n) {
      if (this.#flip(n) > from) times.push(this.#flip(n));
    }
    return times;
  }

  /** The first flip after t, s; null if there is none. @param {number} t @returns {number | null} */
  nextFlip(t) {
    return this.flipTimes(t, Infinity, 1)[0] ?? null;
  }

  /** The last flip before t, s, also before 0; null if there is none. @param {number} t */
  previousFlip(t) {
    const n = this.#flipNear(t);
    return [n + 1, n, n - 1].map((each) => this.#flip(each)).find((flip) => flip < t) ?? null;
  }

  /**
   * A run of a method along the motion, forward from t = 0, which remembers its steps; or the recorded
   * motion.
   * @param {string} method @param {StepControl} control @returns {Run | Recording}
   */
  run(method, control) {
    return (method === recorded && this.core.recording) || new Run(this, method, control);
  }
}

/** The name of the recorded motion among the methods. */
export const recorded = 'recorded';

/** A recorded motion. It has the interface of a run that has reached its end. */
export class Recording extends Sampled {
  /** @param {Instance} instance @param {RecordedRows} rows */
  constructor(instance, { file, rows, duration, longest_step: longest, flips }) {
    super(instance, () => instance.callWith(rows, 'recording_new', rows.length / 8, longest), 'recording');
    this.file = file;
    this.reached = duration;
    this.steps = NaN;
    this.flips = flips;
  }

  advance() {
    return this.reached;
  }

  flipTimes() {
    return Float64Array.from(this.flips);
  }

  /** Does nothing: all figures share it. */
  release() {}
}

/** A run of a method. It throws if the method cannot continue; computed samples remain available. */
export class Run extends Sampled {
  /** @param {Motion} motion @param {string} name @param {StepControl} control */
  constructor(motion, name, { step, tolerance }) {
    const { core } = motion,
      method = core.method(name),
      index = core.methods.indexOf(method);
    super(core.instance, () => core.instance.call('run_new', motion.held.get(), index, step, tolerance), 'run');
    this.motion = motion;
    this.method = method;
    this.control = { step, tolerance };
  }

  /**
   * Advances to t or by `steps` steps, whichever comes first, and returns the time reached, s, so that
   * a page is not blocked. Keeps at most half a million steps, and throws beyond.
   * @param {number} t @param {number} [steps]
   */
  advance(t, steps = 20000) {
    return this.call('advance', t, steps);
  }

  /** The time reached, s. */
  get reached() {
    return this.call('reached');
  }

  /** The number of steps so far, rejected ones too. */
  get steps() {
    return this.call('steps');
  }

  /** Evaluations of omega so far. */
  get evaluations() {
    return this.call('evaluations');
  }

  /** The times of the flips in the method's solution so far, s. @returns {Float64Array} */
  flipTimes() {
    const count = this.call('flips');
    return this.instance.scratch(count).slice();
  }
}
