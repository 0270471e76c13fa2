// Routes in words: the last words of the parts' names, those alike in a row told once.
import { partName } from './part_name.js';

/** @import {Level} from './types/report.js' */

/**
 * `most`: so many names; of more the first and last two are told.
 * @param {number[]} route
 * @param {Level | undefined} level
 */
export function routeText(route, level, most = Infinity) {
  /** @type {{name: string, count: number}[]} */
  const steps = [];
  for (const name of route.map((part) => partName(level, part))) {
    const last = steps.at(-1);
    if (last?.name === name) last.count += 1;
    else steps.push({ name, count: 1 });
  }
  const words = steps.map(({ name, count }) => (count > 1 ? `${name} ×${count}` : name));
  const told = words.length > most ? [...words.slice(0, 2), '…', ...words.slice(-2)] : words;
  return told.join(' → ');
}
