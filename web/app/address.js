// The page's address, which holds the state: follows it, and has it say what the state is.
import { messageOf, showNote } from './dom.js';
import { linkTo, readLink } from './link.js';
import { word } from '../words/words.js';

/** @import { Reader } from './link.js' */
/** @import { Player } from './player.js' */
/** @import { Store } from './state.js' */
/** @import { State } from './types' */

const delay = 400; // ms after a change: browsers limit how often the address changes
const mostIgnored = 5; // that the note lists

export class Address {
  /**
   * @param {Store} store @param {Record<string, Reader>} known
   * @param {Player} player
   * @param {(values: Partial<State>) => void} go Puts the page into the state of a link; throws an
   *   Error for one in which it cannot be.
   */
  constructor(store, known, player, go) {
    this.store = store;
    this.known = known;
    this.player = player;
    this.go = go;
    this.own = '';
    store.subscribe(() => this.#keep());
    player.listeners.push(() => this.#keep());
    addEventListener('hashchange', () => this.follow());
  }

  /** Takes over what the address says. */
  follow() {
    if (location.hash === this.own) return;
    const { values, ignored } = readLink(location.hash, this.known);
    try {
      this.go(values);
    } catch (error) {
      ignored.push(messageOf(error));
    }
    showNote('note', ignored.length ? word('ignored', ignored.slice(0, mostIgnored).join(', ')) : '');
  }

  /** Has the address say soon what the state is; not while playing, when it always changes. */
  #keep() {
    if (this.timer !== undefined || this.player.playing) return;
    this.timer = setTimeout(() => this.#write(), delay);
  }

  #write() {
    this.timer = undefined;
    this.own = this.#hash;
    try {
      history.replaceState(null, '', this.own || location.pathname + location.search);
    } catch {
      // An <iframe> in a sandbox has no address of its own; the button to copy the link is there still.
    }
  }

  /** What the address has after the page's own for the state. */
  get #hash() {
    const hash = linkTo(this.store.state, this.store.initial);
    return hash ? `#${hash}` : '';
  }

  /** The link to the state. */
  get link() {
    return location.href.split('#')[0] + this.#hash;
  }
}
