// Names by which the solutions of a query can be told apart: time and jumps, the part that only their route touches, and a
// number where all of that is the same.
import { routeKey } from './choice.js';
import { routeNames } from './route_names.js';
import { plural, seconds } from './ui/dom.js';

const known = new WeakMap(); // by query: a query that has changed is another object

// Index of a solution -> {name, route}; the route is empty where all solutions take one.
export function solutionNames(query, level) {
  if (known.has(query)) return known.get(query);
  const rate = level?.tickRate ?? 60;
  const routes = routeNames(query, level);
  const taken = new Map();
  const names = new Map();
  query.paths.forEach((path, index) => {
    if (path.kind !== 'solution') return;
    const route = routes.get(routeKey(path))?.mark ?? '';
    const name = `${seconds(path.ticks / rate)} s, ${plural(path.jumps, 'jump')}`;
    const number = (taken.get(name + route) ?? 0) + 1;
    taken.set(name + route, number);
    names.set(index, { name: number > 1 ? `${name} (${number})` : name, route });
  });
  known.set(query, names);
  return names;
}
