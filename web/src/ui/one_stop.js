// A list with a single tab stop. With keyboard focus, the arrow keys, Home, End, Page Up and Page
// Down move between rows, and Enter and Space select. After a mouse click all keys stay with the
// page.
import { keepingFocus } from './dom.js';

const kRow = '[role=option]:not([hidden])';

export class OneStop {
  /**
   * `list`: an element whose rows have the role "option" and are not in the tab order.
   * @param {HTMLElement} list
   */
  constructor(list) {
    this.list = list;
    /** @type {HTMLElement | null} */
    this.stop = null; // the row in the tab order
    list.tabIndex = -1; // some browsers make scrolling elements tab stops
    list.addEventListener('focusin', () => this.settle());
    list.addEventListener('keydown', (event) => this.press(event));
    list.addEventListener('click', ({ detail }) => {
      if (detail > 0) this.leave();
    });
  }

  /** @returns {HTMLElement[]} */
  rows() {
    /** @type {NodeListOf<HTMLElement>} */
    const rows = this.list.querySelectorAll(kRow);
    return [...rows];
  }

  /** @returns {HTMLElement | null} */
  focused() {
    const row = document.activeElement;
    const isRow = row instanceof HTMLElement && this.list.contains(row) && row.matches(kRow);
    return isRow ? row : null;
  }

  // Removes the focus from the rows and from the list, which gets the focus when a click hits no
  // row.
  leave() {
    const focused = document.activeElement;
    if (focused instanceof HTMLElement && this.list.contains(focused)) focused.blur();
  }

  // Updates the tab stop: the focused row, else the selected row, else the previous one.
  settle() {
    const { list, stop } = this;
    /** @type {HTMLElement | null} */
    const chosen = list.querySelector(`${kRow}[aria-selected=true]`);
    /** @type {HTMLElement | null} */
    const first = list.querySelector(kRow);
    const before = stop && list.contains(stop) && !stop.hidden ? stop : first;
    const row = this.focused() ?? chosen ?? before;
    if (stop) stop.tabIndex = -1;
    if (row) row.tabIndex = 0;
    this.stop = row;
  }

  /**
   * Calls `fill`, which recreates the rows. The focus stays on its row, or moves to the row in its
   * place.
   * @param {() => void} fill
   */
  refill(fill) {
    const row = this.focused();
    const at = row ? this.rows().indexOf(row) : -1;
    keepingFocus(this.list, fill);
    if (row && !this.focused()) {
      const rows = this.rows();
      rows[Math.min(at, rows.length - 1)]?.focus({ preventScroll: true });
    }
    this.settle();
  }

  /** @param {KeyboardEvent} event */
  press(event) {
    const { key, shiftKey } = event;
    const row = this.focused();
    if (!row || event.ctrlKey || event.altKey || event.metaKey) return;
    const rows = this.rows();
    const at = rows.indexOf(row);
    const page = Math.max(1, Math.floor(this.list.clientHeight / row.offsetHeight) - 1);
    /** @type {Record<string, number | undefined>} */
    const places = {
      ArrowUp: at - 1,
      ArrowDown: at + 1,
      PageUp: at - page,
      PageDown: at + page,
      Home: 0,
      End: rows.length,
    };
    const to = places[key];
    if (to !== undefined) rows[Math.max(0, Math.min(to, rows.length - 1))].focus();
    // On the selected row, Space plays as elsewhere on the page.
    else if (key === 'Enter' || (key === ' ' && row.getAttribute('aria-selected') !== 'true'))
      row.dispatchEvent(new MouseEvent('click', { bubbles: true, shiftKey }));
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}
