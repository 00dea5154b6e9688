/**
 * The motion of a free rigid body: the C++ of twrench in WebAssembly. Units are cm, g, s and rad, as
 * in scene files; matrices are arrays of 9 numbers, row by row; vectors of 3. Body axes are the axes
 * in which the inertia matrix was given, X = space_from_body, and X(0) is the identity.
 *
 * Every call can throw a CoreError, whose message says what was wrong with which quantity; the objects
 * can be used afterwards as before.
 */
import { CoreError, Instance } from './instance.js';
import { matrix, Motion, vector } from './motion.js';

export { CoreError };
export { Motion, Run } from './motion.js';

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
 * @property {Float64Array} energy 1/2 omega . (I omega), g cm^2/s^2
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
 * A part of a body, which has the dimensions of its shape in cm under their keys in scene files; it
 * cannot be a mesh.
 * @typedef {object} PartValues
 * @property {string} shape
 * @property {number} density g/cm^3
 * @property {Vector} position cm
 * @property {Matrix} body_from_part rotation
 * @property {string} [name]
 */

/** @typedef {PartValues & Record<string, any>} Part */

/**
 * A shape and the keys of its dimensions, each a number or a vector.
 * @typedef {object} Shape
 * @property {string} name
 * @property {string[]} keys
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

const stabilities = /** @type {const} */ (['unstable', 'stable', 'neutral']);

/** The diagonal matrix of moments. @param {readonly number[]} m @returns {Matrix} */
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
    /** @type {Shape[]} */
    this.shapes = JSON.parse(instance.text(instance.call('shapes')));
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
    const numbers = parts.flatMap((part) => this.packed(part));
    const r = this.instance.compute(25, numbers, 'mass_properties', parts.length);
    return {
      mass: r[0],
      centreOfMass: vector(r, 1),
      inertia: matrix(r, 4),
      moments: vector(r, 13),
      axes: matrix(r, 16),
    };
  }

  /** A part as bindings.cpp reads it; a dimension that is not given is 0. @param {Part} part */
  packed(part) {
    const index = this.shapes.findIndex(({ name }) => name === part.shape);
    if (index < 0) throw new CoreError(`shape: ${part.shape} is unknown`);
    const dimensions = this.shapes[index].keys.flatMap((key) => part[key] ?? 0);
    return [index, ...dimensions, part.density, ...part.position, ...part.body_from_part];
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
