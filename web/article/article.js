// The article: sections of text, each with a figure. The figures play one at a time, while they are on the
// screen.
import { byId, element } from '../app/dom.js';
import { readLink } from '../app/link.js';
import { Turns } from '../app/turns.js';
import { css } from '../views/canvas_view.js';
import { setLanguage } from '../words/words.js';
import { Body, isReplaced } from './body.js';
import { Figure } from './figure.js';
import { paragraph } from './markup.js';

/** @import { App } from '../app/app.js' */
/** @import { Section } from './types' */

/** A section of the article on the page. */
class Part {
  /** @param {Section} section @param {App} app @param {Body} body */
  constructor(section, app, body) {
    this.section = section;
    this.element = element('section');
    this.element.id = `part-${section.id}`;
    this.title = element('h2');
    this.title.id = `${this.element.id}-title`;
    this.element.setAttribute('aria-labelledby', this.title.id);
    this.text = element('div', 'text');
    this.figure = new Figure(section.figure, app, body, this.element);
    this.figure.element.setAttribute('aria-labelledby', this.title.id);
    this.element.append(this.title, this.figure.element, this.text);
  }

  /** @param {"en" | "nb"} lang */
  write(lang) {
    const { title, text, caption, readout } = this.section[lang],
      { figure } = this;
    const written = (/** @type {string} */ line) =>
      paragraph(line, figure.store.state.show, (features) => figure.stress(features)).childNodes;
    this.title.textContent = title;
    this.text.replaceChildren(...text.map((line) => wrapped(written(line))), ...this.#formula());
    figure.caption.replaceChildren(...written(caption));
    figure.readout.replaceChildren(...written(readout));
    figure.relabel();
  }

  /** The formula as MathML, or as text in a browser without it. */
  #formula() {
    const { formula } = this.section;
    if (!formula) return [];
    const made = element('p', 'formula', formula.text);
    if (typeof MathMLElement === 'function')
      made.replaceChildren(...new DOMParser().parseFromString(formula.math, 'text/html').body.childNodes);
    return [made];
  }
}

/** @param {NodeListOf<ChildNode>} nodes */
function wrapped(nodes) {
  const made = element('p');
  made.append(...nodes);
  return made;
}

/** Whether the address is a link to a state of the lab, not only to a theme or a language. @param {App} app */
const linksToLab = ({ known }) =>
  Object.keys(readLink(location.hash, known).values).some((key) => !['theme', 'lang'].includes(key));

export class Article {
  /** @param {App} app @param {Section[]} sections */
  constructor(app, sections) {
    this.app = app;
    const asBox = isReplaced(app.core, app.data),
      own = new Body(app.core, app.data, false);
    this.body = asBox ? new Body(app.core, app.data, true) : own;
    this.root = byId('article');
    this.parts = sections
      .filter(({ when }) => !when || { replaced: asBox, recorded: app.data.recording }[when])
      .map((section) => new Part(section, app, section.when ? own : this.body));
    this.root.append(...this.parts.map((part) => part.element));
    for (const id of ['article', 'lab', 'to-lab']) byId(id).hidden = false;
    this.#write();
    this.#color();
    app.store.subscribe((state, before) => {
      if (state.lang !== before.lang) this.#write();
      if (state.theme !== before.theme) this.#color();
    });
    app.themeListeners.push(() => this.#color());
    const turns = new Turns(app.isStill);
    for (const { figure } of this.parts) turns.add(figure.element, figure.player);
    turns.add(byId('stage'), app.player);
    if (linksToLab(app)) byId('lab').scrollIntoView();
  }

  figures() {
    return this.parts.map(({ section: { id }, figure: { store, models, player } }) => ({
      id,
      t: store.state.t,
      omegas: models.map(({ omega }) => omega),
      plays: player.playing,
    }));
  }

  #write() {
    const { lang } = this.app.store.state;
    for (const part of this.parts) part.write(lang);
    setLanguage(lang); // for the labels of the canvases
  }

  /** Sets the colours of the things that the texts name, and of the panel on which they are legible. */
  #color() {
    const { axis, momentum, omega, trail, plane, forces, panel } = this.app.theme.overlay;
    const [least, middle, greatest] = this.body.bodyAxes.map((index) => axis[index]);
    const things = { least, middle, greatest, momentum, omega, trail, plane, lean: trail, ground: panel, ...forces };
    for (const [thing, color] of Object.entries(things)) this.root.style.setProperty(`--thing-${thing}`, css(color));
    for (const { figure } of this.parts) figure.player.invalidate();
  }
}
