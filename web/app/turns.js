// Lets at most one of several players play: the one whose picture is seen best. A player that the reader has
// paused stays paused.

/** @import { Player } from './player.js' */
/** @typedef {{player: Player, share: number, wants: boolean}} Turn */

const shares = Array.from({ length: 21 }, (_, i) => i / 20); // of a picture, at which it may get or lose its turn

export class Turns {
  /** @param {boolean} still Whether players wait until the reader starts them. */
  constructor(still) {
    this.still = still;
    /** @type {Map<Element, Turn>} */
    this.turns = new Map();
    /** @type {Turn | null} */
    this.current = null;
    this.isSwitching = false;
    this.observer = new IntersectionObserver((entries) => this.#see(entries), { threshold: shares });
  }

  /** @param {Element} picture @param {Player} player */
  add(picture, player) {
    const turn = { player, share: 0, wants: !this.still };
    this.turns.set(picture, turn);
    this.observer.observe(picture);
    player.listeners.push(() => {
      if (this.isSwitching) return;
      turn.wants = player.playing;
      if (player.playing) this.#give(turn);
    });
  }

  /** @param {IntersectionObserverEntry[]} entries */
  #see(entries) {
    for (const { target, intersectionRatio } of entries) {
      const turn = this.turns.get(target);
      if (turn) turn.share = intersectionRatio;
    }
    let best = this.current?.share ? this.current : null;
    for (const turn of this.turns.values()) if (turn.share > (best?.share ?? 0)) best = turn;
    this.#give(best);
  }

  /** @param {Turn | null} chosen */
  #give(chosen) {
    this.current = chosen;
    this.isSwitching = true;
    for (const turn of this.turns.values()) if (turn !== chosen) turn.player.play(false);
    chosen?.player.play(chosen.wants);
    this.isSwitching = false;
  }
}
