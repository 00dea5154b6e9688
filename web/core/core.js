/**
 * The motion of a free rigid body: the C++ of twrench in WebAssembly. Units are cm, g, s and rad, as
 * in scene files; matrices are arrays of 9 numbers, row by row; vectors of 3. Body axes are the axes
 * in which the inertia matrix was given, X = space_from_body, and X(0) is the identity unless
 * another attitude is given.
 *
 * Every call can throw a CoreError, whose message names the quantity and the problem; the objects remain
 * usable afterwards.
 */
import { CoreError, Instance } from './instance.js';
import { matrix, Motion, recorded, Recording, vector } from './motion.js';

export { CoreError };
export { Motion, Recording, recorded, Run } from './motion.js';

/** @import { Interior, MassProperties, Matrix, Method, Part, RecordedRows, Shape, Stability, Vector } from './types' */

const stabilities = /** @type {const} */ (['unstable', 'stable', 'neutral']);

/** Nothing moves in a rigid body. @type {Interior} */
export const rigid = { wheel: [0, 0, 0], energyLossTime: Infinity };

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
    /** @type {Recording | null} The recorded motion, if there is one. */
    this.recording = null;
  }

  /** Throws a CoreError if no method has the name. @param {string} name */
  method(name) {
    const found = this.methods.find((method) => method.name === name);
    if (!found) throw new CoreError(`method: unknown name '${name}'`);
    return found;
  }

  /**
   * The motion of a body with this inertia, g cm^2, and this angular velocity at t = 0, body axes,
   * rad/s. Throws unless the inertia is symmetric and positive definite. A body with a wheel or energy
   * loss usually has no closed form; its motion is then integrated with `taylor` at tolerance 1e-15,
   * from t = 0 to `facts.longest`.
   * @param {readonly number[]} inertia nine numbers
   * @param {readonly number[]} omega
   * @param {Interior} [interior]
   * @param {Matrix} [attitude] X(0), space_from_body
   */
  motion(inertia, omega, interior = rigid, attitude = diagonal([1, 1, 1])) {
    return new Motion(this, inertia, omega, interior, attitude);
  }

  /**
   * Adds a recorded motion to the methods, by the name `recorded`.
   * @param {RecordedRows} rows
   */
  record(rows) {
    this.recording = new Recording(this.instance, rows);
    const summary = `the motion recorded in ${rows.file}`;
    const has = { exact: true, adaptive: false, leavesGroup: false, conservesEnergy: false, reversible: false };
    this.methods.push({ name: recorded, order: null, ...has, summary, source: rows.file });
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

  /** A part in the form that bindings.cpp reads; a missing dimension is 0. @param {Part} part */
  packed(part) {
    const index = this.shapes.findIndex(({ name }) => name === part.shape);
    if (index < 0) throw new CoreError(`shape: ${part.shape} is unknown`);
    const dimensions = this.shapes[index].keys.flatMap((key) => part[key] ?? 0);
    return [index, ...dimensions, part.density, ...part.position, ...part.body_from_part];
  }

  /** The box to draw for a body given by its moments about x, y, z. @param {Vector} moments */
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
   * The stability of a steady rotation about the axis with this index.
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
