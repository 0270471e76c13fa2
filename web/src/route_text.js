// Routes as text: the last components of the parts' names, with repetitions merged.
import { partName } from './part_name.js';

/** @import {Level} from './types/report.js' */

/**
 * `limit`: max number of names; longer routes are shortened to the first and last two.
 * @param {number[]} route
 * @param {Level | undefined} level
 */
export function routeText(route, level, limit = Infinity) {
  /** @type {{name: string, count: number}[]} */
  const steps = [];
  for (const name of route.map((part) => partName(level, part))) {
    const last = steps.at(-1);
    if (last?.name === name) last.count += 1;
    else steps.push({ name, count: 1 });
  }
  const words = steps.map(({ name, count }) => (count > 1 ? `${name} ×${count}` : name));
  const told = words.length > limit ? [...words.slice(0, 2), '…', ...words.slice(-2)] : words;
  return told.join(' → ');
}
