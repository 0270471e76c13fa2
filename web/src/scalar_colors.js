// Colours along trajectories by a quantity that changes from sample to sample: speed or height.
import { NO_VALUE_COLOR, rampColor } from './color_ramps.js';

/** @import {Path} from './path.js' */
/** @import {Coloring, Query} from './types/report.js' */

const kMaxSamples = 200000; // for the range of the values
const kSteps = 64; // distinct colours, so that lines need few
const kMostly = 0.995; // share of the values within the scale: respawns and teleports are outliers

/**
 * Returns the speed in studs a second at a sample, averaged over its neighbours.
 * @param {Path} path
 * @param {number} i
 * @param {number} rate ticks a second
 */
function speedAt(path, i, rate) {
  const [a, b] = [Math.max(0, i - 2), Math.min(path.samples - 1, i + 2)];
  const p = path.points;
  const far = Math.hypot(
    p[3 * b] - p[3 * a],
    p[3 * b + 1] - p[3 * a + 1],
    p[3 * b + 2] - p[3 * a + 2],
  );
  return (far * rate) / Math.max(1, path.tickOf(b) - path.tickOf(a));
}

/** @typedef {(path: Path, sample: number, rate: number) => number} Quantity */

/** @type {Record<'speed' | 'height', {of: Quantity, unit: string}>} */
const kQuantities = {
  speed: { of: speedAt, unit: 'studs/s' },
  height: { of: ({ points }, i) => points[3 * i + 1], unit: 'studs' },
};

/**
 * Returns the low and high end of the scale.
 * @param {Path[]} paths
 * @param {(path: Path, sample: number) => number} of
 */
function rangeOf(paths, of) {
  const total = paths.reduce((sum, { samples }) => sum + samples, 0);
  const step = Math.max(1, Math.ceil(total / kMaxSamples));
  const values = [];
  for (const path of paths)
    for (let i = 0; i < path.samples; i += step) values.push(of(path, i));
  const sorted = Float32Array.from(values).sort();
  const last = sorted.length - 1;
  return { low: sorted[0] ?? 0, high: sorted[Math.floor(last * kMostly)] ?? 0 };
}

/**
 * The range is that of the solutions, or of all trajectories if there are none.
 * @param {Query} query
 * @param {'speed' | 'height'} quantity
 * @param {number} rate
 * @returns {Coloring}
 */
export function byScalar(query, quantity, rate) {
  const { of, unit } = kQuantities[quantity];
  const solutions = query.paths.filter(({ kind }) => kind === 'solution');
  const value = (/** @type {Path} */ path, /** @type {number} */ i) => of(path, i, rate);
  const { low, high } = rangeOf(solutions.length ? solutions : query.paths, value);
  const share = (/** @type {number} */ v) => (high > low ? (v - low) / (high - low) : 0);
  const label = (/** @type {number} */ s) => `${(low + s * (high - low)).toFixed(1)} ${unit}`;
  const colors = Array.from({ length: kSteps }, (_, i) => rampColor(i / (kSteps - 1)));
  const step = (/** @type {number} */ s) => Math.round(Math.min(Math.max(s, 0), 1) * (kSteps - 1));
  /** @type {Coloring['legend']} */
  const legend = [0, 0.5, 1].map((s) => [label(s), rampColor(s), 'solution']);
  return {
    of: () => NO_VALUE_COLOR,
    along: (path, sample) => colors[step(share(value(path, sample)))],
    legend: query.paths.length ? legend : [],
  };
}
