// A chart of the lean on a logarithmic scale, with the straight line of a lean that doubles evenly.
import { Chart, tickStep, tickText } from '../panels/chart.js';
import { evenly } from '../app/motion_model.js';
import { superscript, timeUnit } from '../words/words.js';
import { leans } from './numbers.js';

/** @import { MotionModel } from '../app/motion_model.js' */
/** @import { Figure } from './figure.js' */

const points = 300,
  marginLeft = 52,
  marginBottom = 22,
  marginTop = 8;
const most = 360; // degrees, the end of the scale

export class LeanChart {
  /** @param {HTMLElement} box @param {() => void} changed */
  constructor(box, changed) {
    this.chart = new Chart(box, changed);
    /** @type {MotionModel | null} */
    this.model = null;
    /** @type {number[]} */
    this.times = [];
    /** @type {number[]} in degrees */
    this.leans = [];
  }

  /** @param {Figure} figure */
  #compute({ body, axes, models: [model], store }) {
    if (model === this.model) return;
    this.model = model;
    this.times = evenly(0, store.state.length, points);
    const samples = model.motion.samples(this.times);
    this.leans = leans(body, axes[0], model, samples).map((lean) => (180 / Math.PI) * lean);
  }

  /** @param {Figure} figure @param {any} colors of charts @param {string} color of the curve */
  draw(figure, colors, color) {
    this.#compute(figure);
    const context = this.chart.begin(),
      { width, height, fontSize, unit } = this.chart,
      { t, length } = figure.store.state,
      least = 10 ** Math.floor(Math.log10(Math.min(...this.leans)));
    const x = (/** @type {number} */ time) => marginLeft + (time / length) * (width - marginLeft - 8);
    const y = (/** @type {number} */ lean) =>
      marginTop +
      (height - marginBottom - marginTop) *
        (1 - Math.log(Math.max(lean, least) / least) / Math.log(most / least));
    context.fillStyle = colors.dim;
    context.strokeStyle = colors.line;
    const powers = Math.round(Math.log10(100 / least)),
      every = Math.ceil(powers / 4);
    for (let power = 2; power >= 2 - powers; power -= every) {
      const at = y(10 ** power),
        name = power < -1 ? `10${superscript(power)}` : String(10 ** power);
      context.fillText(`${name}°`, 0, at + 0.35 * fontSize);
      context.strokeRect(marginLeft, Math.round(at) + 0.5, width - marginLeft, 0);
    }
    const { length: ofUnit, symbol } = timeUnit(length),
      step = tickStep(length / ofUnit, width / (90 * unit));
    for (let time = 0; time <= 0.97 * (length / ofUnit); time += step)
      context.fillText(`${tickText(time, step)} ${symbol}`, x(time * ofUnit), height - 4);
    const { rate } = figure.body.stability(1),
      { direction } = figure.body.tug,
      growing = this.leans[0] / (2 * direction[0]); // the part of a push towards the axis of least moment
    const predicted = this.times.map((time) => growing * Math.exp(rate * time)).filter((lean) => lean < most);
    this.chart.line(colors.dim, 1.5 * unit, predicted.map((lean, i) => [x(this.times[i]), y(lean)]), [6, 4]);
    this.chart.line(color, 2.2 * unit, this.leans.map((lean, i) => [x(this.times[i]), y(lean)]));
    const now = Math.round((points * Math.min(t, length)) / length);
    this.chart.disc(x(this.times[now]), y(this.leans[now]), 4.5 * unit, color, colors.panel);
  }
}
