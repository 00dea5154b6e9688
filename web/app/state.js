// The state of the page: everything that a link to it holds. One object, replaced as a whole at each
// change, so that a view can compare what it drew.
import { clamp } from '../math/linear.js';

/** @import { State } from './types' */

export const features = ['floor', 'axes', 'momentum', 'omega', 'trail', 'plane', 'labels'];
export const speeds = [-4, -3, -2, -1, 0, 1, 2, 3, 4].map((power) => 2 ** power);

/**
 * The language of the page that a reader understands best.
 * @param {readonly string[]} languages As in navigator.languages.
 * @returns {State["lang"]}
 */
export function languageOf(languages) {
  const first = languages.find((language) => /^(en|nb|nn|no)\b/.test(language)) ?? 'en';
  return first.startsWith('en') ? 'en' : 'nb';
}

/**
 * The state in which the page of a scene opens.
 * @param {import("./types").PageData} data
 * @param {readonly string[]} languages The reader's, as in navigator.languages.
 * @returns {State}
 */
export function initialState({ scene }, languages) {
  const compared = scene.overlay.compare ?? [];
  return {
    t: 0,
    speed: 2 ** clamp(Math.floor(Math.log2(scene.film.speed)), -4, 4),
    omega: scene.motion.omega,
    moments: null,
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
    lang: languageOf(languages),
    tour: 0,
  };
}

/** @typedef {(state: State, before: State) => void} Listener */

export class Store {
  /** @param {State} state */
  constructor(state) {
    this.initial = state;
    this.state = state;
    /** @type {Listener[]} */
    this.listeners = [];
  }

  /** @param {Listener} listener Is called after each change. */
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
