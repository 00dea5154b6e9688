// The buttons by which the reader takes something along.
import { byId } from '../app/dom.js';
import { commandLine, csv, sceneFile } from '../app/take_away.js';
import { word } from '../words/words.js';

/**
 * @typedef {object} Shown
 * @property {import("../app/state.js").Store} store
 * @property {import("../app/page_data.js").PageData} data
 * @property {() => import("../app/motion_model.js").MotionModel} model
 * @property {() => string} theme
 * @property {() => string} link
 * @property {() => Promise<Blob>} picture A PNG.
 */

/** @param {string} text */
async function copy(text) {
  const box = byId('copied');
  box.hidden = false;
  box.textContent = text;
  let done = true;
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    done = false; // not allowed in a frame, or on a page from a file in some browsers
  }
  byId('announce').textContent = word(done ? 'copied' : 'notCopied');
  if (!done) getSelection()?.selectAllChildren(box);
}

/** @param {Blob} blob @param {string} name */
function save(blob, name) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

export class TakeAway {
  /** @param {Shown} shown */
  constructor({ store, data, model, theme, link, picture }) {
    const on = (/** @type {string} */ id, /** @type {() => void} */ act) =>
      byId(id).addEventListener('click', act);
    const { name } = data.scene;
    on('copy-link', () => copy(link()));
    on('copy-command', () => copy(commandLine(store.state, data, theme())));
    on('copy-scene', () => copy(sceneFile(store.state, data, theme())));
    on('save-png', async () => save(await picture(), `${name ?? 'twrench'}.png`));
    on('save-csv', () => {
      try {
        const text = csv(store.state, model(), data.scene.film.fps);
        save(new Blob([text], { type: 'text/csv' }), `${name ?? 'twrench'}.csv`);
      } catch (error) {
        byId('copied').hidden = false; // the method that is shown cannot compute this
        byId('copied').textContent = error instanceof Error ? error.message : String(error);
      }
    });
  }
}
