// A list as one stop of Tab. With the keyboard in it the arrow keys, Home, End, Page Up and Page Down go from row to
// row, Enter and Space choose; what the mouse has clicked leaves all keys to the page.
import { keepingFocus } from './dom.js';

const kRow = '[role=option]:not([hidden])';

export class OneStop {
  // `list`: its rows have the role option, and no place in the order of Tab.
  constructor(list) {
    this.list = list;
    this.stop = null; // the row that Tab reaches
    list.tabIndex = -1; // some browsers make what scrolls a stop of its own
    list.addEventListener('focusin', () => this.settle());
    list.addEventListener('keydown', (event) => this.press(event));
    list.addEventListener('click', ({ detail }) => detail > 0 && this.leave());
  }

  rows() {
    return [...this.list.querySelectorAll(kRow)];
  }

  focused() {
    const row = document.activeElement;
    return this.list.contains(row) && row.matches(kRow) ? row : null;
  }

  // The keyboard is on no row, nor on the list, which takes it where the mouse meets no row.
  leave() {
    if (this.list.contains(document.activeElement)) document.activeElement.blur();
  }

  // What Tab reaches: where the keyboard is, else the chosen row, else where it was.
  settle() {
    const { list, stop } = this;
    const row =
      this.focused() ??
      list.querySelector(`${kRow}[aria-selected=true]`) ??
      (list.contains(stop) && !stop.hidden ? stop : list.querySelector(kRow));
    if (stop) stop.tabIndex = -1;
    if (row) row.tabIndex = 0;
    this.stop = row;
  }

  // Runs `fill`, which makes the rows anew. The keyboard stays on its row; where that is gone, on the one in its
  // place.
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

  press(event) {
    const { key, shiftKey } = event;
    const row = this.focused();
    if (!row || event.ctrlKey || event.altKey || event.metaKey) return;
    const rows = this.rows();
    const at = rows.indexOf(row);
    const page = Math.max(1, Math.floor(this.list.clientHeight / row.offsetHeight) - 1);
    const to = {
      ArrowUp: at - 1,
      ArrowDown: at + 1,
      PageUp: at - page,
      PageDown: at + page,
      Home: 0,
      End: rows.length,
    }[key];
    if (to !== undefined) rows[Math.max(0, Math.min(to, rows.length - 1))].focus();
    // On the chosen row Space plays, as elsewhere.
    else if (key === 'Enter' || (key === ' ' && row.getAttribute('aria-selected') !== 'true'))
      row.dispatchEvent(new MouseEvent('click', { bubbles: true, shiftKey }));
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}
