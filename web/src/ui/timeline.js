// The bar at the bottom: play, step, scrub over the height profile, time and speed.
import { BAND_STYLE, pathColor } from '../palette.js';
import { landings } from '../scene/action_marks.js';
import { el, icon, seconds, svg } from './dom.js';

/** @import {Path} from '../path.js' */
/** @import {Playback} from '../playback.js' */
/** @import {Store} from '../store.js' */

const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 4, 10];
const kWide = 1000; // width of the plot in SVG units
const kMaxMarks = 2000; // max marks of each kind
const kSliderKeys = /^(Arrow|Page|Home$|End$)/;

/** @typedef {(tick: number) => number} Place maps a tick to a position in the plot */

/**
 * Returns a short line at the profile's lower or upper edge.
 * @param {string} kind
 * @param {number} x
 * @param {number} from
 * @param {number} to
 */
const tickMark = (kind, x, from, to) =>
  svg('path', {
    class: `mark ${kind}`,
    d: `M${x} ${from}V${to}`,
    'vector-effect': 'non-scaling-stroke',
  });

/**
 * Marks the hardest step in the colour of its band.
 * @param {Path} path
 * @param {Place} x
 */
function hardestStep(path, x) {
  const hardest = path.difficulty?.hardest;
  if (!hardest) return [];
  return [
    svg('rect', {
      class: 'hardest',
      x: x(hardest.startTick).toFixed(1),
      y: '0',
      width: x(Math.min(hardest.ticks, path.ticks)).toFixed(1),
      height: '100',
      fill: BAND_STYLE[hardest.band].color,
      'fill-opacity': '0.28',
    }),
  ];
}

/**
 * Draws the height over time.
 * @param {Path} path
 * @param {Place} x
 */
function heights(path, x) {
  let low = Infinity;
  let high = -Infinity;
  for (let i = 0; i < path.samples; i++) {
    low = Math.min(low, path.points[3 * i + 1]);
    high = Math.max(high, path.points[3 * i + 1]);
  }
  const range = Math.max(high - low, 6);
  const point = (/** @type {number} */ i) => {
    const y = 92 - (78 * (path.points[3 * i + 1] - low)) / range;
    return `L${x(path.tickOf(i)).toFixed(1)} ${y.toFixed(1)}`;
  };
  const last = path.samples - 1;
  const skip = Math.max(1, Math.floor(path.samples / 600));
  let line = '';
  for (let i = 0; i < last; i += skip) line += point(i);
  line += point(last);
  const tint = pathColor(path);
  const end = x(path.ticks).toFixed(1);
  return [
    svg('path', { d: `M0 100${line}L${end} 100Z`, fill: tint, 'fill-opacity': '0.14' }),
    svg('path', {
      d: `M${line.slice(1)}`,
      fill: 'none',
      stroke: tint,
      'stroke-opacity': '0.75',
      'stroke-width': '1.5',
      'vector-effect': 'non-scaling-stroke',
    }),
  ];
}

/**
 * Keeps one tick per position. Hours of play have more ticks than are visible, and more than a
 * call can have arguments.
 * @param {number[]} ticks
 * @param {Place} x
 */
function apart(ticks, x) {
  if (ticks.length <= kMaxMarks) return ticks;
  const place = (/** @type {number} */ tick) => Math.round((kMaxMarks * x(tick)) / kWide);
  return [...new Map(ticks.map((tick) => [place(tick), tick])).values()];
}

/**
 * Marks jumps, landings and triggered parts.
 * @param {Path} path
 * @param {Place} x
 */
function marksOf(path, x) {
  /**
   * @param {string} kind
   * @param {number[]} ticks
   * @param {number} from
   * @param {number} to
   */
  const marks = (kind, ticks, from, to) =>
    apart(ticks, x).map((tick) => tickMark(kind, x(tick), from, to));
  return [
    ...marks('jump', path.jumpTicks, 100, 88),
    ...marks('landing', landings(path), 100, 95),
    ...marks(
      'event',
      path.events.map(([tick]) => tick),
      0,
      12,
    ),
  ];
}

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
    // A screen reader would announce each tick during playback. The slider states the time on
    // request.
    this.time = el('output', { class: 'time', 'aria-live': 'off' });
    this.tick = el('output', { class: 'tick quiet', 'aria-live': 'off' });
    this.speed = el(
      'select',
      {
        'aria-label': 'Speed',
        title: 'Speed (− and +)',
        on: { change: () => store.set({ speed: Number(this.speed.value) }) },
      },
      ...kSpeeds.map((speed) => el('option', { value: String(speed), text: `${speed}×` })),
    );
    this.loop = el(
      'button',
      {
        type: 'button',
        class: 'plain',
        title: 'Loop (L)',
        'aria-label': 'Loop',
        on: { click: () => store.set({ loop: !store.state.loop }) },
      },
      icon('loop'),
    );
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
      el('div', { class: 'clock' }, this.time, this.tick),
      el('div', { class: 'track' }, this.plot, this.slider),
      el('div', { class: 'buttons' }, this.speed, this.loop),
    );
    this.nothing = el('p', { class: 'quiet nothing', text: 'Nothing to play.' });
    this.extras = el('div', { class: 'buttons' });
    root.append(this.player, this.nothing, this.extras);
    // The ghost may be longer than the selected trajectory.
    store.on(['query', 'path', 'ghost'], () => this.draw());
    store.on(['tick', 'path', 'query', 'ghost'], () => this.showTime());
    store.on(['playing', 'speed', 'loop'], () => this.showState());
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
    this.plot.replaceChildren();
    if (!path || path.samples < 2) return;
    const x = (/** @type {number} */ tick) => (kWide * tick) / length;
    this.plot.append(...hardestStep(path, x), ...heights(path, x), ...marksOf(path, x));
  }

  showTime() {
    const length = this.playback.lengthOf();
    const tick = Math.min(this.store.state.tick, length);
    const rate = this.playback.rateOf();
    this.slider.value = String(tick);
    this.slider.style.setProperty('--share', `${(100 * tick) / Math.max(1, length)}%`);
    const [now, all] = [seconds(tick / rate), seconds(length / rate)];
    // The slider's value is in ticks.
    this.slider.setAttribute('aria-valuetext', `${now} of ${all} s`);
    this.time.textContent = `${now} / ${all} s`;
    this.tick.textContent = `tick ${Math.floor(tick + 1e-6)}`;
  }

  showState() {
    const { playing, speed, loop } = this.store.state;
    this.button.replaceChildren(icon(playing ? 'pause' : 'play'));
    this.button.setAttribute('aria-label', playing ? 'Pause' : 'Play');
    this.button.title = `${playing ? 'Pause' : 'Play'} (Space)`;
    this.speed.value = String(speed);
    this.loop.setAttribute('aria-pressed', String(loop));
  }
}
