// The texts of the page in the reader's language.
import en from './en.json';
import nb from './nb.json';

/** @type {Record<string, Record<string, string>>} */
const dictionaries = { en, nb };

let dictionary = dictionaries.en;
let locale = 'en';

/**
 * The text with this key, with {0}, {1} ... replaced.
 * @param {string} key @param {(string | number)[]} values
 */
export function word(key, ...values) {
  return (dictionary[key] ?? key).replace(/\{(\d)\}/g, (_, i) => String(values[Number(i)] ?? ''));
}

/** Sets the texts of all elements that refer to them. @param {string} lang */
export function setLanguage(lang) {
  dictionary = dictionaries[lang] ?? en;
  locale = lang;
  document.documentElement.lang = lang;
  for (const element of document.querySelectorAll('[data-word]')) {
    element.textContent = word(/** @type {HTMLElement} */ (element).dataset.word ?? '');
  }
  for (const element of document.querySelectorAll('[data-word-label]')) {
    const label = word(/** @type {HTMLElement} */ (element).dataset.wordLabel ?? '');
    element.setAttribute('aria-label', label);
    if (element instanceof HTMLButtonElement) element.title = label;
  }
}

/** A number with `digits` decimals in the style of the language. @param {number} value @param {number} digits */
export const decimal = (value, digits) =>
  value.toLocaleString(locale, {
    minimumFractionDigits: digits,
    maximumFractionDigits: digits,
    useGrouping: false,
  });

/** @param {number} power of ten, as superscript digits */
export const superscript = (power) =>
  [...String(power)].map((digit) => (digit === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(digit)])).join('');

/** @type {[number, number, string][]} see PageData.time_units */
let timeUnits = [[0, 1, 's']];

/** @param {[number, number, string][]} units the program's, the longest first */
export function setTimeUnits(units) {
  timeUnits = units;
}

/** The unit that suits times up to `longest`. @param {number} longest s */
export function timeUnit(longest) {
  const [, length, symbol] = timeUnits.find(([from]) => longest >= from) ?? timeUnits[timeUnits.length - 1];
  return { length, symbol };
}

/** A time with its unit: 23.6 s, 1.5 d. @param {number} seconds */
export function duration(seconds) {
  if (!Number.isFinite(seconds)) return '∞';
  const { length, symbol } = timeUnit(Math.abs(seconds) || 1);
  return `${brief(seconds / length)} ${symbol}`;
}

/** A number with three significant digits; small ones as 1.2·10⁻⁸. @param {number} value */
export function brief(value) {
  if (!Number.isFinite(value)) return '∞';
  if (value === 0) return '0';
  return isPlain(value) ? written(plain(value), '') : written(...split(value, 1));
}

/** A number with six significant digits. @param {number} value */
export const precise = (value) => (isPlain(value) ? written(value.toPrecision(6), '') : written(...split(value, 5)));

/** @param {number} value */
const isPlain = (value) => Math.abs(value) >= 1e-3 && Math.abs(value) < 1e5;

/** @param {number} value @param {number} decimals @returns {[string, string]} its digits and its power of ten */
const split = (value, decimals) => /** @type {[string, string]} */ (value.toExponential(decimals).split('e'));

/** @param {string} digits @param {string} power of ten */
function written(digits, power) {
  const text = power ? `${digits}·10${superscript(Number(power))}` : digits;
  return text.replaceAll('-', '−').replace('.', locale === 'nb' ? ',' : '.');
}

/** @param {number} value from 0.001 to 100000 */
const plain = (value) => (Math.abs(value) < 100 ? value.toPrecision(3) : value.toFixed(0));

/** Fills a select. @param {HTMLSelectElement} select @param {[string, string][]} options value and text @param {string} chosen */
export function fillSelect(select, options, chosen) {
  select.replaceChildren(...options.map(([value, text]) => new Option(text, value, false, value === chosen)));
}
