// The height profile of a trajectory: its height over time, with marks for jumps, landings,
// triggered parts, the hardest step and the range of the loop.
import { BAND_STYLE, pathColor } from '../palette.js';
import { landings } from '../scene/action_marks.js';
import { svg } from './dom.js';

/** @import {Path} from '../path.js' */

const kWide = 1000; // width of the plot in SVG units
const kMaxMarks = 2000; // max marks of each kind

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

/**
 * Returns the profile's drawing. `length`: ticks of the whole plot.
 * @param {Path} path
 * @param {number} length
 */
export function profileOf(path, length) {
  if (path.samples < 2) return [];
  const x = (/** @type {number} */ tick) => (kWide * tick) / length;
  return [...hardestStep(path, x), ...heights(path, x), ...marksOf(path, x)];
}

/**
 * Marks the range that is looped.
 * @param {{from: number, to: number}} range ticks
 * @param {number} length
 */
export const rangeMark = ({ from, to }, length) =>
  svg('rect', {
    class: 'range',
    x: ((kWide * from) / length).toFixed(1),
    y: '0',
    width: ((kWide * (to - from)) / length).toFixed(1),
    height: '100',
  });
