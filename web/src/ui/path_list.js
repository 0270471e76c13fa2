// The filtered trajectories of the query: their count, sorting and colouring, and a row for each.
import { isAttempt, SORTS } from '../choice.js';
import { COLORINGS } from '../coloring.js';
import { BAND_STYLE, causeOf, hardestOf } from '../palette.js';
import { partName } from '../part_name.js';
import { solutionNames } from '../solution_names.js';
import { checkbox, choice, el, plural, reveal, seconds, trajectories } from './dom.js';
import { OneStop } from './one_stop.js';

/** @import {Path} from '../path.js' */
/** @import {Store} from '../store.js' */
/** @import {Query, Sort, Source, Tint} from '../types/report.js' */

const kMaxRows = 400;
/** @type {Record<string, string | undefined>} */
const KIND_NAMES = { closest: 'Closest', newest: 'Newest' };

/**
 * @template {string} K
 * @param {Record<K, string>} names
 */
const entries = (names) => /** @type {[K, string][]} */ (Object.entries(names));

/**
 * Says why the list is empty.
 * @param {number} all trajectories of the query
 * @param {number} listed ... that pass the filter
 */
function emptyText(all, listed) {
  if (!all) return 'This query has no trajectories.';
  return listed ? 'Only failed attempts, which are not shown.' : 'No trajectory matches the filter.';
}

/**
 * Marks the first solution, until the improved one replaces it.
 * @param {Path} path
 */
function firstOf({ provisional }) {
  const title = 'The first solution, before it is improved';
  return provisional ? [el('span', { class: 'fact', text: 'first found', title })] : [];
}

export class PathList {
  /**
   * `sourceOf`: returns the current {query, level}; `tintOf`: path -> colour.
   * @param {Store} store
   * @param {() => Source} sourceOf
   * @param {Tint} tintOf
   */
  constructor(store, sourceOf, tintOf) {
    this.store = store;
    this.sourceOf = sourceOf;
    this.tintOf = tintOf;
    this.count = el('output', { class: 'count' });
    this.attempts = this.attemptsSwitch();
    this.rows = el('div', { class: 'paths', role: 'listbox', 'aria-label': 'Trajectories' });
    this.root = el('section', { class: 'list' }, this.bar(), this.rows);
    this.stop = new OneStop(this.rows);
    store.on(['order', 'attempts'], () => this.stop.refill(() => this.fill()));
    store.on(['colorBy'], () => this.color());
    store.on(['path', 'hoverPath', 'ghost', 'order', 'attempts'], () => this.mark());
    store.on(['path', 'order'], () => reveal(this.rows));
  }

  bar() {
    const { store } = this;
    const direction = el('button', {
      class: 'plain direction',
      type: 'button',
      on: { click: () => store.set({ descending: !store.state.descending }) },
    });
    const showDirection = () => {
      const { descending } = store.state;
      direction.textContent = descending ? '↓' : '↑';
      direction.setAttribute('aria-label', descending ? 'Largest first' : 'Smallest first');
      direction.title = descending ? 'Largest first' : 'Smallest first';
    };
    store.on(['descending'], showDirection);
    showDirection();
    return el(
      'div',
      { class: 'list-bar' },
      el('div', { class: 'list-head' }, this.count, this.attempts),
      choice(store, 'sort', 'Sort by', entries(SORTS)),
      direction,
      choice(store, 'colorBy', 'Colour by', entries(COLORINGS)),
    );
  }

  // Attempts are listed and drawn on request.
  attemptsSwitch() {
    const { store } = this;
    const input = checkbox((checked) => store.set({ attempts: checked }));
    store.on(['attempts'], ({ attempts }) => {
      input.checked = attempts;
    });
    input.checked = store.state.attempts;
    return el('label', { class: 'attempts', title: 'Key 2' }, input, el('span', {}));
  }

  /** @param {Query} query */
  fillSwitch({ paths }) {
    const failed = paths.filter(isAttempt).length;
    const text = /** @type {HTMLElement} */ (this.attempts.lastChild);
    text.textContent = `${plural(failed, 'failed attempt')}`;
    this.attempts.hidden = failed === 0;
  }

  fill() {
    const { query } = this.sourceOf();
    this.rows.replaceChildren();
    this.count.textContent = '';
    this.root.hidden = !query; // a level without a query has no trajectories
    if (!query) return;
    const { order: listed, sort, attempts } = this.store.state;
    this.fillSwitch(query);
    const order = listed.filter((index) => attempts || !isAttempt(query.paths[index]));
    const all = query.paths.length;
    this.count.textContent =
      listed.length === all ? trajectories(all) : `${listed.length} of ${trajectories(all)}`;
    for (const [title, indices] of this.groups(query, order, sort)) {
      const group = el('div', { role: 'group', 'aria-label': title || undefined });
      const count = el('small', { text: ` ${indices.length}` });
      if (title) group.append(el('h3', { role: 'presentation' }, title, count));
      for (const index of indices.slice(0, kMaxRows))
        group.append(this.row(query.paths[index], index));
      if (indices.length > kMaxRows)
        group.append(
          el('p', {
            class: 'quiet',
            text: `and ${indices.length - kMaxRows} more. Filter the list, or click their lines.`,
          }),
        );
      this.rows.append(group);
    }
    // An empty list box would be an error.
    this.rows.setAttribute('role', order.length ? 'listbox' : 'group');
    if (!order.length)
      this.rows.append(
        el('p', {
          class: 'quiet',
          text: emptyText(all, listed.length),
        }),
      );
  }

