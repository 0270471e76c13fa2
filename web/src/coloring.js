// Colours of trajectories by outcome, route, method, time, jumps, difficulty, speed, height or
// closeness to failing, with legends.
import { isAttempt, routeKey } from './choice.js';
import { NO_VALUE_COLOR as kNone, rampColor } from './color_ramps.js';
import {
  BAND_STYLE,
  BANDS,
  OUTCOME_STYLE,
  OUTCOMES,
  pathColor,
  SOLUTION_COLOR,
  VERDICT_STYLE,
} from './palette.js';
import { routeNames } from './route_names.js';
import { byScalar } from './scalar_colors.js';
import { byStep } from './step_colors.js';
import { tally } from './tally.js';
import { plural } from './ui/dom.js';

/** @import {Path} from './path.js' */
/** @import {ColorBy, Coloring, Level, Query} from './types/report.js' */

/** @type {Record<ColorBy, string>} */
export const COLORINGS = {
  outcome: 'outcome',
  route: 'route',
  method: 'method',
  time: 'time',
  jumps: 'jumps',
  difficulty: 'difficulty',
  speed: 'speed',
  height: 'height',
  margin: 'margin',
  window: 'time to press',
};

// The palette of Okabe and Ito for colour-blind readers (https://jfly.uni-koeln.de/color/), without
// black.
const kDistinct = ['#e69f00', '#56b4e9', '#009e73', '#f0e442', '#0072b2', '#d55e00', '#cc79a7'];

/**
 * @param {Query} query
 * @returns {Coloring}
 */
function byOutcome(query) {
  const outcomes = new Set(query.paths.filter((p) => !p.mismatch).map((p) => p.outcome));
  /** @type {Coloring['legend']} */
  const legend = [];
  if (outcomes.has('goal')) legend.push(['Solution', SOLUTION_COLOR, 'solution']);
  if (query.paths.some((path) => path.mismatch))
    legend.push([VERDICT_STYLE.mismatch.label, VERDICT_STYLE.mismatch.color, 'solution']);
  for (const outcome of OUTCOMES) {
    const { label, color } = OUTCOME_STYLE[outcome];
    if (outcome === 'goal' || !outcomes.has(outcome)) continue;
    // The closest and the newest trajectory are drawn even without the failed attempts.
    const drawn = query.paths.some((path) => path.outcome === outcome && !isAttempt(path));
    legend.push([label, color, drawn ? 'solution' : 'attempt']);
  }
  return { of: pathColor, legend };
}

/**
 * @param {Query} query
 * @param {(path: Path) => number} valueOf
 * @param {(value: number) => string} label
 * @returns {Coloring}
 */
function byNumber(query, valueOf, label) {
  const values = query.paths.map(valueOf);
  if (!values.length) return { of: () => kNone, legend: [] };
  const min = values.reduce((a, b) => Math.min(a, b), Infinity);
  const max = values.reduce((a, b) => Math.max(a, b), -Infinity);
  const share = (/** @type {number} */ value) =>
    (max > min ? (value - min) / (max - min) : 0);
  /** @type {Coloring['legend']} */
  const legend = [0, 0.5, 1].map((s) => [
    label(min + s * (max - min)),
    rampColor(max > min ? s : 0),
    'solution',
  ]);
  return {
    of: (path) => rampColor(share(valueOf(path))),
    legend: max > min ? legend : legend.slice(0, 1),
  };
}

/**
 * @param {Query} query
 * @param {Level | undefined} level
 * @returns {Coloring}
 */
function byRoute(query, level) {
  const keys = tally(query.paths.map(routeKey).filter(Boolean)).map(([key]) => key);
  const colors = new Map(keys.slice(0, kDistinct.length).map((key, i) => [key, kDistinct[i]]));
  /** @type {Coloring['legend']} */
  const legend = [...colors].map(([key, color]) => [
    routeNames(query, level).get(key)?.text ?? key,
    color,
    'solution',
  ]);
  if (keys.length > colors.size || query.paths.some((path) => !path.route?.length))
    legend.push(['Other', kNone, 'attempt']);
  return { of: (path) => colors.get(routeKey(path)) ?? kNone, legend };
}

/**
 * Colours trajectories by method, for answers by several methods to one query.
 * @param {Query} query
 * @returns {Coloring}
 */
function byMethod(query) {
  const names = [...new Set(query.paths.map((path) => path.method))].filter(Boolean).sort();
  const colors = new Map(names.slice(0, kDistinct.length).map((name, i) => [name, kDistinct[i]]));
  /** @type {Coloring['legend']} */
  const legend = [...colors].map(([name, color]) => [name, color, 'solution']);
  if (query.paths.some((path) => !colors.has(path.method)))
    legend.push(['Other', kNone, 'attempt']);
  return { of: (path) => colors.get(path.method) ?? kNone, legend };
}

/**
 * @param {Query} query
 * @returns {Coloring}
 */
function byDifficulty(query) {
  const bands = new Set(query.paths.map((path) => path.difficulty?.band));
  /** @type {Coloring['legend']} */
  const legend = BANDS.filter((band) => bands.has(band)).map((band) => {
    const { label, color } = BAND_STYLE[band];
    return [label, color, 'solution'];
  });
  if (bands.has(undefined)) legend.push(['Not measured', kNone, 'attempt']);
  const of = (/** @type {Path} */ { difficulty }) =>
    (difficulty && BAND_STYLE[difficulty.band]?.color) ?? kNone;
  return { of, legend };
}

/**
 * @param {Query} query
 * @param {Level | undefined} level
 * @param {ColorBy} mode
 * @returns {Coloring}
 */
export function coloring(query, level, mode) {
  const rate = level?.tickRate ?? 60;
  if (mode === 'method') return byMethod(query);
  if (mode === 'route') return byRoute(query, level);
  if (mode === 'time')
    return byNumber(
      query,
      (p) => p.ticks,
      (v) => `${(v / rate).toFixed(1)} s`,
    );
  if (mode === 'jumps')
    return byNumber(
      query,
      (p) => p.jumps,
      (v) => plural(Math.round(v), 'jump'),
    );
  if (mode === 'speed' || mode === 'height') return byScalar(query, mode, rate);
  if (mode === 'margin' || mode === 'window') return byStep(query, mode);
  if (mode === 'difficulty') return byDifficulty(query);
  return byOutcome(query);
}
