// The motion as a table, for users of screen readers and for everyone who wants numbers.
import { byId, element, tableRow } from '../app/dom.js';
import { evenly } from '../app/motion_model.js';

/** @import { MotionModel } from '../app/motion_model.js' */
/** @import { State } from '../app/types' */

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
    const times = evenly(from, from + length, rows - 1);
    const { X, omega } = model.motion.samples(times);
    this.body.replaceChildren(
      ...times.map((time, i) => {
        const values = [...X.subarray(9 * i, 9 * i + 9), ...omega.subarray(3 * i, 3 * i + 3)];
        const texts = values.map((value) => value.toFixed(6).replace('-', '−'));
        return tableRow(String(Number(time.toPrecision(12))), texts);
      }),
    );
  }
}