  /**
   * Sorted by discovery, solutions form their own group; otherwise there is one list.
   * @param {Query} query
   * @param {number[]} order
   * @param {Sort} sort
   * @returns {[title: string, indices: number[]][]}
   */
  groups(query, order, sort) {
    if (sort !== 'found') return [['', order]];
    const ofKinds = (/** @type {string[]} */ ...kinds) =>
      order.filter((index) => kinds.includes(query.paths[index].kind));
    /** @type {[string, number[]][]} */
    const groups = [
      ['Solutions', ofKinds('solution')],
      ['Best so far', ofKinds('closest', 'newest')],
      ['Failed attempts', ofKinds('attempt')],
    ];
    return groups.filter(([, indices]) => indices.length);
  }

  /**
   * @param {Path} path
   * @param {number} index
   */
  row(path, index) {
    const { level } = this.sourceOf();
    const cause = path.mismatch ? `Replay mismatch: ${path.mismatch}` : causeOf(path, level);
    const { name, facts } = this.words(path, index);
    const help = [cause, hardestOf(path, level), 'Shift-click to compare'].filter(Boolean);
    return el(
      'button',
      {
        class: `row path${path.mismatch ? ' mismatch' : ''}`,
        role: 'option',
        tabindex: -1,
        type: 'button',
        title: help.join('. '),
        data: { path: index, key: `trajectory ${path.serial ?? index}` },
        on: {
          click: (event) => this.choose(index, event.shiftKey),
          pointerenter: () => this.store.set({ hoverPath: index }),
          pointerleave: () => this.store.set({ hoverPath: -1 }),
        },
      },
      el('i', { class: `swatch ${path.kind}`, style: { '--tint': this.tintOf(path) } }),
      el('span', { class: 'name', text: path.mismatch ? `${name} ≠` : name }),
      ...this.bandOf(path),
      ...firstOf(path),
      ...facts,
    );
  }

  /**
   * Describes a solution by what sets it apart, and an attempt by how it ended.
   * @param {Path} path
   * @param {number} index
   */
  words(path, index) {
    const { query, level } = this.sourceOf();
    const fact = (/** @type {string} */ text, more = '') =>
      el('span', { class: `fact${more}`, text });
    const solution = query && solutionNames(query, level).get(index);
    if (solution) {
      const [jumps, time] = solution.facts;
      return { name: solution.name, facts: jumps ? [fact(jumps), fact(time, ' time')] : [] };
    }
    const time = `${seconds(path.ticks / (level?.tickRate ?? 60))} s`;
    return {
      name: KIND_NAMES[path.kind] ?? causeOf(path, level, partName, 'short'),
      facts: [fact(plural(path.jumps, 'jump')), fact(time, ' time')],
    };
  }

  /** @returns {NodeListOf<HTMLElement>} */
  pathRows() {
    return this.rows.querySelectorAll('.path');
  }

  // Updates the colours; the list is unchanged.
  color() {
    const { query } = this.sourceOf();
    if (!query) return;
    for (const row of this.pathRows()) {
      /** @type {HTMLElement | null} */
      const swatch = row.querySelector('.swatch');
      const tint = this.tintOf(query.paths[Number(row.dataset.path)]);
      swatch?.style.setProperty('--tint', tint);
    }
  }

  /** @param {Path} path */
  bandOf(path) {
    if (!path.difficulty) return [];
    const style = BAND_STYLE[path.difficulty.band];
    const tint = { '--tint': style.color };
    return [el('span', { class: 'fact band', text: style.label, style: tint })];
  }

  /**
   * @param {number} index
   * @param {boolean} beside
   */
  choose(index, beside) {
    const { path, ghost } = this.store.state;
    if (beside) this.store.set({ ghost: ghost === index || path === index ? -1 : index });
    else if (path === index) this.store.set({ path: -1, playing: false });
    else this.store.set({ path: index, tick: 0 });
  }

  mark() {
    const { path, hoverPath, ghost } = this.store.state;
    for (const row of this.pathRows()) {
      const index = Number(row.dataset.path);
      row.setAttribute('aria-selected', String(index === path));
      row.classList.toggle('hover', index === hoverPath);
      row.classList.toggle('ghost', index === ghost);
      if (index === ghost) row.setAttribute('aria-description', 'compared with the selected one');
      else row.removeAttribute('aria-description');
    }
    this.stop.settle();
  }
}
