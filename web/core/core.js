/**
 * The motion of a free rigid body: the C++ of twrench in WebAssembly. Units are cm, g, s and rad, as
 * in scene files; matrices are arrays of 9 numbers, row by row; vectors of 3. Body axes are the axes
 * in which the inertia matrix was given, X = space_from_body, and X(0) is the identity.
 *
 * Every call can throw a CoreError, whose message says what was wrong with which quantity; the objects
 * can be used afterwards as before.
 */
import { CoreError, Instance } from './instance.js';

export { CoreError };

/** @typedef {[number, number, number]} Vector */
/** @typedef {number[]} Matrix nine numbers, row by row */

/**
 * The motion at one time.
 * @typedef {object} Sample
 * @property {number} t s
 * @property {Matrix} X space_from_body
 * @property {Vector} omega in body axes, rad/s
 */

/**
 * The motion at many times; sample i has X[9 i ... 9 i + 8] and omega[3 i ... 3 i + 2].
 * @typedef {object} Samples
 * @property {Float64Array} t s
 * @property {Float64Array} X
 * @property {Float64Array} omega
 */

/**
 * How far samples are from what is conserved, and from the exact motion.
 * @typedef {object} Diagnostics
 * @property {Float64Array} energyDrift energy/energy(0) - 1
 * @property {Float64Array} orthogonalityError |X^T X - Id|, Frobenius
 * @property {Float64Array} momentumError |X I omega - L| / |L|
 * @property {Float64Array} error |X - X_exact|, Frobenius; for a small angle a it is sqrt(2) a
 */

/**
 * @typedef {object} Method
 * @property {string} name
 * @property {number | null} order
 * @property {boolean} exact the closed form: no step, no error
 * @property {boolean} adaptive takes a tolerance and chooses its steps
 * @property {boolean} leavesGroup X does not remain a rotation
 * @property {boolean} conservesEnergy
 * @property {boolean} reversible
 * @property {string} summary one line
 * @property {string} source
 */

/**
 * Sign changes of omega along the intermediate axis.
 * @typedef {object} Flips
 * @property {number} interval s; Infinity on the separatrix
 * @property {number} first s, after t = 0
 * @property {number} asymptoticInterval s, its approximation near the separatrix
 * @property {number} swing rad, through which the intermediate axis swings
 * @property {boolean} turnsOver whether it is a turning over and not a wobble
 */

/** @typedef {'steady' | 'about_least' | 'about_greatest' | 'separatrix'} Kind */

/**
 * What is known of a motion without computing any of it.
 * @typedef {object} Facts
 * @property {Kind} kind
 * @property {Vector} momentum L in space axes, g cm^2/s; also the body momentum at t = 0
 * @property {number} energy 1/2 omega . (I omega), g cm^2/s^2
 * @property {Vector} moments principal moments, ascending, g cm^2
 * @property {Matrix} axes body_from_principal; column i is the axis of moments[i]
 * @property {Flips | null} flips null for a steady motion and a symmetric body
 * @property {boolean} isReal whether a body can have these moments (the triangle inequality holds)
 */

/**
 * @typedef {object} StepControl
 * @property {number} step s, of a method with fixed steps; the first one of an adaptive method
 * @property {number} tolerance of an adaptive method
 */

/**
 * A part of a body. Dimensions in cm as in scene files: cylinder {radius, length}, box {size}, ellipsoid
 * {radii}, cone {radius, length, top_radius}, torus {radius, tube_radius}, capsule {radius, length},
 * tube {radius, inner_radius, length}; mesh {volume, centroid, inertia}, of density 1.
 * @typedef {object} Part
 * @property {string} shape
 * @property {number} density g/cm^3
 * @property {Vector} position cm
 * @property {Matrix} body_from_part rotation
 * @property {string} [name]
 * @property {number} [radius]
 * @property {number} [length]
 * @property {number} [top_radius]
 * @property {number} [tube_radius]
 * @property {number} [inner_radius]
 * @property {Vector} [size]
 * @property {Vector} [radii]
 * @property {number} [volume]
 * @property {Vector} [centroid]
 * @property {Matrix} [inertia]
 */

/**
 * @typedef {object} MassProperties
 * @property {number} mass g
 * @property {Vector} centreOfMass cm
 * @property {Matrix} inertia about the centre of mass, body axes, g cm^2
 * @property {Vector} moments ascending, g cm^2
 * @property {Matrix} axes body_from_principal
 */

/**
 * What a small tilt of a steady rotation does.
 * @typedef {object} Stability
 * @property {'unstable' | 'stable' | 'neutral'} kind
 * @property {number} rate 1/s of growth, or rad/s of the wobble
 */

const kinds = /** @type {Kind[]} */ (['steady', 'about_least', 'about_greatest', 'separatrix']);
const stabilities = /** @type {const} */ (['unstable', 'stable', 'neutral']);

/** The dimensions of each shape, in the order in which bindings.cpp reads them. */
const shapes = /** @type {[string, (part: any) => number[]][]} */ ([
  ['cylinder', (p) => [p.radius, p.length]],
  ['box', (p) => p.size],
  ['ellipsoid', (p) => p.radii],
  ['cone', (p) => [p.radius, p.length, p.top_radius ?? 0]],
  ['torus', (p) => [p.radius, p.tube_radius]],
  ['capsule', (p) => [p.radius, p.length]],
  ['tube', (p) => [p.radius, p.inner_radius, p.length]],
  ['mesh', (p) => [p.volume, ...p.centroid, ...p.inertia]],
]);

