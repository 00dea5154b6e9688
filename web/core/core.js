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
