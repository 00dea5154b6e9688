// The nine components of X against time, row by row: over the timeline or, if that is too long for
// curves, over a shorter time around the present.
import { longestTime } from '../app/player.js';
import { clamp } from '../math/linear.js';
import { onDrag } from '../app/dom.js';
import { evenly } from '../app/motion_model.js';
import { Chart } from './chart.js';

/** @import { MotionModel } from '../app/motion_model.js' */
/** @import { Store } from '../app/state.js' */
/** @import { State } from '../app/types' */

const margin = 10; // as the timeline's
const widestTurn = 0.3; // rad between two points of a curve
const dashes = [[], [7, 3], [2, 3]]; // of the columns, which can thus be distinguished without colour

/**
 * The time that the curves cover, s: the timeline, or as much around t as curves can show.
 * @param {State} state @param {MotionModel} model @param {number} points
 */
export function detailWindow({ t, from, length }, model, points) {
  const longest = (points * widestTurn) / Math.max(model.facts.rate, 1e-300);
  if (length <= longest) return { from, to: from + length };
  const page = Math.floor((t - from) / longest) * longest + from;
  return { from: page, to: page + longest };
}

export class Components {
  /** @param {HTMLElement} box @param {Store} store @param {() => void} changed */
  constructor(box, store, changed) {
    this.chart = new Chart(box, changed);
    this.window = { from: 0, to: 1 };
    this.points = 0;
    /** @type {MotionModel | null} */
    this.model = null;
    this.X = new Float64Array();
    /** The picture of the curves, which does not change while time advances. */
    this.still = document.createElement('canvas');
    this.drawn = false;
    /** @type {any} */
    this.colors = null;
    const seekTo = (/** @type {number} */ share) => {
      const { from, to } = this.window;
      store.set({ t: clamp(from + share * (to - from), 0, longestTime) });
    };
    onDrag(box, margin, seekTo, ['touch']); // a finger scrolls the page
  }

  /** @param {State} state @param {MotionModel} model */
  cover(state, model) {
    const points = Math.max(100, Math.round(this.chart.width - 2 * margin));
    const { from, to } = detailWindow(state, model, points);
    if (from === this.window.from && to === this.window.to && model === this.model && points === this.points)
      return this.window;
    this.window = { from, to };
    this.model = model;
    this.points = points;
    this.X = model.motion.samples(evenly(from, to, points)).X;
    this.drawn = false;
    return this.window;
  }

  /** @param {State} state @param {any} colors @param {number[]} X now */
  draw({ t }, colors, X) {
    const {
      chart,
      window: { from, to },
    } = this;
    this.#drawCurves(colors);
    const context = chart.begin();
    context.drawImage(this.still, 0, 0, chart.width, chart.height);
    const x = margin + ((t - from) / (to - from)) * (chart.width - 2 * margin);
    const top = [x, 0],
      bottom = [x, chart.height];
    chart.line(colors.text, 1.5 * chart.unit, [top, bottom]);
    this.#eachRow((row, y) => {
      for (let i = 3 * row; i < 3 * row + 3; ++i)
        chart.disc(x, y(X[i]), 3.5 * chart.unit, colors.curve[i], colors.panel);
    });
  }

  /** Draws the rows; y() is where a component is. @param {(row: number, y: (value: number) => number, top: number, height: number) => void} draw */
  #eachRow(draw) {
    const gap = 10,
      height = (this.chart.height - 2 * gap) / 3;
    for (let row = 0; row < 3; ++row) {
      const top = row * (height + gap);
      draw(row, (value) => top + height * (0.5 - 0.46 * value), top, height);
    }
  }

  /** Draws the curves to a separate canvas. @param {any} colors */
  #drawCurves(colors) {
    const { chart, X, points } = this;
    if (this.drawn && this.colors === colors && !chart.resized) return;
    chart.resized = false;
    this.drawn = true;
    this.colors = colors;
    const context = chart.begin(),
      wide = chart.width - 2 * margin;
    this.#eachRow((row, y, top, height) => {
      context.fillStyle = colors.ground;
      context.fillRect(margin, top, wide, height);
      context.strokeStyle = colors.line;
      context.lineWidth = 1;
      for (const level of [1, 0, -1]) context.strokeRect(margin, Math.round(y(level)) + 0.5, wide, 0);
      dashes.forEach((dash, column) => {
        const k = 3 * row + column,
          curve = Array.from({ length: points + 1 }, (_, i) => [margin + (wide * i) / points, y(X[9 * i + k])]);
        chart.line(colors.curve[k], 1.6 * chart.unit, curve, dash);
      });
      this.#drawNames(row, top + height, colors);
    });
    this.still.width = chart.canvas.width;
    this.still.height = chart.canvas.height;
    this.still.getContext('2d')?.drawImage(chart.canvas, 0, 0);
  }

  /** @param {number} row @param {number} bottom @param {any} colors */
  #drawNames(row, bottom, colors) {
    const { chart } = this,
      { context, fontSize } = chart;
    const line = 22,
      pitch = line + 3.2 * fontSize;
    context.fillStyle = colors.panelShade;
    context.fillRect(margin + 4, bottom - fontSize - 8, 3 * pitch + 4, fontSize + 6);
    dashes.forEach((dash, column) => {
      const x = margin + 8 + column * pitch,
        y = bottom - 6 - 0.35 * fontSize,
        color = colors.curve[3 * row + column];
      chart.line(color, 2.2, [[x, y], [x + line, y]], dash);
      context.fillStyle = color;
      context.fillText(`X${'₁₂₃'[row]}${'₁₂₃'[column]}`, x + line + 4, bottom - 6);
    });
  }
}
