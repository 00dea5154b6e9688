// The buttons that copy or save something.
import { byId, messageOf, onClick, showNote } from '../app/dom.js';
import { commandLine, csv, sceneFile } from '../app/take_away.js';
import { word } from '../words/words.js';

/** @import { MotionModel } from '../app/motion_model.js' */
/** @import { PageData } from '../app/types' */
/** @import { Store } from '../app/state.js' */

/** @param {string} text */
async function copy(text) {
  showNote('copied', text);
  try {
    await navigator.clipboard.writeText(text);
    byId('announce').textContent = word('copied');
  } catch {
    // Not allowed in a frame, nor in some browsers for a page opened from a file.
    byId('announce').textContent = word('notCopied');
    getSelection()?.selectAllChildren(byId('copied'));
  }
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
  /**
   * @param {{store: Store, data: PageData, model: () => MotionModel, theme: () => string, link: () => string, picture: () => Promise<Blob>}} shown
   *   The picture is a PNG.
   */
  constructor({ store, data, model, theme, link, picture }) {
    const name = data.scene.name ?? 'twrench';
    onClick('copy-link', () => copy(link()));
    onClick('copy-command', () => copy(commandLine(store.state, data, theme(), model())));
    onClick('copy-scene', () => copy(sceneFile(store.state, data, theme(), model())));
    onClick('save-png', async () => save(await picture(), `${name}.png`));
    onClick('save-csv', () => {
      try {
        const text = csv(store.state, model(), data.scene.film.fps);
        save(new Blob([text], { type: 'text/csv' }), `${name}.csv`);
      } catch (error) {
        showNote('copied', messageOf(error)); // the method shown cannot compute this
      }
    });
  }
}
