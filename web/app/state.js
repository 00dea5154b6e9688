// The state of the page, which a link contains. It is one object, replaced as a whole at each change, so
// that a view can compare the new state with the one that it drew.
import { recorded } from '../core/motion.js';
import { clamp } from '../math/linear.js';

/** @import { State } from './types' */

/** The values of a body in which nothing moves, by their keys in scene files. */
export const noInterior = { wheel: [0, 0, 0], energy_loss_time: Infinity };

export const features = ['floor', 'axes', 'momentum', 'omega', 'trail', 'plane', 'phase', 'labels'];

/**
 * The speeds offered: nine powers of 2 around 1, shifted if necessary to include the scene's speed.
 * @param {number} speed The scene's, in seconds of motion per second.
 */
export function speedsAbout(speed) {
  const power = Math.log2(powerOfTwo(speed)),
    middle = power - clamp(power, -4, 4);
  return [-4, -3, -2, -1, 0, 1, 2, 3, 4].map((offset) => 2 ** (middle + offset));
}

/** The largest power of 2 that is at most 1.1 times a speed. @param {number} speed */
export const powerOfTwo = (speed) => 2 ** Math.floor(Math.log2(1.1 * speed));

/**
 * The page's language that comes first among the reader's.
 * @param {readonly string[]} languages As in navigator.languages.
 * @returns {State["lang"]}
 */
export function languageOf(languages) {
  const first = languages.find((language) => /^(en|nb|nn|no)\b/.test(language)) ?? 'en';
  return first.startsWith('en') ? 'en' : 'nb';
}

/**
 * The initial state of the page of a scene.
 * @param {import("./types").PageData} data
 * @param {readonly string[]} languages The reader's, as in navigator.languages.
 * @returns {State}
 */
export function initialState({ scene, language, recording }, languages) {
  const compared = recording ? [recorded, movesInside(scene) ? 'taylor' : 'exact'] : (scene.overlay.compare ?? []);
  return {
    t: 0,
    speed: powerOfTwo(scene.film.speed),
    omega: scene.motion.omega,
    moments: null,
    wheel: scene.motion.wheel ?? noInterior.wheel,
    energy_loss_time: scene.motion.energy_loss_time ?? noInterior.energy_loss_time,
    theme: 'auto',
    frame: scene.camera.frame ?? 'space',
    show: features.filter((feature) => scene.overlay.show.includes(feature)),
    view: [0, 0, 1],
    from: 0,
    length: scene.motion.duration,
    compare: compared.length > 1 ? 'beside' : 'off',
    methods: compared.length > 1 ? compared.slice(0, 2) : ['exact', 'rk4'],
    step: Math.max(scene.motion.step, 0.01),
    tolerance: Math.max(scene.motion.tolerance, 1e-6),
    lang: language ?? languageOf(languages),
  };
}

/** Whether something moves in the body of a scene. @param {Record<string, any>} scene */
const movesInside = ({ motion: { wheel, energy_loss_time } }) => Boolean(wheel ?? energy_loss_time);

/** Whether nothing moves in the body. @param {State} state */
export const isRigid = (state) => state.wheel.every((h) => h === 0) && state.energy_loss_time === Infinity;

/**
 * Whether an item of the film has a meaning for the motion.
 * @param {string} feature @param {State} state @param {import("./types").PageData} data
 */
export const hasMeaning = (feature, state, { rigid_features, lossless_features }) =>
  !(!isRigid(state) && rigid_features.includes(feature)) &&
  !(state.energy_loss_time < Infinity && lossless_features.includes(feature));

/** @typedef {(state: State, before: State) => void} Listener */

export class Store {
  /** @param {State} state */
  constructor(state) {
    this.initial = state;
    this.state = state;
    /** @type {Listener[]} */
    this.listeners = [];
  }

  /** @param {Listener} listener Called after each change. */
  subscribe(listener) {
    this.listeners.push(listener);
  }

  /** @param {Partial<State>} changes */
  set(changes) {
    const before = this.state;
    this.state = { ...before, ...changes };
    for (const listener of this.listeners) listener(this.state, before);
  }
}

/** A copy of a list with another value at an index. @template T @param {T[]} list @param {number} at @param {T} value */
export const replaced = (list, at, value) => list.map((old, i) => (i === at ? value : old));
