// Names that distinguish the routes of a query, from parts that only some routes touch.
import { partName } from './part_name.js';
import { routeText } from './route_text.js';

/** @import {Level, Query} from './types/report.js' */

const kMaxNames = 5; // max names in a route's text
const kMaxMarks = 3; // max parts that distinguish a route
const kMaxRoutes = 50; // max routes compared with one another

/**
 * Returns a map from a part to its name. Parts with equal names are numbered.
 * @param {number[][]} routes
 * @param {Level | undefined} level
 * @returns {Map<number, string>}
 */
function namesOf(routes, level) {
  /** @type {Map<string, number[]>} */
  const byName = new Map();
  for (const part of [...new Set(routes.flat())].sort((a, b) => a - b)) {
    const name = partName(level, part);
    byName.set(name, [...(byName.get(name) ?? []), part]);
  }
  const names = new Map();
  for (const [name, parts] of byName)
    parts.forEach((part, i) => names.set(part, parts.length > 1 ? `${name} #${i + 1}` : name));
  return names;
}

/**
 * Returns the part whose presence in the route, or whose absence from it, excludes most of
 * `others`.
 * @param {Set<number>} own
 * @param {Set<number>[]} others
 * @param {number[]} parts
 */
function bestMark(own, others, parts) {
  /** @type {{part: number, isOn: boolean, left: Set<number>[]} | null} */
  let best = null;
  for (const isOn of [true, false])
    for (const part of parts) {
      if (own.has(part) !== isOn) continue;
      const left = others.filter((other) => other.has(part) === isOn);
      if (left.length < (best?.left ?? others).length) best = { part, isOn, left };
    }
  return best;
}

/**
 * Returns a name as English has it in a sentence: "the Plank", but "Step 3" and "Ramp #2".
 * @param {string} name
 */
const called = (name) => (/^\p{L}+$/u.test(name) ? `the ${name}` : name);

/**
 * Returns text that distinguishes a route, such as "over the Plank" or "not over the Lift", or its
 * number if parts do not.
 * @param {number} index
 * @param {Set<number>[]} sets
 * @param {number[]} parts
 * @param {Map<number, string>} names
 */
function markOf(index, sets, parts, names) {
  let others = sets.filter((_, i) => i !== index);
  const marks = [];
  while (others.length && marks.length < kMaxMarks) {
    const mark = bestMark(sets[index], others, parts);
    if (!mark) break;
    marks.push(`${mark.isOn ? 'over' : 'not over'} ${called(names.get(mark.part) ?? '')}`);
    others = mark.left;
  }
  if (others.length) marks.push(`route ${index + 1}`);
  return marks.join(', ');
}

/**
 * Cached results by query. A changed query is another object.
 * @type {WeakMap<Query, Map<string, {mark: string, text: string}>>}
 */
const known = new WeakMap();

/**
 * Returns a map from a route's key (choice.js) to {mark, text}. `text` is the route, with the mark
 * if another route reads the same. With a single route the mark is empty.
 * @param {Query} query
 * @param {Level | undefined} level
 * @returns {Map<string, {mark: string, text: string}>}
 */
export function routeNames(query, level) {
  const before = known.get(query);
  if (before) return before;
  const found = [
    ...(query.result?.routes ?? []).map(({ route }) => route),
    ...query.paths.map(({ route }) => route ?? []),
  ].filter((route) => route.length);
  const routes = [...new Map(found.map((route) => [route.join(' '), route])).entries()];
  const compared = routes.slice(0, kMaxRoutes).map(([, route]) => route);
  const sets = compared.map((route) => new Set(route));
  const parts = [...new Set(compared.flat())];
  const names = namesOf(compared, level);
  const texts = routes.map(([, route]) => routeText(route, level, kMaxNames));
  const result = new Map(
    routes.map(([key], i) => {
      const mark = i < compared.length ? markOf(i, sets, parts, names) : `route ${i + 1}`;
      const isUnique = texts.indexOf(texts[i]) === texts.lastIndexOf(texts[i]);
      return [key, { mark, text: isUnique ? texts[i] : `${texts[i]} (${mark})` }];
    }),
  );
  known.set(query, result);
  return result;
}
