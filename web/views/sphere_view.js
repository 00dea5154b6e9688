// The momentum sphere, on which the start of the motion can be dragged.
import { InsetView } from './inset_view.js';
import { arrows } from './turning.js';

const startSize = 22, // points from its middle within which it can be dragged
  stepOfStart = 0.02; // rad by an arrow key

export class SphereView extends InsetView {
  /**
   * @param {HTMLElement} box @param {import("../picture/graphics.js").Graphics} graphics @param {() => void} changed
   * @param {import("../core/pictures.js").Pictures} pictures
   * @param {(omega: number[]) => void} start Starts the motion with that omega.
   */
  constructor(box, graphics, changed, pictures, start) {
    super('sphere', box, graphics, changed, pictures);
    this.start = start;
  }

  /** @param {PointerEvent} event */
  grab(event) {
    if (!this.#isAtStart(this.placeOf(event))) return null;
    return (/** @type {PointerEvent} */ moved) => this.#start('omegaAt', this.placeOf(moved));
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const step = event.shiftKey ? stepOfStart / 10 : stepOfStart;
    const way = arrows[event.key]?.map((sign) => sign * step);
    if (!way) return super.key(event);
    this.#start('omegaMoved', way);
    return true;
  }

  /** Whether a place in the picture is at the start. @param {number[]} at -1 to 1 across and up */
  #isAtStart([x, y]) {
    if (!this.shown || this.shown.model.atRest) return false;
    const { model, settings } = this.shown,
      { width, clientWidth, clientHeight } = this.canvas,
      start = this.pictures.start(model.motion, settings, this.viewpoint);
    const [across, down] = start.map((pixels) => (pixels * clientWidth) / width);
    return Math.hypot(across - ((1 + x) * clientWidth) / 2, down - ((1 - y) * clientHeight) / 2) < startSize;
  }

  /** Starts the motion at a place in the picture, or moves the start by angles. @param {'omegaAt' | 'omegaMoved'} how @param {number[]} where across and up */
  #start(how, where) {
    if (!this.shown) return;
    const { model, settings } = this.shown;
    this.start(this.pictures[how](model.motion, settings, this.viewpoint, where));
  }
}
