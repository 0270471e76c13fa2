// Names that distinguish the solutions of a query: the player, a part that only this route touches,
// jumps and time, and a number if all of these are equal.
import { routeKey } from './choice.js';
import { routeNames } from './route_names.js';
import { plural, seconds } from './ui/dom.js';

/** @import {Path} from './path.js' */
/** @import {Level, Query} from './types/report.js' */

/**
 * Cached results by query. A changed query is another object.
 * @type {WeakMap<Query, Map<number, Named>>}
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
 * A solution's name, and what a row adds to it.
 * @typedef {{name: string, facts: string[]}} Named
 */

/**
 * Returns a map from a solution's index to its name. If all solutions share one route, jumps and
 * time are the name.
 * @param {Query} query
 * @param {Level | undefined} level
 * @returns {Map<number, Named>}
 */
export function solutionNames(query, level) {
  const before = known.get(query);
  if (before) return before;
  const rate = level?.tickRate ?? 60;
  const routes = routeNames(query, level);
  /** @type {Map<string, number>} */
  const taken = new Map();
  /** @type {Map<number, Named>} */
  const names = new Map();
  query.paths.forEach((path, index) => {
    if (path.kind !== 'solution') return;
    const route = routes.get(routeKey(path))?.mark ?? '';
    const facts = [plural(path.jumps, 'jump'), `${seconds(path.ticks / rate)} s`];
    const name = playerOf(path) + (route || facts.join(', '));
    const key = [name, ...facts].join();
    const number = (taken.get(key) ?? 0) + 1;
    taken.set(key, number);
    const unique = number > 1 ? `${name} (${number})` : name;
    names.set(index, { name: unique, facts: route ? facts : [] });
  });
  known.set(query, names);
  return names;
}
