// The guided tour: steps, each with a state of the page, something to look at and something to try. The
// texts are in tour/tour.json.
import { byId, element, onClick } from '../app/dom.js';
import { word } from '../words/words.js';

/** @typedef {{title: string, text: string[], look: string, try: string}} TourText */
/**
 * @typedef {object} TourStep
 * @property {"least" | "middle" | "greatest"} spin The principal axis about which the body is spun.
 * @property {number} push Deviation from the axis, as a fraction of the angular velocity.
 * @property {number} flips The length of the timeline, in intervals between the flips of the middle axis.
 * @property {number} flipSeconds Duration of such an interval on the screen, s.
 * @property {number} [radiansOfStep] Rotation of the body in a step of the methods, rad.
 * @property {string} state The rest of the page's state, as in a link.
 * @property {boolean} play
 * @property {string} formula MathML.
 * @property {TourText} en @property {TourText} nb
 */

export class Tour {
  /**
   * @param {TourStep[]} steps @param {import("../app/state.js").Store} store
   * @param {(step: TourStep) => void} enter Puts the page into the state of a step.
   * @param {() => Record<string, string>} figures The values of {first} and similar placeholders in the texts.
   */
  constructor(steps, store, enter, figures) {
    this.steps = steps;
    this.store = store;
    this.enter = enter;
    this.figures = figures;
    this.shown = '';
    onClick('open-tour', () => this.go(store.state.tour || 1));
    onClick('tour-close', () => this.go(0));
    onClick('tour-back', () => this.go(store.state.tour - 1));
    onClick('tour-next', () => this.go((store.state.tour + 1) % (steps.length + 1)));
    byId('tour').addEventListener('keydown', (event) => {
      if (event.key === 'Escape') this.go(0);
    });
  }

  /** @param {number} number of the step, from 1; 0 closes the tour */
  go(number) {
    this.store.set({ tour: number });
    if (number > 0) this.enter(this.steps[number - 1]);
    byId(number > 0 ? 'tour-title' : 'open-tour').focus();
  }

  /** @param {import("../app/types").State} state */
  show({ tour, lang }) {
    const key = `${tour} ${lang}`;
    if (key === this.shown) return;
    this.shown = key;
    byId('tour').hidden = tour === 0;
    document.body.classList.toggle('with-tour', tour > 0);
    if (tour === 0) return;
    const { formula, [lang]: step } = this.steps[tour - 1];
    const figures = this.figures();
    const filled = (/** @type {string} */ text) =>
      text.replace(/\{(\w+)\}/g, (_, name) => figures[name] ?? '?');
    byId('tour-count').textContent = word('tourCount', tour, this.steps.length);
    byId('tour-title').textContent = step.title;
    byId('tour-text').replaceChildren(
      ...[...step.text, formula].filter(Boolean).map((text) => paragraph('', '', filled(text))),
      paragraph('look', word('look'), step.look),
      paragraph('try', word('try'), filled(step.try)),
    );
    byId('tour-text').scrollTop = 0;
    /** @type {HTMLButtonElement} */ (byId('tour-back')).disabled = tour === 1;
    byId('tour-next').textContent = word(tour === this.steps.length ? 'done' : 'next');
  }
}

/**
 * A paragraph of a text with formulas. The text is trusted; only its numbers come from the motion.
 * @param {string} className @param {string} head @param {string} text
 */
function paragraph(className, head, text) {
  const made = element('p', className);
  if (head) made.append(element('b', '', head));
  made.append(...new DOMParser().parseFromString(text, 'text/html').body.childNodes);
  return made;
}
