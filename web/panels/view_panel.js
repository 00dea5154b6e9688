// What is shown and from where: theme, language, frame of reference, overlays, full screen.
import { byId, element } from '../app/dom.js';
import { features } from '../app/state.js';
import { fillSelect, word } from '../words/words.js';

/** @typedef {import("../app/state.js").State} State */

export class ViewPanel {
  /** @param {import("../app/state.js").Store} store @param {import("../app/page_data.js").PageData} data */
  constructor(store, data) {
    this.store = store;
    this.data = data;
    this.theme = this.#select('theme', (theme) => store.set({ theme }));
    this.lang = this.#select('lang', (lang) => store.set({ lang: /** @type {any} */ (lang) }));
    this.frame = this.#select('frame', (frame) => store.set({ frame: /** @type {any} */ (frame) }));
    this.boxes = features.map((feature) => this.#checkbox(feature));
    byId('reset-view').addEventListener('click', () => this.#resetView());
    byId('reset').addEventListener('click', () => {
      const { lang, theme } = store.state;
      store.set({ ...store.initial, lang, theme });
      this.#resetView();
    });
    byId('full-screen').addEventListener('click', () => {
      if (document.fullscreenElement) document.exitFullscreen();
      else
        byId('live')
          .requestFullscreen?.()
          .catch(() => {});
    });
    byId('full-screen').hidden = !document.fullscreenEnabled;
  }

  #resetView() {
    this.store.set({ view: [0, 0, 1] });
    dispatchEvent(new Event('resetview'));
  }

  /** @param {string} id @param {(value: string) => void} set */
  #select(id, set) {
    const select = /** @type {HTMLSelectElement} */ (byId(id));
    select.addEventListener('change', () => set(select.value));
    return select;
  }

  /** @param {string} feature */
  #checkbox(feature) {
    const label = element('label'),
      box = element('input'),
      text = element('span');
    box.type = 'checkbox';
    text.dataset.word = `feature_${feature}`;
    label.append(box, ' ', text);
    byId('show').append(label);
    box.addEventListener('change', () => {
      const { show } = this.store.state;
      this.store.set({
        show: features.filter((each) => (each === feature ? box.checked : show.includes(each))),
      });
    });
    return box;
  }

  relabel() {
    const { theme, frame } = this.store.state;
    fillSelect(
      this.theme,
      [
        ['auto', word('themeAuto')],
        ...Object.keys(this.data.themes).map((name) => /** @type {[string, string]} */ ([name, word(`theme_${name}`)])),
      ],
      theme,
    );
    fillSelect(
      this.frame,
      [
        ['space', word('frameSpace')],
        ['body', word('frameBody')],
        ['rotating', word('frameRotating')],
      ],
      frame,
    );
  }

  /** @param {State} state */
  show(state) {
    this.theme.value = state.theme;
    this.lang.value = state.lang;
    this.frame.value = state.frame;
    this.boxes.forEach((box, i) => (box.checked = state.show.includes(features[i])));
  }
}
