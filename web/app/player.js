// Advances the time of the motion, and redraws the page only when something has changed.
import { clamp } from '../math/linear.js';

export const framesPerSecond = 60; // of the film, and of most displays
const longestFrame = 0.1; // s, so that time does not jump after a tab was hidden

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
    /** @type {(() => void)[]} Called when play starts or pauses. */
    this.listeners = [];
  }

  /** Schedules a redraw of the page with the display's next frame. */
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

/** The greatest time in s, as in scene files. */
export const longestTime = 1e15;

/**
 * Goes to the time t, and shifts the timeline by whole multiples of its length if necessary.
 * @param {import("./state.js").Store} store @param {number} t
 */
export function seek(store, t) {
  const now = clamp(t, 0, longestTime);
  store.set({ t: now, from: pageOf({ ...store.state, t: now }) });
}

/**
 * The beginning of a timeline that shows t: the present one, shifted by a whole multiple of the length.
 * @param {{t: number, from: number, length: number}} state
 */
export function pageOf({ t, from, length }) {
  if (t >= from && t <= from + length) return from;
  return Math.max(0, from + Math.floor((t - from) / length) * length);
}
