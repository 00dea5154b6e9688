// Keeps the state in the page's address: reads it when the address changes, and updates it.
import { byId, messageOf, showNote } from './dom.js';
import { linkTo, readLink } from './link.js';
import { word } from '../words/words.js';

/** @import { Reader } from './link.js' */
/** @import { Player } from './player.js' */
/** @import { Store } from './state.js' */
/** @import { State } from './types' */

const delay = 400; // ms after a change: browsers limit how often the address changes
const mostIgnored = 5; // unknown parameters listed in the note

export class Address {
  /**
   * @param {Store} store @param {Record<string, Reader>} known
   * @param {Player} player
   * @param {(values: Partial<State>) => void} go Puts the page into the state of a link; throws an
   *   Error if that state is impossible.
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

  /** Applies the state in the address. */
  follow() {
    if (location.hash === this.own || byId(location.hash.slice(1))) return; // or a link to a part of the page
    const { values, ignored } = readLink(location.hash, this.known);
    try {
      this.go(values);
    } catch (error) {
      ignored.push(messageOf(error));
    }
    showNote('note', ignored.length ? word('ignored', ignored.slice(0, mostIgnored).join(', ')) : '');
  }

  /** Schedules an update of the address; not while playing, because the state then changes all the time. */
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
      // A sandboxed <iframe> has no address that can change; the button that copies the link still works.
    }
  }

  /** The part of the address that holds the state. */
  get #hash() {
    const hash = linkTo(this.store.state, this.store.initial);
    return hash ? `#${hash}` : '';
  }

  /** The link to the state. */
  get link() {
    return location.href.split('#')[0] + this.#hash;
  }
}
