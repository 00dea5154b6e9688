// A button that plays and pauses.
import { word } from '../words/words.js';

const playIcon = 'M4 2 L15 9 L4 16 Z',
  pauseIcon = 'M3 2 H7 V16 H3 Z M11 2 H15 V16 H11 Z';

export class PlayButton {
  /** @param {HTMLElement} button @param {import("../app/player.js").Player} player */
  constructor(button, player) {
    this.button = button;
    this.player = player;
    const space = 'http://www.w3.org/2000/svg',
      svg = document.createElementNS(space, 'svg');
    svg.setAttribute('viewBox', '0 0 18 18');
    svg.setAttribute('width', '1em');
    svg.setAttribute('aria-hidden', 'true');
    this.icon = document.createElementNS(space, 'path');
    this.icon.setAttribute('fill', 'currentColor');
    svg.append(this.icon);
    button.replaceChildren(svg);
    button.addEventListener('click', () => player.play(!player.playing));
    player.listeners.push(() => this.relabel());
  }

  relabel() {
    const { playing } = this.player;
    this.icon.setAttribute('d', playing ? pauseIcon : playIcon);
    this.button.ariaLabel = this.button.title = word(playing ? 'pause' : 'play');
  }
}
