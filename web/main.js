// Puts the page together: the state, what shows it, and what changes it.
import { byId, showNote } from './app/dom.js';
import { App } from './app/app.js';
import { languageOf } from './app/state.js';
import { readCore, readPageData } from './app/page_data.js';
import { Core } from './core/core.js';
import { setLanguage, word } from './words/words.js';

/** What a test, or a user's own script, can ask. */
const twrench = {
  /** @type {Promise<void>} */
  ready: Promise.resolve(),
  /** @type {Core | null} For motions of the asker's own. */
  core: null,
  /** @param {number} t @returns {Promise<import("./core/types").Sample>} of the motion shown; of the first method where two are compared */
  sample: async (t) => (await working()).sample(t),
  /** @param {import("./app/app.js").PictureOptions} options @returns {Promise<string>} a PNG as a data URL */
  picture: async (options) => {
    const blob = await (await working()).picture(options);
    const bytes = new Uint8Array(await blob.arrayBuffer());
    return `data:image/png;base64,${btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''))}`;
  },
};
Object.assign(window, { twrench });

/** @type {App | undefined} */
let app;

/** The page at work; throws where it cannot. */
async function working() {
  await twrench.ready;
  if (!app) throw new Error('WebGL 2 is not available in this browser');
  return app;
}

async function start() {
  setLanguage(languageOf(navigator.languages));
  if (!document.createElement('canvas').getContext('webgl2')) return;
  const data = await readPageData();
  twrench.core = await Core.load(/** @type {BufferSource} */ (await readCore()));
  app = new App(data, twrench.core);
}

twrench.ready = start();
twrench.ready.catch((error) => {
  showNote('note', word('cannot', error.message));
  byId('live').hidden = true;
  byId('instead').hidden = false;
});
