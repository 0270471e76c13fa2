// Lists an answer's findings besides its verdict: the proof's cut, changes that would help,
// routes, and the search's saturation.
import { partName } from '../part_name.js';
import { routeNames } from '../route_names.js';
import { routeText } from '../route_text.js';
import { el, plural, seconds } from './dom.js';

/** @import {Store} from '../store.js' */
/** @import {Cut, ResultRoute} from '../types/page_data.js' */
/** @import {Level, Query, Result} from '../types/report.js' */

const kMaxRoutes = 6;

/** @type {Record<string, string | undefined>} */
const SATURATION = {
  saturated: 'The search has explored nearly everything that it can tell apart.',
  growing: 'The search was still reaching new places. More time may solve it.',
};

/**
 * Returns a line of text. If `part` is in the level, a click shows it.
 * @param {string} text
 * @param {number} part
 * @param {Level | undefined} level
 * @param {Store} store
 */
function line(text, part, level, store) {
  if (!(part >= 0 && part < (level?.count ?? 0))) return el('li', { text });
  const show = { click: () => store.set({ part, frame: part }) };
  return el(
    'li',
    {},
    el('button', { class: 'plain text', type: 'button', text, data: { key: text }, on: show }),
  );
}

/**
 * @param {Result} result
 * @param {Level | undefined} level
 * @param {Store} store
 */
function help(result, level, store) {
  if (!result.relaxations?.length) return [];
  return [
    el('h3', { text: 'What would help' }),
    el('ul', {}, ...result.relaxations.map(({ text, part }) => line(text, part, level, store))),
  ];
}

/** @param {number} n */
const reachable = (n) => `At most ${n} ${n === 1 ? 'part is' : 'parts are'} reachable`;

/**
 * Describes what the smallest impossible step lacks.
 * @param {Cut} cut
 */
export function lackOf({ rise, gap, jumps, seconds: time }) {
  const lacks = [];
  if (rise > 0) lacks.push(`at least ${rise.toFixed(1)} studs of height`);
  if (gap > 0) lacks.push(`at least ${gap.toFixed(1)} studs of distance`);
  if (jumps > 0) lacks.push(`needs at least ${plural(jumps, 'jump')}`);
  if (time > 0) lacks.push(`needs at least ${seconds(time)} s`);
  return lacks.join(', ');
}

/**
 * @param {Result} result
 * @param {Level | undefined} level
 * @param {Store} store
 */
function proof(result, level, store) {
  const { cut } = result;
  if (!cut) return [];
  const from = cut.from >= 0 ? partName(level, cut.from) : 'the start';
  const to = cut.to >= 0 ? partName(level, cut.to) : 'the goal';
  const lack = lackOf(cut);
  return [
    el('h3', { text: 'Why there is no solution' }),
    el(
      'ul',
      { class: 'proof' },
      line(reachable(cut.reached.length), -1, level, store),
      line(`Smallest impossible step: ${from} to ${to}`, cut.from, level, store),
      ...(lack ? [line(`Missing: ${lack}`, cut.to, level, store)] : []),
    ),
  ];
}

/**
 * Lists the routes. A click filters a route's trajectories, and another click shows all again.
 * @param {Query} query
 * @param {Result} result
 * @param {Level | undefined} level
 * @param {Store} store
 */
function routes(query, result, level, store) {
  if (!result.routes || result.routes.length < 2) return [];
  const rate = level?.tickRate ?? 60;
  const names = routeNames(query, level);
  const toggle = (/** @type {string} */ key) =>
    store.set({ route: store.state.route === key ? '' : key });
  const routeLine = (/** @type {ResultRoute} */ { route, count, ticks }) => {
    const key = route.join(' ');
    return el(
      'li',
      {},
      el('button', {
        class: 'plain text trajectory',
        type: 'button',
        data: { key: `route ${key}` },
        title: `Show only these: ${routeText(route, level)}`,
        text: names.get(key)?.text ?? key,
        on: { click: () => toggle(key) },
      }),
      el('small', {
        text: `${plural(Number(count), 'solution')}, fastest ${seconds(ticks / rate)} s`,
      }),
    );
  };
  const told = result.routes.slice(0, kMaxRoutes).map(routeLine);
  const left = result.routes.length - told.length;
  if (left > 0) told.push(el('li', { class: 'quiet', text: `and ${left} more` }));
  return [el('h3', { text: 'Routes' }), el('ul', {}, ...told)];
}

/** @param {Result} result */
function trust(result) {
  const text = SATURATION[result.evidence?.saturation ?? ''];
  if (result.verdict !== 'unknown' || !text) return [];
  return [el('p', { class: 'quiet', text })];
}

/**
 * Returns the element of the findings, which is hidden if there are none.
 * @param {Query} query
 * @param {Level | undefined} level
 * @param {Store} store
 */
export function findings(query, level, store) {
  const result = query.result;
  if (!result) return el('div', { hidden: true });
  const parts = [
    ...proof(result, level, store),
    ...help(result, level, store),
    ...routes(query, result, level, store),
    ...trust(result),
  ];
  return el('div', { class: 'findings', hidden: parts.length === 0 }, ...parts);
}
