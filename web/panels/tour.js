// The guided tour: steps, each a state of the page with what to look at and what to try. Its text is
// a file of its own, tour/tour.json.
import {byId, element} from "../app/dom.js";
import {word} from "../words/words.js";

/** @typedef {{title: string, text: string[], look: string, try: string}} TourText */
/** @typedef {{state: string, play: boolean, en: TourText, nb: TourText}} TourStep  `state` as in a link */

const tags = new Set(["math", "mi", "mn", "mo", "mrow", "msub", "msup", "msubsup", "mfrac", "mover", "mtext", "mspace", "msqrt", "mtable", "mtr", "mtd", "b", "i", "em", "sub", "sup"]);

/**
 * The nodes of a text with formulas; other elements become their text.
 * @param {string} text
 */
function nodesOf(text) {
  const parsed = new DOMParser().parseFromString(text, "text/html");
  const copy = (/** @type {Node} */ node) => {
    if (!(node instanceof Element)) return document.createTextNode(node.textContent ?? "");
    const name = node.localName;
    const made = tags.has(name) ? document.createElementNS(node.namespaceURI, name) : document.createDocumentFragment();
    if (made instanceof Element && node.getAttribute("display") === "block") made.setAttribute("display", "block");
    made.append(...[...node.childNodes].map(copy));
    return made;
  };
  return [...parsed.body.childNodes].map(copy);
}

export class Tour {
  /**
   * @param {TourStep[]} steps @param {import("../app/state.js").Store} store
   * @param {(step: TourStep) => void} enter Puts the page into the state of a step.
   */
  constructor(steps, store, enter) {
    this.steps = steps;
    this.store = store;
    this.enter = enter;
    this.shown = "";
    byId("open-tour").addEventListener("click", () => this.go(store.state.tour || 1));
    byId("tour-close").addEventListener("click", () => this.go(0));
    byId("tour-back").addEventListener("click", () => this.go(store.state.tour - 1));
    byId("tour-next").addEventListener("click", () => this.go((store.state.tour + 1) % (steps.length + 1)));
    byId("tour").addEventListener("keydown", (event) => {
      if (event.key === "Escape") this.go(0);
    });
  }

  /** @param {number} number of the step, from 1; 0 closes the tour */
  go(number) {
    this.store.set({tour: number});
    if (number > 0) this.enter(this.steps[number - 1]);
    byId(number > 0 ? "tour-title" : "open-tour").focus();
  }

  /** @param {import("../app/state.js").State} state */
  show({tour, lang}) {
    const key = `${tour} ${lang}`;
    if (key === this.shown) return;
    this.shown = key;
    byId("tour").hidden = tour === 0;
    document.body.classList.toggle("with-tour", tour > 0);
    if (tour === 0) return;
    const step = this.steps[tour - 1][lang];
    byId("tour-count").textContent = word("tourCount", tour, this.steps.length);
    byId("tour-title").textContent = step.title;
    const paragraphs = step.text.map((text) => this.#paragraph("", "", text));
    byId("tour-text").replaceChildren(...paragraphs, this.#paragraph("look", word("look"), step.look), this.#paragraph("try", word("try"), step.try));
    byId("tour").scrollTop = 0;
    /** @type {HTMLButtonElement} */ (byId("tour-back")).disabled = tour === 1;
    byId("tour-next").textContent = word(tour === this.steps.length ? "done" : "next");
  }

  /** @param {string} className @param {string} head @param {string} text */
  #paragraph(className, head, text) {
    const paragraph = element("p", className);
    if (head) paragraph.append(element("b", "", head));
    paragraph.append(...nodesOf(text));
    return paragraph;
  }
}
