// Compares two methods with the motion, which is exact or, without a closed form, that of taylor: their choice, their step, and their errors.
import { byId, radiosOf, selectOf, showNote, tableRow } from '../app/dom.js';
import { evenly } from '../app/motion_model.js';
import { nameOf } from '../app/runs.js';
import { replaced } from '../app/state.js';
import { clamp } from '../math/linear.js';
import { brief, fillSelect, superscript, word } from '../words/words.js';
import { Chart } from './chart.js';
import { NumberField } from './number_field.js';

/** @import { MotionModel } from '../app/motion_model.js' */
/** @import { Runs } from '../app/runs.js' */
/** @import { Store } from '../app/state.js' */
/** @import { PageData, State } from '../app/types' */
/** @import { Core } from '../core/core.js' */

const pointsOfChart = 240,
  marginLeft = 40,
  marginBottom = 4;
const least = 1e-16,
  greatest = 10; // of the chart of errors

export class ComparePanel {
  /**
   * @param {Store} store @param {Core} core @param {PageData} data @param {() => void} changed
   */
  constructor(store, core, { limits }, changed) {
    this.core = core;
    this.selects = ['method-a', 'method-b'].map((id, i) =>
      selectOf(id, (name) => store.set({ methods: replaced(store.state.methods, i, name) })),
    );
    for (const select of this.selects)
      fillSelect(select, core.methods.map(({ name }) => [name, nameOf(name)]), '');
    this.showMode = radiosOf('compare', (compare) => store.set({ compare }));
    const field = (/** @type {"step" | "tolerance"} */ key, /** @type {number[]} */ range) =>
      new NumberField(byId(`${key}-field`), {
        label: () => word(key),
        range,
        logarithmic: true,
        limits: limits[key],
        set: (value) => store.set({ [key]: value }),
      });
    this.step = field('step', [1e-4, 2]);
    this.tolerance = field('tolerance', [1e-12, 1e-1]);
    this.chart = new Chart(byId('error-chart'), changed);
    this.rows = [
      'attitudeError',
      'energyDrift',
      'momentumError',
      'orthogonality',
      'flipsSeen',
      'stepsTaken',
    ].map((key) => this.#row(key));
  }

  /** @param {string} key */
  #row(key) {
    const row = tableRow(word(key), ['', '']);
    byId('errors').querySelector('tbody')?.append(row);
    return { key, cells: [...row.cells] };
  }

  /** @param {State} state @param {MotionModel} model */
  show(state, { facts }) {
    this.showMode(state.compare);
    this.selects.forEach((select, i) => {
      for (const option of select.options) option.disabled = option.value === 'exact' && !facts.kind;
      select.value = state.methods[i];
    });
    const caption = byId('errors-say');
    caption.dataset.word = facts.kind ? 'errorsSay' : 'errorsSayTaylor';
    caption.textContent = word(caption.dataset.word);
    this.step.show(state.step);
    this.tolerance.show(state.tolerance);
    const used = state.methods.map((name) => this.core.method(name));
    this.step.field.hidden = used.every((method) => method.exact);
    this.tolerance.field.hidden = !used.some((method) => method.adaptive);
    const off = state.compare === 'off';
    for (const id of ['errors', 'error-chart', 'compare-note', 'name-a', 'name-b']) byId(id).hidden = off;
    byId('stage').classList.toggle('beside', state.compare === 'beside');
  }

  relabel() {
    this.step.relabel();
    this.tolerance.relabel();
  }

  /** @param {State} state @param {MotionModel} model @param {Runs} runs @param {any} colors */
  draw(state, model, runs, colors) {
    if (state.compare === 'off') return;
    const reports = runs.runners.map((runner) =>
      report(runner, model, Math.min(state.t, runner.exact ? state.t : runner.reached)),
    );
    for (const { key, cells: [head, ...cells] } of this.rows) {
      if (key === 'flipsSeen') head.parentElement?.toggleAttribute('hidden', model.facts.losesEnergy);
      head.textContent = word(key, model.flipsUntil(state.t));
      cells.forEach((cell, i) => (cell.textContent = reports[i]?.[key] ?? ''));
    }
    const notes = runs.runners
      .filter((runner) => runner.failure || !runner.knows(state.t))
      .map((runner) => runner.failure || word('reached', nameOf(runner.method), brief(runner.reached)));
    showNote('compare-note', notes.join(' · '));
    runs.runners.forEach(({ method, failure, reached }, i) => {
      const end = failure && state.t > reached ? ` · ${word('stopped', brief(reached))}` : '';
      byId(i === 0 ? 'name-a' : 'name-b').textContent = `${'AB'[i]}: ${nameOf(method)}${end}`;
    });
    this.#drawErrors(state, model, runs, colors);
  }

  /** @param {State} state @param {MotionModel} model @param {Runs} runs @param {any} colors */
  #drawErrors({ t, from, length }, model, runs, colors) {
    const context = this.chart.begin(),
      { width, height, fontSize } = this.chart;
    const y = (/** @type {number} */ error) => {
      const share = Math.log10(clamp(error, least, greatest) / least) / Math.log10(greatest / least);
      return (height - marginBottom) * (1 - share);
    };
    context.fillStyle = colors.dim;
    context.strokeStyle = colors.line;
    for (let power = -15; power <= 0; power += 5) {
      context.fillText(`10${superscript(power)}`, 0, y(10 ** power) + 0.35 * fontSize);
      context.strokeRect(marginLeft, Math.round(y(10 ** power)) + 0.5, width - marginLeft, 0);
    }
    const times = evenly(from, Math.min(t, from + length), pointsOfChart);
    runs.runners.forEach((runner, i) => {
      if (runner.exact) return;
      const samples = runner.samples(times),
        { error } = model.motion.diagnose(samples);
      const x = (/** @type {number} */ time) => marginLeft + ((time - from) / length) * (width - marginLeft),
        points = Array.from(error, (value, k) => [x(samples.t[k]), y(value / Math.SQRT2)]);
      const [color, dashes] = i === 0 ? [colors.text, []] : [colors.second, [6, 3]];
      this.chart.line(color, 1.8 * this.chart.unit, points, dashes);
    });
  }
}

/**
 * The texts and numbers about a method at t.
 * @param {Runs["runners"][0]} runner @param {MotionModel} model @param {number} t
 * @returns {Record<string, string>}
 */
function report(runner, model, t) {
  const samples = runner.samples([t]),
    found = model.motion.diagnose(samples);
  return {
    attitudeError: brief(found.error[0] / Math.SQRT2),
    energyDrift: brief(found.energyDrift[0]),
    momentumError: brief(found.momentumError[0]),
    orthogonality: brief(found.orthogonalityError[0]),
    flipsSeen: model.facts.turnsOver ? String(runner.flipsUntil(t)) : '–',
    stepsTaken: Number.isFinite(runner.steps) ? String(runner.steps) : '–',
  };
}
