// The motion as a table: for those who do not see the pictures, and for everybody who wants numbers.
import { byId, element } from '../app/dom.js';

/** @typedef {import("../app/motion_model.js").MotionModel} MotionModel */
/** @typedef {import("../app/state.js").State} State */

const rows = 25;
const names = ['t', 'x11', 'x12', 'x13', 'x21', 'x22', 'x23', 'x31', 'x32', 'x33', 'ωx', 'ωy', 'ωz'];

export class DataTable {
  /** @param {() => void} changed */
  constructor(changed) {
    this.details = /** @type {HTMLDetailsElement} */ (byId('data'));
    this.details.addEventListener('toggle', changed);
    this.body = /** @type {HTMLElement} */ (byId('table').querySelector('tbody'));
    this.key = '';
    /** @type {MotionModel | null} */
    this.model = null;
    const head = element('tr');
    head.append(
      ...names.map((name, i) => {
        const cell = element('th', '', i === 0 ? 't, s' : name);
        cell.scope = 'col';
        return cell;
      }),
    );
    byId('table').querySelector('thead')?.append(head);
  }

  /** @param {State} state @param {MotionModel} model */
  draw({ from, length }, model) {
    const key = `${from} ${length}`;
    if (!this.details.open || (this.key === key && this.model === model)) return;
    this.key = key;
    this.model = model;
    const times = Float64Array.from({ length: rows }, (_, i) => from + (length * i) / (rows - 1));
    const { X, omega } = model.motion.samples(times);
    this.body.replaceChildren(
      ...Array.from(times, (time, i) => {
        const row = element('tr'),
          head = element('th', '', String(Number(time.toPrecision(12))));
        head.scope = 'row';
        const values = [...X.subarray(9 * i, 9 * i + 9), ...omega.subarray(3 * i, 3 * i + 3)];
        row.append(head, ...values.map((value) => element('td', '', value.toFixed(6).replace('-', '−'))));
        return row;
      }),
    );
  }
}
