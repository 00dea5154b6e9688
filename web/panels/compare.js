// Two methods against the exact motion: which, with what step, and what becomes of them.
import { byId, element } from '../app/dom.js';
import { brief, fillSelect, superscript, word } from '../words/words.js';
import { Chart } from './chart.js';
import { NumberField } from './number_field.js';

/** @typedef {import("../app/motion_model.js").MotionModel} MotionModel */
/** @typedef {import("../app/runs.js").Runs} Runs */
/** @typedef {import("../app/state.js").State} State */

const pointsOfChart = 240,
  marginLeft = 40,
  marginBottom = 4;
const least = 1e-16,
  greatest = 10; // of the chart of errors

export class ComparePanel {
  /**
   * @param {import("../app/state.js").Store} store @param {import("../core/core.js").Core} core
   * @param {import("../app/page_data.js").PageData} data @param {() => void} changed
   */
  constructor(store, core, { limits }, changed) {
    this.core = core;
    this.selects = [byId('method-a'), byId('method-b')].map(
      (select) => /** @type {HTMLSelectElement} */ (select),
    );
    this.selects.forEach((select, i) => {
      fillSelect(
        select,
        core.methods.map(({ name }) => [name, name]),
        store.state.methods[i],
      );
      select.addEventListener('change', () =>
        store.set({ methods: store.state.methods.map((method, k) => (k === i ? select.value : method)) }),
      );
    });
    this.modes = /** @type {NodeListOf<HTMLInputElement>} */ (
      document.querySelectorAll('input[name=compare]')
    );
    for (const mode of this.modes)
      mode.addEventListener('change', () => store.set({ compare: /** @type {any} */ (mode.value) }));
    this.step = new NumberField(byId('step-field'), {
      label: () => word('step'),
      range: [1e-4, 2],
      logarithmic: true,
      limits: limits.step,
      set: (step) => store.set({ step }),
    });
    this.tolerance = new NumberField(byId('tolerance-field'), {
      label: () => word('tolerance'),
      range: [1e-12, 1e-1],
      logarithmic: true,
      limits: limits.tolerance,
      set: (tolerance) => store.set({ tolerance }),
    });
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
    const row = element('tr'),
      head = element('th', '', word(key));
    head.scope = 'row';
    const cells = [element('td'), element('td')];
    row.append(head, ...cells);
    byId('errors').querySelector('tbody')?.append(row);
    return { key, head, cells };
  }

  /** @param {State} state */
  show(state) {
    for (const mode of this.modes) mode.checked = mode.value === state.compare;
    this.selects.forEach((select, i) => (select.value = state.methods[i]));
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
    for (const { key, head, cells } of this.rows) {
      head.textContent = word(key, model.flipsUntil(state.t));
      cells.forEach((cell, i) => (cell.textContent = reports[i]?.[key] ?? ''));
    }
    const notes = runs.runners
      .filter((runner) => runner.failure || !runner.knows(state.t))
      .map((runner) => runner.failure || word('reached', runner.method, brief(runner.reached)));
    const note = byId('compare-note'),
      text = notes.join(' · ');
    if (note.textContent !== text) note.textContent = text;
    runs.runners.forEach(({ method, failure, reached }, i) => {
      const end = failure && state.t > reached ? ` · ${word('stopped', brief(reached))}` : '';
      byId(i === 0 ? 'name-a' : 'name-b').textContent = `${'AB'[i]}: ${method}${end}`;
    });
    this.#drawErrors(state, model, runs, colors);
  }

  /** @param {State} state @param {MotionModel} model @param {Runs} runs @param {any} colors */
  #drawErrors({ t, from, length }, model, runs, colors) {
    const context = this.chart.begin(),
      { width, height, fontSize } = this.chart;
    const y = (/** @type {number} */ error) => {
      const share =
        Math.log10(Math.min(Math.max(error, least), greatest) / least) / Math.log10(greatest / least);
      return (height - marginBottom) * (1 - share);
    };
    context.fillStyle = colors.dim;
    context.strokeStyle = colors.line;
    for (let power = -15; power <= 0; power += 5) {
      context.fillText(`10${superscript(power)}`, 0, y(10 ** power) + 0.35 * fontSize);
      context.strokeRect(marginLeft, Math.round(y(10 ** power)) + 0.5, width - marginLeft, 0);
    }
    const end = Math.min(t, from + length);
    const times = Array.from(
      { length: pointsOfChart + 1 },
      (_, i) => from + ((end - from) * i) / pointsOfChart,
    );
    runs.runners.forEach((runner, i) => {
      if (runner.exact) return;
      const samples = runner.samples(times),
        { error } = model.motion.diagnose(samples);
      context.beginPath();
      error.forEach((value, k) =>
        context.lineTo(
          marginLeft + ((samples.t[k] - from) / length) * (width - marginLeft),
          y(value / Math.SQRT2),
        ),
      );
      context.strokeStyle = i === 0 ? colors.text : colors.second;
      context.setLineDash(i === 0 ? [] : [6, 3]);
      context.lineWidth = 1.8 * this.chart.unit;
      context.stroke();
      context.setLineDash([]);
    });
  }
}

/**
 * What there is to say of a method at t.
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
    flipsSeen: model.flips ? String(runner.flipsUntil(t)) : '–',
    stepsTaken: runner.exact ? '–' : String(runner.steps),
  };
}
