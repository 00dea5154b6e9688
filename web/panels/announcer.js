// Announces flips of the body to screen readers.
import { byId } from '../app/dom.js';
import { duration, word } from '../words/words.js';

const leastPause = 2000; // ms between two announcements: speech takes time

export class Announcer {
  constructor() {
    this.count = 0;
    this.last = -Infinity;
    /** @type {import("../app/motion_model.js").MotionModel | null} */
    this.model = null;
  }

  /** @param {import("../app/motion_model.js").MotionModel} model @param {number} t */
  tell(model, t) {
    const count = model.flipsUntil(t);
    if (model !== this.model || count < this.count) {
      this.model = model;
      this.count = count;
    }
    if (count <= this.count || performance.now() - this.last < leastPause) return;
    this.count = count;
    this.last = performance.now();
    byId('announce').textContent = word('flipped', count, duration(model.previousFlip(t) ?? t));
  }
}
