// The bar at the bottom: play, step, scrub over the height profile, time and speed.
import { rangeOf, SPEEDS } from '../playback.js';
import { Clock } from './clock.js';
import { el, icon, seconds, svg } from './dom.js';
import { profileOf, rangeMark } from './profile.js';

/** @import {Path} from '../path.js' */
/** @import {Playback} from '../playback.js' */
/** @import {Store} from '../store.js' */

const kSliderKeys = /^(Arrow|Page|Home$|End$)/;

export class Timeline {
  /**
   * @param {HTMLElement} root
   * @param {Store} store
   * @param {Playback} playback
   * @param {() => Path | undefined} selected
   */
  constructor(root, store, playback, selected) {
    this.store = store;
    this.playback = playback;
    this.selected = selected;
    this.button = el(
      'button',
      {
        class: 'play',
        type: 'button',
        'aria-label': 'Play',
        on: { click: () => playback.toggle() },
      },
      icon('play'),
    );
    this.slider = el('input', {
      type: 'range',
      min: '0',
      max: '1',
      step: 'any',
      value: '0',
      'aria-label': 'Time',
      class: 'scrub',
      on: {
        input: () => {
          store.set({ playing: false });
          playback.seek(Number(this.slider.value));
        },
        // The page handles the keys that move the slider; the browser handles all others.
        keydown: (event) => {
          if (kSliderKeys.test(event.key)) event.preventDefault();
        },
      },
    });
    this.plot = svg('svg', {
      class: 'profile',
      preserveAspectRatio: 'none',
      viewBox: '0 0 1000 100',
    });
    this.clock = new Clock((time) => {
      store.set({ playing: false });
      playback.seek(Math.round(time * playback.rateOf())); // the tick whose time is nearest
    });
    this.speed = el(
      'select',
      {
        'aria-label': 'Speed',
        title: 'Speed (− and +)',
        on: { change: () => store.set({ speed: Number(this.speed.value) }) },
      },
      ...SPEEDS.map((speed) => el('option', { value: String(speed), text: `${speed}×` })),
    );
    this.loop = el(
      'button',
      {
        type: 'button',
        class: 'plain',
        title: 'Loop (L)',
        'aria-label': 'Loop',
        on: { click: () => playback.toggleLoop() },
      },
      icon('loop'),
    );
    this.track = el('div', { class: 'track' }, this.plot, this.slider);
    this.track.addEventListener('pointerdown', (event) => this.beginRange(event), true);
    this.player = el(
      'div',
      { class: 'player' },
      el(
        'div',
        { class: 'buttons' },
        this.stepButton('back', -1),
        this.button,
        this.stepButton('forward', 1),
      ),
      this.clock.root,
      this.track,
      el('div', { class: 'buttons' }, this.speed, this.loop),
    );
    this.nothing = el('p', { class: 'quiet nothing', text: 'Nothing to play.' });
    this.extras = el('div', { class: 'buttons' });
    root.append(this.player, this.nothing, this.extras);
    // The ghost may be longer than the selected trajectory.
    store.on(['query', 'path', 'ghost', 'loop', 'loopFrom', 'loopTo'], () => this.draw());
    store.on(['tick', 'path', 'query', 'ghost'], () => this.showTime());
    store.on(['playing', 'speed', 'loop', 'loopFrom', 'loopTo'], () => this.showState());
    this.draw();
    this.showTime();
    this.showState();
  }

  /**
   * @param {'back' | 'forward'} name
   * @param {number} by
   */
  stepButton(name, by) {
    const label = by > 0 ? 'Next tick' : 'Previous tick';
    return el(
      'button',
      {
        class: 'plain',
        type: 'button',
        title: `${label} (${by > 0 ? '→' : '←'})`,
        'aria-label': label,
        on: { click: () => this.playback.step(by) },
      },
      icon(name),
    );
  }

  /**
   * @param {string} text
   * @param {string} title
   * @param {() => void} action
   */
  addButton(text, title, action) {
    const button = el('button', {
      class: 'plain',
      type: 'button',
      title,
      text,
      'aria-label': title,
      on: { click: action },
    });
    this.extras.append(button);
  }

  // Draws the selected trajectory's profile. If the ghost is longer, the profile ends before the
  // timeline.
  draw() {
    const path = this.selected();
    const length = Math.max(1, this.playback.lengthOf());
    this.player.hidden = this.playback.lengthOf() === 0;
    this.nothing.hidden = !this.player.hidden;
    this.plot.classList.toggle('bare', !path);
    this.slider.max = String(length);
    this.plot.replaceChildren(...(path ? profileOf(path, length) : []));
    const range = rangeOf(this.store.state, this.playback.lengthOf());
    if (range.isPart) this.plot.append(rangeMark(range, length));
  }

  /**
   * Shift and a drag over the profile set the range of the loop.
   * @param {PointerEvent} event
   */
  beginRange(event) {
    if (!event.shiftKey || event.button !== 0) return;
    event.preventDefault();
    event.stopPropagation();
    const { left, width } = this.track.getBoundingClientRect();
    const length = this.playback.lengthOf();
    const tickAt = (/** @type {PointerEvent} */ { clientX }) =>
      Math.min(Math.max(0, (clientX - left) / width), 1) * length;
    const first = tickAt(event);
    const move = (/** @type {PointerEvent} */ now) => {
      const range = [first, tickAt(now)].sort((a, b) => a - b);
      this.store.set({ loop: true, loopFrom: range[0], loopTo: range[1] });
    };
    const end = () => window.removeEventListener('pointermove', move);
    window.addEventListener('pointermove', move);
    window.addEventListener('pointerup', end, { once: true });
    window.addEventListener('pointercancel', end, { once: true });
  }

  showTime() {
    const length = this.playback.lengthOf();
    const tick = Math.min(this.store.state.tick, length);
    const rate = this.playback.rateOf();
    this.slider.value = String(tick);
    this.slider.style.setProperty('--share', `${(100 * tick) / Math.max(1, length)}%`);
    const now = (tick / rate).toFixed(3); // tells ticks apart, also those of 240 a second
    // The slider's value is in ticks.
    this.slider.setAttribute('aria-valuetext', `${now} of ${seconds(length / rate)} s`);
    this.clock.show(now, seconds(length / rate), Math.floor(tick + 1e-6));
  }

  showState() {
    const { playing, speed, loop } = this.store.state;
    const range = rangeOf(this.store.state, this.playback.lengthOf());
    const rate = this.playback.rateOf();
    const ends = [range.from, range.to].map((tick) => seconds(tick / rate));
    this.loop.title = range.isPart ? `Loop from ${ends.join(' to ')} s (L)` : 'Loop (L)';
    this.button.replaceChildren(icon(playing ? 'pause' : 'play'));
    this.button.setAttribute('aria-label', playing ? 'Pause' : 'Play');
    this.button.title = `${playing ? 'Pause' : 'Play'} (Space)`;
    this.speed.value = String(speed);
    this.loop.setAttribute('aria-pressed', String(loop));
  }
}
