// The nine components of X against time, row by row, over the timeline or, where it is too long for
// curves, over the seconds around now.
import { clamp } from '../math/linear.js';
import { Chart } from './chart.js';

/** @typedef {import("../app/motion_model.js").MotionModel} MotionModel */
/** @typedef {import("../app/state.js").State} State */

const margin = 10; // as the timeline's
const widestTurn = 0.3; // rad between two points of a curve
const dashes = [[], [7, 3], [2, 3]]; // of the columns: told apart without colour

/**
 * What the curves cover, s: the timeline, or as much around t as curves can show.
 * @param {State} state @param {MotionModel} model @param {number} points
 */
export function detailWindow({ t, from, length }, model, points) {
  const longest = (points * widestTurn) / Math.max(Math.hypot(...model.omega), 1e-300);
  if (length <= longest) return { from, to: from + length };
  const page = Math.floor((t - from) / longest) * longest + from;
  return { from: page, to: page + longest };
}

export class Components {
  /** @param {HTMLElement} box @param {import("../app/state.js").Store} store @param {() => void} changed */
  constructor(box, store, changed) {
    this.chart = new Chart(box, changed);
    this.window = { from: 0, to: 1 };
    this.points = 0;
    /** @type {MotionModel | null} */
    this.model = null;
    /** @type {Float64Array} */
    this.X = new Float64Array();
    /** The curves, which stay while time goes on. */
    this.still = document.createElement('canvas');
    this.drawn = false;
    /** @type {any} */
    this.colors = null;
    const seekTo = (/** @type {PointerEvent} */ event) => {
      const { left, width } = box.getBoundingClientRect();
      const share = clamp((event.clientX - left - margin) / (width - 2 * margin), 0, 1);
      store.set({ t: clamp(this.window.from + share * (this.window.to - this.window.from), 0, 1e9) });
    };
    box.addEventListener('pointerdown', (event) => {
      if (event.pointerType === 'touch') return;
      box.setPointerCapture(event.pointerId);
      seekTo(event);
    });
    box.addEventListener('pointermove', (event) => {
      if (box.hasPointerCapture(event.pointerId)) seekTo(event);
    });
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
    ({ X: this.X } = model.motion.samples(
      Float64Array.from({ length: points + 1 }, (_, i) => from + ((to - from) * i) / points),
    ));
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
    context.strokeStyle = colors.text;
    context.lineWidth = 1.5 * chart.unit;
    context.beginPath();
    context.moveTo(x, 0);
    context.lineTo(x, chart.height);
    context.stroke();
    this.#eachRow((row, top, height) => {
      for (let column = 0; column < 3; ++column) {
        context.beginPath();
        context.arc(x, top + height * (0.5 - 0.46 * X[3 * row + column]), 3.5 * chart.unit, 0, 2 * Math.PI);
        context.fillStyle = colors.curve[3 * row + column];
        context.fill();
        context.strokeStyle = colors.panel;
        context.stroke();
      }
    });
  }

  /** @param {(row: number, top: number, height: number) => void} draw */
  #eachRow(draw) {
    const gap = 10,
      height = (this.chart.height - 2 * gap) / 3;
    for (let row = 0; row < 3; ++row) draw(row, row * (height + gap), height);
  }

  /** Draws the curves to their own picture. @param {any} colors */
  #drawCurves(colors) {
    const { chart, X, points } = this;
    if (this.drawn && this.colors === colors && !chart.resized) return;
    chart.resized = false;
    this.drawn = true;
    this.colors = colors;
    const context = chart.begin(),
      wide = chart.width - 2 * margin;
    this.#eachRow((row, top, height) => {
      context.fillStyle = colors.ground;
      context.fillRect(margin, top, wide, height);
      context.strokeStyle = colors.line;
      context.lineWidth = 1;
      for (const level of [0.04, 0.5, 0.96])
        context.strokeRect(margin, Math.round(top + height * level) + 0.5, wide, 0);
      for (let column = 0; column < 3; ++column) {
        context.beginPath();
        for (let i = 0; i <= points; ++i) {
          context.lineTo(
            margin + (wide * i) / points,
            top + height * (0.5 - 0.46 * X[9 * i + 3 * row + column]),
          );
        }
        context.strokeStyle = colors.curve[3 * row + column];
        context.setLineDash(dashes[column]);
        context.lineWidth = 1.6 * chart.unit;
        context.stroke();
      }
      context.setLineDash([]);
      this.#drawNames(row, top, height, colors);
    });
    this.still.width = chart.canvas.width;
    this.still.height = chart.canvas.height;
    this.still.getContext('2d')?.drawImage(chart.canvas, 0, 0);
  }

  /** @param {number} row @param {number} top @param {number} height @param {any} colors */
  #drawNames(row, top, height, colors) {
    const { context, fontSize } = this.chart;
    const line = 22,
      pitch = line + 3.2 * fontSize;
    context.fillStyle = colors.panelShade;
    context.fillRect(margin + 4, top + height - fontSize - 8, 3 * pitch + 4, fontSize + 6);
    for (let column = 0; column < 3; ++column) {
      const x = margin + 8 + column * pitch,
        y = top + height - 6;
      context.strokeStyle = context.fillStyle = colors.curve[3 * row + column];
      context.setLineDash(dashes[column]);
      context.lineWidth = 2.2;
      context.beginPath();
      context.moveTo(x, y - 0.35 * fontSize);
      context.lineTo(x + line, y - 0.35 * fontSize);
      context.stroke();
      context.setLineDash([]);
      context.fillText(`X${'₁₂₃'[row]}${'₁₂₃'[column]}`, x + line + 4, y);
    }
  }
}
