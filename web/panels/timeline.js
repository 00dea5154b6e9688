// The timeline: the present time and the flips. A slider for pointer and keyboard.
import { onDrag } from '../app/dom.js';
import { clamp } from '../math/linear.js';
import { longestTime, seek } from '../app/player.js';
import { Chart, tickStep, tickText } from './chart.js';
import { timeUnit } from '../words/words.js';

/** @import { MotionModel } from '../app/motion_model.js' */
/** @import { Store } from '../app/state.js' */
/** @import { State } from '../app/types' */

/** @typedef {{invalidate: () => void, flip: (direction: number) => void, step: (direction: number) => void, toggle: () => void}} Actions */

const mostFlips = 400,
  margin = 10;

export class Timeline {
  /** @param {HTMLElement} box @param {Store} store @param {Actions} actions */
  constructor(box, store, actions) {
    this.store = store;
    this.chart = new Chart(box, actions.invalidate);
    /** @type {{model: MotionModel, key: string, dense: boolean, times: number[]} | null} */
    this.flipsFor = null;
    onDrag(box, margin, (share) => {
      const { from, length } = store.state;
      store.set({ t: clamp(from + share * length, 0, longestTime) });
    });
    box.addEventListener('keydown', (event) => this.#key(event, actions));
  }

  /** @param {KeyboardEvent} event @param {Actions} actions */
  #key(event, { flip, step, toggle }) {
    const { t, from, length } = this.store.state;
    /** @type {Record<string, () => void>} */
    const keys = {
      ArrowLeft: () => (event.shiftKey ? seek(this.store, t - length / 100) : step(-1)),
      ArrowRight: () => (event.shiftKey ? seek(this.store, t + length / 100) : step(1)),
      ArrowDown: () => seek(this.store, t - length / 100),
      ArrowUp: () => seek(this.store, t + length / 100),
      PageDown: () => flip(-1),
      PageUp: () => flip(1),
      Home: () => this.store.set({ t: from }),
      End: () => this.store.set({ t: from + length }),
      ' ': toggle,
    };
    if (!keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  }

  /** @param {MotionModel} model */
  #flipsOf(model) {
    const { from, length } = this.store.state;
    const key = `${from} ${length}`;
    if (this.flipsFor?.model !== model || this.flipsFor.key !== key) {
      const { flips, turnsOver } = model.facts;
      let dense = turnsOver && length / (flips?.interval ?? Infinity) > mostFlips;
      let times = turnsOver && !dense ? model.motion.flipTimes(from, from + length, mostFlips + 1) : [];
      if (times.length > mostFlips) [dense, times] = [true, []];
      this.flipsFor = { model, key, dense, times };
    }
    return this.flipsFor;
  }

  /** @param {State} state @param {MotionModel} model @param {any} colors of the theme @param {{from: number, to: number} | null} detail */
  draw({ t, from, length }, model, colors, detail) {
    const { chart } = this,
      context = chart.begin(),
      { width, height } = chart;
    const x = (/** @type {number} */ time) => margin + ((time - from) / length) * (width - 2 * margin);
    const middle = height - 14 - 0.35 * chart.fontSize;
    context.fillStyle = colors.line;
    context.fillRect(margin, middle - 3, width - 2 * margin, 6);
    context.fillStyle = colors.accent;
    context.fillRect(margin, middle - 3, clamp(x(t), margin, width - margin) - margin, 6);
    this.#drawFlips(model, colors, x, middle);
    this.#drawTicks(from, length, colors, x);
    if (detail && detail.to - detail.from < 0.98 * length) {
      context.strokeStyle = colors.text;
      context.strokeRect(
        clamp(x(detail.from), margin, width - margin - 3),
        middle - 9,
        Math.max(x(detail.to) - x(detail.from), 3),
        18,
      );
    }
    context.lineWidth = 2;
    chart.disc(clamp(x(t), margin, width - margin), middle, 8, colors.text, colors.panel);
  }

  /** @param {MotionModel} model @param {any} colors @param {(t: number) => number} x @param {number} middle */
  #drawFlips(model, colors, x, middle) {
    const { context, width } = this.chart,
      { dense, times } = this.#flipsOf(model);
    context.fillStyle = colors.second;
    if (dense) {
      context.globalAlpha = 0.5;
      context.fillRect(margin, middle - 7, width - 2 * margin, 14);
      context.globalAlpha = 1;
    }
    const half = times.length > 60 ? 0.75 : 1.5;
    for (const time of times) {
      context.fillRect(x(time) - half, middle - 9, 2 * half, 18);
      if (times.length > 60) continue;
      context.beginPath(); // a diamond, so that flips are recognisable by shape as well
      context.moveTo(x(time), middle - 14);
      context.lineTo(x(time) + 4, middle - 10);
      context.lineTo(x(time), middle - 6);
      context.lineTo(x(time) - 4, middle - 10);
      context.fill();
    }
  }

  /** @param {number} from @param {number} length @param {any} colors @param {(t: number) => number} x */
  #drawTicks(from, length, colors, x) {
    const { context, width, fontSize } = this.chart;
    const unit = timeUnit(from + length),
      step = unit.length * tickStep(length / unit.length, width / 80);
    context.fillStyle = colors.dim;
    context.textBaseline = 'top';
    for (let n = Math.ceil(from / step - 1e-9); n * step <= from + length * (1 + 1e-12); ++n) {
      const text = tickText((n * step) / unit.length, step / unit.length),
        wide = context.measureText(text).width;
      context.fillText(text, clamp(x(n * step) - wide / 2, 0, width - wide - 12), 0, width);
    }
    context.textBaseline = 'alphabetic';
    context.textAlign = 'right';
    context.fillText(unit.symbol, width - 2, 0.8 * fontSize);
    context.textAlign = 'left';
  }
}
