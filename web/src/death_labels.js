// Labels for the places where the shown trajectories were killed.
import { OUTCOME_STYLE } from './palette.js';
import { partName } from './part_name.js';

/** @import {Path} from './path.js' */
/** @import {Triple} from './types/page_data.js' */
/** @import {Level} from './types/report.js' */

/**
 * Returns the place nearest to the centroid of all places.
 * @param {Triple[]} places
 */
function middlemost(places) {
  const sum = [0, 1, 2].map((k) => places.reduce((all, place) => all + place[k], 0));
  const far = (/** @type {Triple} */ place) =>
    Math.hypot(...place.map((value, k) => value - sum[k] / places.length));
  return places.reduce((best, place) => (far(place) < far(best) ? place : best));
}

/**
 * Returns [{text, at, color}], the most frequent killers first.
 * @param {Path[]} paths
 * @param {Level | undefined} level
 * @param {number} max
 */
export function deathLabels(paths, level, max) {
  /** @type {Map<number, Triple[]>} */
  const killers = new Map();
  for (const path of paths) {
    if (path.outcome !== 'killed' || path.part < 0) continue;
    const places = killers.get(path.part) ?? [];
    places.push(path.end());
    killers.set(path.part, places);
  }
  return [...killers]
    .sort((a, b) => b[1].length - a[1].length)
    .slice(0, max)
    .map(([part, places]) => ({
      text: `✕ ${places.length} killed by ${partName(level, part)}`,
      at: middlemost(places),
      color: OUTCOME_STYLE.killed.color,
    }));
}
