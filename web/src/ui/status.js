// The message at the top of the picture: what the ruler measured, or what was saved. A message
// about something finished goes away by itself.

/** @import {Store} from '../store.js' */

const kShort = 4000; // ms

export class Status {
  /**
   * @param {HTMLElement} root
   * @param {Store} store
   */
  constructor(root, store) {
    this.root = root;
    this.store = store;
    /** @type {number | undefined} */
    this.timer = undefined;
    store.on(['status'], ({ status }) => {
      root.textContent = status;
      root.hidden = !status;
    });
  }

  /**
   * Shows a message for a few seconds.
   * @param {string} text
   */
  say(text) {
    this.store.set({ status: text });
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      if (this.store.state.status === text) this.store.set({ status: '' });
    }, kShort);
  }
}
