// Lets the time of the motion go on, and the page be drawn only when something has changed.
import { clamp } from '../math/linear.js';

export const framesPerSecond = 60; // of the film, and of most displays
const longestFrame = 0.1; // s: a tab that was hidden does not jump

export class Player {
  /**
   * @param {import("./state.js").Store} store
   * @param {() => void} draw Draws everything that changed.
   */
  constructor(store, draw) {
    this.store = store;
    this.draw = draw;
    this.playing = false;
    this.requested = false;
    this.last = 0;
    /** @type {(() => void)[]} Called when it begins to play or pauses. */
    this.listeners = [];
  }

  /** Has the page drawn with the next picture of the display. */
  invalidate() {
    if (this.requested) return;
    this.requested = true;
    requestAnimationFrame((now) => this.#frame(now));
  }

  /** @param {boolean} playing */
  play(playing) {
    if (this.playing === playing) return;
    this.playing = playing;
    this.last = 0;
    for (const listener of this.listeners) listener();
    this.invalidate();
  }

  /** @param {number} now ms */
  #frame(now) {
    this.requested = false;
    if (this.playing) this.#advance(now);
    this.draw();
    if (this.playing) this.invalidate();
  }

  /** @param {number} now ms */
  #advance(now) {
    const elapsed = this.last > 0 ? Math.min((now - this.last) / 1000, longestFrame) : 0;
    this.last = now;
    if (elapsed > 0) seek(this.store, this.store.state.t + elapsed * this.store.state.speed);
  }
}

/**
 * Goes to the time t; the timeline follows, by whole lengths of itself.
 * @param {import("./state.js").Store} store @param {number} t
 */
export function seek(store, t) {
  const now = clamp(t, 0, 1e9);
  store.set({ t: now, from: pageOf({ ...store.state, t: now }) });
}

/**
 * Where a timeline begins that shows t: where it does, or whole lengths of it further on.
 * @param {{t: number, from: number, length: number}} state
 */
export function pageOf({ t, from, length }) {
  if (t >= from && t <= from + length) return from;
  return Math.max(0, from + Math.floor((t - from) / length) * length);
}
