// Names by which the routes of one query can be told apart: the parts that a route touches and others do not.
import { partName } from './part_name.js';
import { routeText } from './route_text.js';

const kMostNames = 5; // of a route that is written out
const kMostMarks = 3; // parts that tell a route from the others
const kMostRoutes = 50; // compared with one another

// Part -> its name; parts of one name are numbered.
function namesOf(routes, level) {
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

// The part whose presence in the route, or else absence from it, excludes most of `others`.
function bestMark(own, others, parts) {
  let best = null;
  for (const isOn of [true, false])
    for (const part of parts) {
      if (own.has(part) !== isOn) continue;
      const left = others.filter((other) => other.has(part) === isOn);
      if (left.length < (best?.left ?? others).length) best = { part, isOn, left };
    }
  return best;
}

// What tells a route from all others: "via Plank", "without Lift"; its number where parts do not.
function markOf(index, sets, parts, names) {
  let others = sets.filter((_, i) => i !== index);
  const marks = [];
  while (others.length && marks.length < kMostMarks) {
    const mark = bestMark(sets[index], others, parts);
    if (!mark) break;
    marks.push(`${mark.isOn ? 'via' : 'without'} ${names.get(mark.part)}`);
    others = mark.left;
  }
  if (others.length) marks.push(`route ${index + 1}`);
  return marks.join(', ');
}

const known = new WeakMap(); // by query: a query that has changed is another object

// Key of a route (choice.js) -> {mark, text}: `text` is its course, with the mark where another reads the same. With one
// route the mark is empty.
export function routeNames(query, level) {
  if (known.has(query)) return known.get(query);
  const found = [
    ...(query.result?.routes ?? []).map(({ route }) => route),
    ...query.paths.map(({ route }) => route ?? []),
  ].filter((route) => route.length);
  const routes = [...new Map(found.map((route) => [route.join(' '), route])).entries()];
  const compared = routes.slice(0, kMostRoutes).map(([, route]) => route);
  const sets = compared.map((route) => new Set(route));
  const parts = [...new Set(compared.flat())];
  const names = namesOf(compared, level);
  const texts = routes.map(([, route]) => routeText(route, level, kMostNames));
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
