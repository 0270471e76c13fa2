// Selects and sorts the trajectories of a query to list and draw.
import { bandRank, OUTCOMES } from './palette.js';

/** @import {Box, FilterBox, Filters, Query, Sort, State} from './types/report.js' */
/** @import {Path} from './path.js' */

/**
 * Filters that accept everything. `killer`: a part, or -1 for any; `boxes`: made by `boxOf`
 * below.
 * @type {Readonly<Filters>}
 */
export const UNFILTERED = {
  outcome: '',
  route: '',
  killer: -1,
  maxJumps: -1,
  maxSeconds: 0,
  boxes: Object.freeze([]),
};

/** @type {Record<Sort, string>} */
export const SORTS = {
  found: 'order found',
  time: 'time',
  jumps: 'jumps',
  outcome: 'outcome',
  difficulty: 'difficulty',
  route: 'route',
};

/**
 * Returns an axis-aligned box, in studs. `keep`: the filter shows only trajectories through the
 * box; if false, it hides them.
 * @param {number[]} a
 * @param {number[]} b
 * @returns {FilterBox}
 */
export function boxOf(a, b, keep = true) {
  return {
    min: a.map((value, k) => Math.min(value, b[k])),
    max: a.map((value, k) => Math.max(value, b[k])),
    keep,
  };
}

/**
 * Returns true if the feet are in the box at some point between two samples.
 * @param {Box} box
 * @param {ArrayLike<number>} points
 * @param {number} i
 * @param {number} j
 */
export function segmentMeets({ min, max }, points, i, j) {
  let enter = 0;
  let leave = 1;
  for (let k = 0; k < 3; k++) {
    const from = points[3 * i + k];
    const by = points[3 * j + k] - from;
    if (by === 0) {
      if (from < min[k] || from > max[k]) return false;
      continue;
    }
    const [a, b] = [(min[k] - from) / by, (max[k] - from) / by];
    enter = Math.max(enter, Math.min(a, b));
    leave = Math.min(leave, Math.max(a, b));
    if (enter > leave) return false;
  }
  return true;
}

/**
 * Returns the minimum and maximum of all samples on each axis, cached in the path.
 * @param {Path} path
 */
function boundsOf(path) {
  if (path.bounds) return path.bounds;
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < 3 * path.samples; i++) {
    const value = path.points[i];
    if (value < min[i % 3]) min[i % 3] = value;
    if (value > max[i % 3]) max[i % 3] = value;
  }
  path.bounds = { min, max };
  return path.bounds;
}

/**
 * Returns true if the path's bounds miss the box. A drag tests all trajectories at each pointer
 * move, and most are far from the box.
 * @param {Path} path
 * @param {Box} box
 */
function farFrom(path, box) {
  const { min, max } = boundsOf(path);
  return min.some((low, k) => low > box.max[k] || max[k] < box.min[k]);
}

/**
 * @param {Path} path
 * @param {Box} box
 */
export function meets(path, box) {
  if (farFrom(path, box)) return false;
  if (path.samples === 1) return segmentMeets(box, path.points, 0, 0);
  for (let i = 0; i + 1 < path.samples; i++)
    if (segmentMeets(box, path.points, i, i + 1)) return true;
  return false;
}

/**
 * Box -> query -> indices of the paths through the box. Boxes are immutable. Weak keys allow boxes
 * and queries to be freed, since a live stream replaces queries several times a second.
 * @type {WeakMap<Box, WeakMap<Query, Set<number>>>}
 */
const passed = new WeakMap();

/**
 * @param {Query} query
 * @param {Box} box
 * @returns {Set<number>}
 */
export function pathsThrough(query, box) {
  const byQuery = passed.get(box) ?? new WeakMap();
  passed.set(box, byQuery);
  const known = byQuery.get(query);
  if (known) return known;
  const found = new Set();
  query.paths.forEach((path, index) => {
    if (meets(path, box)) found.add(index);
  });
  byQuery.set(query, found);
  return found;
}

/**
 * Returns true for a failed attempt that is neither the closest nor the newest one.
 * @param {Path} path
 */
export const isAttempt = ({ kind }) => kind === 'attempt';

/** @param {Path} path */
export const routeKey = (path) => (path.route ?? []).join(' ');

/**
 * @param {Query} query
 * @param {Path} path
 * @param {number} index
 * @param {Filters} filters
 * @param {number} rate
 */
function fits(query, path, index, filters, rate) {
  const { outcome, route, killer, maxJumps, maxSeconds, boxes } = filters;
  if (outcome && path.outcome !== outcome) return false;
  if (route && routeKey(path) !== route) return false;
  if (killer >= 0 && !(path.outcome === 'killed' && path.part === killer)) return false;
  if (maxJumps >= 0 && path.jumps > maxJumps) return false;
  if (maxSeconds > 0 && path.ticks > maxSeconds * rate + 1e-6) return false;
  return boxes.every((box) => pathsThrough(query, box).has(index) === box.keep);
}

/** @type {Record<Exclude<Sort, 'route'>, (path: Path) => number>} */
const kRanks = {
  found: () => 0,
  time: (path) => path.ticks,
  jumps: (path) => path.jumps,
  outcome: (path) => OUTCOMES.indexOf(path.outcome),
  difficulty: bandRank,
};

/**
 * Returns the indices of the paths that pass all filters, sorted. Equal paths keep the stream's
 * order.
 * @param {Query} query
 * @param {State} state
 * @param {number} rate
 */
export function listed(query, state, rate) {
  const order = query.paths
    .map((_, i) => i)
    .filter((i) => fits(query, query.paths[i], i, state, rate));
  const sign = state.descending ? -1 : 1;
  if (state.sort === 'route') {
    const keys = query.paths.map(routeKey);
    return order.sort((a, b) => sign * keys[a].localeCompare(keys[b]) || a - b);
  }
  const rank = kRanks[state.sort];
  return order.sort((a, b) => sign * (rank(query.paths[a]) - rank(query.paths[b])) || a - b);
}

/** @param {State} state */
export const filtered = (state) =>
  /** @type {(keyof Filters)[]} */ (Object.keys(UNFILTERED)).some((name) =>
    name === 'boxes' ? state.boxes.length > 0 : state[name] !== UNFILTERED[name],
  );
