// The state in the address, after the #: the differences from the initial state, as readable
// key=value pairs. Invalid pairs are ignored and reported.
import { features } from './state.js';

/** @import { PageData, State } from './types' */

/** @typedef {(text: string) => any} Reader  parses a value; returns undefined if it is invalid */

/** @param {string} text */
const numberIn = (text) => (/^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(text) ? Number(text) : NaN);

/** @param {number} low @param {number} high @returns {Reader} */
const number = (low, high) => (text) => {
  const value = numberIn(text);
  return value >= low && value <= high ? value : undefined;
};

/** @param {number[][]} ranges @returns {Reader} */
const numbers = (ranges) => (text) => {
  const values = text.split(',').map(numberIn);
  const fits =
    values.length === ranges.length &&
    values.every((value, i) => value >= ranges[i][0] && value <= ranges[i][1]);
  return fits ? values : undefined;
};

/** @param {readonly string[]} words @returns {Reader} */
const oneOf = (words) => (text) => (words.includes(text) ? text : undefined);

/** Exactly `count` of the words; without `count` any number of them, each at most once. @param {readonly string[]} words @param {number} [count] @returns {Reader} */
const someOf = (words, count) => (text) => {
  const found = text === '' ? [] : text.split(',');
  const fits = count === undefined ? new Set(found).size === found.length : found.length === count;
  return fits && found.every((word) => words.includes(word)) ? found : undefined;
};

/**
 * The reader of each value of the state.
 * @param {PageData} data @param {readonly string[]} methods
 * @returns {Record<string, Reader>}
 */
export function readers({ limits, themes }, methods) {
  const moments = numbers([limits.moment, limits.moment, limits.moment]);
  return {
    t: number(0, limits.time[1]),
    speed: number(1e-12, 1e12),
    omega: numbers([limits.omega, limits.omega, limits.omega]),
    moments: (text) => {
      const values = moments(text);
      return values && Math.max(...values) <= limits.moment_ratio * Math.min(...values) ? values : undefined;
    },
    wheel: numbers([limits.wheel, limits.wheel, limits.wheel]),
    energy_loss_time: (text) => (text === 'inf' ? Infinity : number(limits.energy_loss_time[0], limits.energy_loss_time[1])(text)),
    theme: oneOf(['auto', ...Object.keys(themes)]),
    frame: oneOf(['space', 'body', 'rotating']),
    show: someOf(features),
    view: numbers([
      [-100, 100],
      [-Math.PI, Math.PI],
      [0.25, 8],
    ]),
    from: number(0, limits.time[1]),
    length: number(1e-12, limits.time[1]),
    compare: oneOf(['off', 'beside', 'ghost']),
    methods: someOf(methods, 2),
    step: number(limits.step[0], limits.step[1]),
    tolerance: number(limits.tolerance[0], limits.tolerance[1]),
    lang: oneOf(['en', 'nb']),
  };
}

/**
 * Reads a link.
 * @param {string} hash With or without its #.
 * @param {Record<string, Reader>} known
 * @returns {{values: Partial<State>, ignored: string[]}} `ignored` is untrusted text.
 */
export function readLink(hash, known) {
  /** @type {Record<string, any>} */
  const values = {};
  const ignored = [];
  for (const pair of hash.replace(/^#/, '').split('&').filter(Boolean)) {
    const [key, text] = decoded(pair);
    const value = Object.hasOwn(known, key) ? known[key](text) : undefined;
    if (value === undefined) ignored.push(`${key}=${text}`.slice(0, 60));
    else values[key] = value;
  }
  return { values, ignored };
}

/** @param {string} pair */
function decoded(pair) {
  const at = pair.indexOf('=');
  const [key, text] = at < 0 ? [pair, ''] : [pair.slice(0, at), pair.slice(at + 1)];
  try {
    return [decodeURIComponent(key), decodeURIComponent(text)];
  } catch {
    return [key, text];
  }
}

/**
 * The link to a state: only its differences from the initial state.
 * @param {State} state @param {State} initial
 */
export function linkTo(state, initial) {
  const pairs = [];
  for (const [key, value] of Object.entries(state)) {
    const text = textOf(value);
    if (text !== textOf(/** @type {any} */ (initial)[key])) pairs.push(`${key}=${text}`);
  }
  return pairs.join('&');
}

/** A value in a link or on the command line. @param {any} value */
export const textOf = (value) => (value === Infinity ? 'inf' : String(value));
