// Shows how attempts ended, as one bar, and what killed the player. A click filters the
// trajectories by that end.
import { OUTCOME_STYLE } from '../palette.js';
import { fullName, partName } from '../part_name.js';
import { count, el, plural } from './dom.js';

/** @import {Store} from '../store.js' */
/** @import {Count, Outcome} from '../types/page_data.js' */
/** @import {Level, Query} from '../types/report.js' */

const kMaxKillers = 8;

/** @typedef {{outcome: Outcome, part: number, avoid: number, count: Count | number}} End */

/**
 * Returns [{outcome, part, avoid, count}] of the whole search, or of the trajectories if the result
 * has none.
 * @param {Query} query
 * @returns {End[]}
 */
function endsOf(query) {
  if (query.result?.ends.length) return query.result.ends;
  return query.paths
    .filter((path) => path.outcome !== 'goal')
    .map(({ outcome, part, avoid }) => ({ outcome, part, avoid: avoid ?? -1, count: 1 }));
}

/**
 * @template K
 * @param {End[]} ends
 * @param {(end: End) => K | undefined} keyOf
 * @returns {[key: K, count: number][]}
 */
function sums(ends, keyOf) {
  /** @type {Map<K, number>} */
  const totals = new Map();
  for (const end of ends) {
    const key = keyOf(end);
    if (key !== undefined) totals.set(key, (totals.get(key) ?? 0) + Number(end.count));
  }
  return [...totals].sort((a, b) => b[1] - a[1]);
}

/** @param {number} share */
const percent = (share) => `${share < 1 ? '<1' : Math.round(share)} %`;

/**
 * @param {[Outcome, number][]} totals
 * @param {number} all
 */
function bar(totals, all) {
  const line = el('div', { class: 'bar' });
  const key = el('div', { class: 'key' });
  for (const [outcome, n] of totals) {
    const style = OUTCOME_STYLE[outcome];
    const share = (100 * n) / all;
    line.append(
      el('i', {
        style: { '--tint': style.color, 'flex-grow': String(Math.max(share, 0.6)) },
        title: `${style.label}: ${n}`,
      }),
    );
    const text = `${style.short} ${percent(share)}`;
    key.append(el('span', { style: { '--tint': style.color }, text }));
  }
  return [line, key];
}

/**
 * @param {Query} query
 * @param {Level | undefined} level
 * @param {Store} store
 * @param {End[]} ends
 */
function killers(query, level, store, ends) {
  const totals = sums(ends, ({ outcome, part }) =>
    outcome === 'killed' && part >= 0 ? part : undefined,
  );
  if (!totals.length) return [];
  const max = totals[0][1];
  const row = (/** @type {[number, number]} */ [part, n]) => {
    const shown = query.paths.filter((p) => p.outcome === 'killed' && p.part === part).length;
    return el(
      'button',
      {
        class: 'killer',
        type: 'button',
        title: `${fullName(level, part)}: killed ${plural(n, 'attempt')}, ${shown} shown in this report`,
        style: { '--share': `${(100 * n) / max}%` },
        data: { part, key: `killer ${part}` },
        on: {
          click: () => {
            const again = store.state.killer === part;
            // The part may be from another version of the level.
            const known = part < (level?.count ?? 0);
            store.set({ killer: again ? -1 : part, part: again || !known ? -1 : part });
          },
        },
      },
      el('span', { class: 'name', text: partName(level, part) }),
      el('span', { class: 'fact', text: count(n) }),
    );
  };
  const rest = totals.length - kMaxKillers;
  return [
    el('h3', { text: 'Killed by' }),
    ...totals.slice(0, kMaxKillers).map(row),
    ...(rest > 0 ? [el('p', { class: 'quiet', text: `and ${plural(rest, 'more part')}` })] : []),
  ];
}

/**
 * @param {Query} query
 * @param {Level | undefined} level
 * @param {Store} store
 */
export function deaths(query, level, store) {
  const ends = endsOf(query);
  const totals = sums(ends, ({ outcome }) => outcome);
  const all = totals.reduce((sum, [, n]) => sum + n, 0);
  const box = el('div', { class: 'ends', hidden: all === 0 });
  if (all)
    box.append(
      el('h3', { text: 'How attempts ended' }),
      ...bar(totals, all),
      ...killers(query, level, store, ends),
    );
  return box;
}
