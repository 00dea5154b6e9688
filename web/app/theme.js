// The theme's colours for the page and its charts.
import { css } from '../views/canvas_view.js';

/**
 * The theme for a reader who prefers light pages: the scene's if it is light, or else the first light one.
 * @param {import("./types").PageData} data @returns {string}
 */
export function lightTheme({ scene, themes }) {
  const names = [scene.look.theme, ...Object.keys(themes)];
  return names.find((name) => themes[name].page.scheme === 'light') ?? scene.look.theme;
}

/** @type {any} The theme whose colours are set in the style sheet. */
let shown = null;

/** @param {any} theme of the page's data */
export function setThemeColors(theme) {
  if (shown === theme) return;
  shown = theme;
  const { style } = document.documentElement;
  style.colorScheme = theme.page.scheme;
  for (const [name, color] of Object.entries(theme.page.colors)) style.setProperty(`--${name}`, css(color));
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
  const names = ['text', 'dim', 'line', 'panel', 'ground', 'accent', 'second'];
  const colors = Object.fromEntries(names.map((key) => [key, own(key)]));
  const panelShade = `color-mix(in srgb, ${colors.ground} 82%, transparent)`;
  last = { name, colors: { ...colors, panelShade, curve: overlay.curve.map(css) } };
  return last.colors;
}
