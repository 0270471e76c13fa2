// Names that distinguish the solutions of a query: player, time, jumps, a part that only this
// route touches, and a number if all of these are equal.
import { routeKey } from './choice.js';
import { routeNames } from './route_names.js';
import { plural, seconds } from './ui/dom.js';

/** @import {Path} from './path.js' */
/** @import {Level, Query} from './types/report.js' */

/**
 * Cached results by query. A changed query is another object.
 * @type {WeakMap<Query, Map<number, {name: string, route: string}>>}
 */
const known = new WeakMap();

/** @type {Record<string, string | undefined>} */
const BODY_NAMES = { r6: 'R6', r15: 'R15' };

/**
 * Returns a prefix such as "R15, 30 fps: " for a player that the query names.
 * @param {Path} path
 */
function playerOf({ body, frameRate }) {
  const rig = body && (BODY_NAMES[body] ?? body);
  const words = [rig, frameRate && `${frameRate} fps`].filter(Boolean);
  return words.length > 0 ? `${words.join(', ')}: ` : '';
}

/**
 * Returns a map from a solution's index to {name, route}. The route is empty if all solutions
 * share it.
 * @param {Query} query
 * @param {Level | undefined} level
 * @returns {Map<number, {name: string, route: string}>}
 */
export function solutionNames(query, level) {
  const before = known.get(query);
  if (before) return before;
  const rate = level?.tickRate ?? 60;
  const routes = routeNames(query, level);
  /** @type {Map<string, number>} */
  const taken = new Map();
  const names = new Map();
  query.paths.forEach((path, index) => {
    if (path.kind !== 'solution') return;
    const route = routes.get(routeKey(path))?.mark ?? '';
    const time = `${seconds(path.ticks / rate)} s, ${plural(path.jumps, 'jump')}`;
    const name = playerOf(path) + time;
    const number = (taken.get(name + route) ?? 0) + 1;
    taken.set(name + route, number);
    names.set(index, { name: number > 1 ? `${name} (${number})` : name, route });
  });
  known.set(query, names);
  return names;
}
