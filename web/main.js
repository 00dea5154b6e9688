// Starts the page, and defines the interface for scripts.
import { byId, showNote } from './app/dom.js';
import { App } from './app/app.js';
import { Article } from './article/article.js';
import { languageOf } from './app/state.js';
import { readArticle, readCore, readPageData } from './app/page_data.js';
import { Core } from './core/core.js';
import { Graphics, noGraphics } from './picture/graphics.js';
import { setLanguage, setTimeUnits, word } from './words/words.js';

/** The interface for tests and for users' scripts. */
const twrench = {
  /** @type {Promise<void>} */
  ready: Promise.resolve(),
  /** @type {Core | null} For other motions than the one shown. */
  core: null,
  /** @param {number} t @returns {Promise<import("./core/types").Sample>} of the motion shown; of the first method if two are compared */
  sample: async (t) => (await working()).sample(t),
  /** The figures of the article, in order: the time in s, the angular velocities of the bodies at t = 0, and whether it plays. */
  figures: () => article?.figures() ?? [],
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
/** @type {Article | undefined} */
let article;

/** Waits for the page and returns it; throws if it cannot run. */
async function working() {
  await twrench.ready;
  if (!app) throw new Error('the page cannot run in this browser');
  return app;
}

async function start() {
  setLanguage(languageOf(navigator.languages));
  const graphics = Graphics.create();
  byId('lacks').hidden = true;
  byId('stills-note').hidden = graphics !== noGraphics;
  const data = await readPageData();
  setTimeUnits(data.time_units);
  twrench.core = await Core.load(/** @type {BufferSource} */ (await readCore()));
  const sections = data.article ? await readArticle() : null;
  app = new App(data, twrench.core, graphics);
  if (sections) article = new Article(app, sections);
  else app.player.play(!app.isStill);
}

twrench.ready = start();
twrench.ready.catch((error) => {
  showNote('note', word('cannot', error.message));
  byId('live').hidden = true;
  byId('instead').hidden = byId('lacks').hidden = false;
});
