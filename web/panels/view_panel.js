// The controls of the display: theme, language, frame of reference, overlays, full screen.
import { byId, element, onClick, selectOf } from '../app/dom.js';
import { features, hasMeaning } from '../app/state.js';
import { fillSelect, word } from '../words/words.js';

/** @import { Store } from '../app/state.js' */
/** @import { PageData, State } from '../app/types' */

export class ViewPanel {
  /** @param {Store} store @param {PageData} data */
  constructor(store, data) {
    this.store = store;
    this.data = data;
    this.theme = selectOf('theme', (theme) => store.set({ theme }));
    this.lang = selectOf('lang', (lang) => store.set({ lang }));
    this.frame = selectOf('frame', (frame) => store.set({ frame }));
    this.boxes = features.map((feature) => this.#checkbox(feature));
    onClick('reset-view', () => this.#resetView());
    onClick('reset', () => {
      const { lang, theme } = store.state;
      store.set({ ...store.initial, lang, theme });
      this.#resetView();
    });
    onClick('full-screen', () => {
      if (document.fullscreenElement) document.exitFullscreen();
      else byId('live').requestFullscreen().catch(() => {});
    });
    byId('full-screen').hidden = !document.fullscreenEnabled;
  }

  #resetView() {
    this.store.set({ view: [0, 0, 1] });
    dispatchEvent(new Event('resetview'));
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
    const themes = Object.keys(this.data.themes).map((name) => [name, word(`theme_${name}`)]);
    fillSelect(this.theme, /** @type {any} */ ([['auto', word('themeAuto')], ...themes]), theme);
    const frames = [
      ['space', word('frameSpace')],
      ['body', word('frameBody')],
      ['rotating', word('frameRotating')],
    ];
    fillSelect(this.frame, /** @type {any} */ (frames), frame);
  }

  /** @param {State} state */
  show(state) {
    this.theme.value = state.theme;
    this.lang.value = state.lang;
    this.frame.value = state.frame;
    this.boxes.forEach((box, i) => {
      box.checked = state.show.includes(features[i]);
      /** @type {HTMLElement} */ (box.parentElement).hidden = !hasMeaning(features[i], state, this.data);
    });
  }
}