const doublesPerPart = 1 + 13 + 1 + 3 + 9;

/** @param {readonly Part[]} parts */
function packed(parts) {
  const numbers = new Float64Array(parts.length * doublesPerPart);
  parts.forEach((part, i) => {
    const shape = shapes.findIndex(([name]) => name === part.shape);
    if (shape < 0) throw new CoreError(`shape: ${part.shape} is unknown`);
    const at = i * doublesPerPart;
    numbers.set([shape, ...shapes[shape][1](part)], at);
    numbers.set([part.density, ...part.position, ...part.body_from_part], at + 14);
  });
  return numbers;
}

/** @param {Float64Array} numbers @param {number} from @returns {Vector} */
const vector = (numbers, from) => [numbers[from], numbers[from + 1], numbers[from + 2]];

/** @param {Float64Array} numbers @param {number} from @returns {Matrix} */
const matrix = (numbers, from) => [...numbers.subarray(from, from + 9)];

/** The diagonal matrix of moments. @param {Vector} m @returns {Matrix} */
export const diagonal = (m) => [m[0], 0, 0, 0, m[1], 0, 0, 0, m[2]];

export class Core {
  /**
   * Compiles the core.
   * @param {BufferSource} bytes of core.wasm
   */
  static async load(bytes) {
    return new Core(new Instance(await WebAssembly.compile(bytes)));
  }

  /** @param {Instance} instance */
  constructor(instance) {
    this.instance = instance;
    /** @type {Method[]} All methods, in the order in which the program lists them. */
    this.methods = JSON.parse(instance.text(instance.call('methods')));
  }

  /** Throws a CoreError for a name that no method has. @param {string} name */
  method(name) {
    const found = this.methods.find((method) => method.name === name);
    if (!found) throw new CoreError(`method: unknown name '${name}'`);
    return found;
  }

  /**
   * The motion of a body with that inertia, g cm^2, and that angular velocity at t = 0, body axes,
   * rad/s. Throws unless the inertia is symmetric and positive definite.
   * @param {readonly number[]} inertia nine numbers
   * @param {readonly number[]} omega
   */
  motion(inertia, omega) {
    return new Motion(this, inertia, omega);
  }

  /** @param {readonly Part[]} parts @returns {MassProperties} */
  massProperties(parts) {
    const r = this.instance.compute(25, packed(parts), 'mass_properties', parts.length);
    return {
      mass: r[0],
      centreOfMass: vector(r, 1),
      inertia: matrix(r, 4),
      moments: vector(r, 13),
      axes: matrix(r, 16),
    };
  }

  /** The box that is drawn for a body given by its moments about x, y, z. @param {Vector} moments */
  equimomentalBox(moments) {
    const size = this.instance.compute(3, moments, 'equimomental_box');
    return /** @type {Part} */ ({
      shape: 'box',
      size: vector(size, 0),
      density: 1,
      position: [0, 0, 0],
      body_from_part: diagonal([1, 1, 1]),
    });
  }

  /**
   * A steady rotation about the axis with that index.
   * @param {Vector} moments in any order
   * @param {number} axis 0, 1 or 2
   * @param {number} omega rad/s
   * @returns {Stability}
   */
  stability(moments, axis, omega) {
    const [kind, rate] = this.instance.compute(2, moments, 'stability_of', axis, omega);
    return { kind: stabilities[kind], rate };
  }
}

/** Something in C++ that is made again when the instance was replaced. */
class Held {
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
    const r = this.core.instance.compute(4 * n, numbers, 'motion_diagnose', this.held.get(), n);
    return {
      energyDrift: r.slice(0, n),
      orthogonalityError: r.slice(n, 2 * n),
      momentumError: r.slice(2 * n, 3 * n),
      error: r.slice(3 * n),
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
   * The closed curve of constant energy on the sphere |mu| = 1 of the momentum's directions, body
   * axes: `count` points, 3 numbers each. omega = I^-1 (|L| mu) makes it the polhode. Null for a
   * sphere, where every mu is at rest.
   * @param {number} count
   * @returns {Float64Array | null}
   */
  energyCurve(count) {
    return this.#curve('energy_curve', 3 * count, count);
  }

  /**
   * `curves` such curves around each end of the axes of least and greatest moment, evenly spaced.
   * @param {number} curves @param {number} count points of each
   * @returns {Float64Array[]}
   */
  energyCurves(curves, count) {
    const { instance } = this.core;
    const found = instance.call('energy_curves', this.held.get(), curves, count);
    const points = instance.scratch(3 * count * found).slice();
    return Array.from({ length: found }, (_, i) => points.slice(3 * count * i, 3 * count * (i + 1)));
  }

  /**
   * The two great circles of the separatrix, `count` points each; null for a symmetric body.
   * @param {number} count
   * @returns {[Float64Array, Float64Array] | null}
   */
  separatrix(count) {
    const points = this.#curve('separatrix_curves', 6 * count, count);
    return points && [points.slice(0, 3 * count), points.slice(3 * count)];
  }

  /** @param {string} name @param {number} size @param {number} count */
  #curve(name, size, count) {
    const { instance } = this.core;
    if (!instance.call(name, this.held.get(), count)) return null;
    return instance.scratch(size).slice();
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
