// A number with a slider and a text field. The slider covers the usual range, the text field all
// allowed values.
import { element } from '../app/dom.js';
import { clamp } from '../math/linear.js';
import { brief, word } from '../words/words.js';

/**
 * @typedef {object} NumberFieldOptions
 * @property {() => string} label The label for screen readers.
 * @property {string} [name] The visible name; default: the label.
 * @property {number[]} range Of the slider.
 * @property {boolean} [logarithmic] Whether the slider is logarithmic.
 * @property {number[]} limits The least and the greatest allowed value. If that is infinite, so is the slider's end.
 * @property {() => string} [hint] The tooltip; default: the label.
 * @property {(value: number) => void} set
 */

let nextId = 0;

/**
 * Calls set() with the number in a text field if it is allowed; otherwise marks the field as invalid.
 * @param {HTMLInputElement} input @param {number[]} limits @param {(value: number) => void} set
 * @param {boolean} done Whether the reader has finished typing.
 */
export function readNumber(input, [low, high], set, done) {
  const text = input.value.trim().replace(',', '.').replace('−', '-').replace(/^(∞|inf)$/, 'Infinity');
  const value = text === '' ? NaN : Number(text);
  const fits = value >= low && value <= high;
  input.ariaInvalid = String(!fits);
  input.setCustomValidity(fits ? '' : word('badNumber', brief(low), brief(high)));
  if (fits) set(value);
  else if (done) input.reportValidity();
}

/**
 * A number for a text field, which has room for about eight characters. Longer numbers have a power of ten.
 * @param {number} value @param {number} digits at most
 */
export function fieldText(value, digits) {
  const short = Number(value.toPrecision(digits));
  return Math.abs(short) >= 1e8 ? short.toExponential().replace('+', '') : String(short);
}

export class NumberField {
  /** @param {HTMLElement} box @param {NumberFieldOptions} options */
  constructor(box, options) {
    this.options = options;
    this.field = element('div', options.name ? 'field' : 'field long');
    this.name = element('label', 'name');
    this.slider = element('input');
    this.slider.type = 'range';
    this.slider.step = 'any';
    this.text = element('input');
    this.text.inputMode = 'decimal';
    this.text.id = `number-${++nextId}`;
    this.name.htmlFor = this.text.id;
    this.field.append(this.name, this.slider, this.text);
    box.append(this.field);
    this.span = 1;
    this.slider.addEventListener('input', () => {
      const value = Number(this.slider.value);
      // A pointer finds 0 within a hundredth of the slider.
      options.set(!options.logarithmic && Math.abs(value) < this.span / 200 ? 0 : this.#fromSlider(value));
    });
    this.slider.addEventListener('keydown', (event) => this.#nudge(event));
    for (const type of /** @type {const} */ (['input', 'change']))
      this.text.addEventListener(type, () => readNumber(this.text, options.limits, options.set, type === 'change'));
    this.relabel();
    this.setRange(options.range);
  }

  relabel() {
    const label = this.options.label();
    this.name.textContent = this.options.name ?? label;
    this.slider.setAttribute('aria-label', label);
    if (this.options.name) this.text.setAttribute('aria-label', label);
    this.field.title = this.options.hint?.() ?? label;
  }

  /** @param {number[]} range */
  setRange(range) {
    const ends = this.options.logarithmic ? range.map(Math.log10) : range;
    [this.slider.min, this.slider.max] = ends.map(String);
    this.span = ends[1] - ends[0];
  }

  /** @param {number} value */
  #fromSlider(value) {
    const { logarithmic, limits } = this.options;
    if (limits[1] === Infinity && value >= Number(this.slider.max)) return Infinity;
    return Number((logarithmic ? 10 ** value : value).toPrecision(logarithmic ? 3 : 6));
  }

  /** Handles arrow keys: steps of 1 % of the slider, 0.1 % with Shift. @param {KeyboardEvent} event */
  #nudge(event) {
    const direction = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
    if (!direction) return;
    event.preventDefault();
    const step = (direction * this.span) / (event.shiftKey ? 1000 : 100);
    const { value: now, min, max } = this.slider,
      value = clamp(Number(now) + step, Number(min), Number(max));
    this.slider.value = String(value);
    this.options.set(this.#fromSlider(value));
  }

  /** @param {number} value */
  show(value) {
    const { logarithmic } = this.options;
    this.slider.value = value === Infinity ? this.slider.max : String(logarithmic ? Math.log10(value) : value);
    if (document.activeElement === this.text) return;
    this.text.value = value === Infinity ? '∞' : fieldText(value, 8);
    this.text.ariaInvalid = 'false';
    this.text.setCustomValidity('');
  }
}
