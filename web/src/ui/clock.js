// The clock of the timeline. A click on it turns it into a field, in which a time can be typed.
import { el } from './dom.js';

/**
 * Returns a typed time in seconds, or NaN. It may be seconds or minutes and seconds.
 * @param {string} text such as 3.2, 3,2 s or 1:03.5
 */
export function parseTime(text) {
  const found = /^\s*(?:(\d+)\s*:\s*)?(\d*[.,]?\d*)\s*s?\s*$/.exec(text);
  if (!found || !/\d/.test(found[2])) return NaN;
  return 60 * Number(found[1] ?? 0) + Number(found[2].replace(',', '.'));
}

export class Clock {
  /** @param {(seconds: number) => void} seek */
  constructor(seek) {
    this.seek = seek;
    this.now = '0.00';
    this.time = el('button', {
      class: 'time',
      type: 'button',
      title: 'Click to type a time in seconds',
      on: { click: () => this.open() },
    });
    this.field = el('input', {
      class: 'time-field',
      type: 'text',
      hidden: true,
      'aria-label': 'Time in seconds',
      on: {
        keydown: ({ key }) => {
          if (key === 'Enter') this.close(true);
          if (key === 'Escape') this.close(false);
        },
        blur: () => this.close(true),
      },
    });
    // A screen reader would announce each tick during playback. The slider states the time on
    // request.
    this.tick = el('output', { class: 'tick quiet', 'aria-live': 'off' });
    this.root = el('div', { class: 'clock' }, this.time, this.field, this.tick);
  }

  open() {
    this.field.value = this.now;
    this.time.hidden = true;
    this.field.hidden = false;
    this.field.select();
    this.field.focus();
  }

  /** @param {boolean} apply */
  close(apply) {
    if (this.field.hidden) return;
    const wanted = parseTime(this.field.value);
    this.field.hidden = true;
    this.time.hidden = false;
    if (apply && Number.isFinite(wanted) && this.field.value !== this.now) this.seek(wanted);
  }

  /**
   * @param {string} now seconds
   * @param {string} all
   * @param {number} tick
   */
  show(now, all, tick) {
    this.now = now;
    this.time.textContent = `${now} / ${all} s`;
    this.tick.textContent = `tick ${tick}`;
  }
}
