// The theme's colours for what is drawn in two dimensions.
import { css } from '../views/canvas_view.js';

/** @param {string} name */
export function setThemeColors(name) {
  if (document.documentElement.dataset.theme !== name) document.documentElement.dataset.theme = name;
}

/** @type {{name: string, colors: any}} */
let last = { name: '', colors: null };

/**
 * Colours of charts: those of the page's style and of the film's curves.
 * @param {any} theme of the page's data @param {string} name
 */
export function chartColors({ overlay }, name) {
  if (last.name === name) return last.colors;
  const style = getComputedStyle(document.documentElement);
  const own = (/** @type {string} */ key) => style.getPropertyValue(`--${key}`).trim();
  last = {
    name,
    colors: {
      text: own('text'),
      dim: own('dim'),
      line: own('line'),
      panel: own('panel'),
      ground: own('ground'),
      accent: own('accent'),
      panelShade: `color-mix(in srgb, ${own('ground')} 82%, transparent)`,
      flip: css(overlay.omega),
      second: css(overlay.omega),
      curve: overlay.curve.map(css),
    },
  };
  return last.colors;
}
