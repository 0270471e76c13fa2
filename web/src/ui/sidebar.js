// The left column: the queries with their verdicts, and the details of the selected one.
import { isSolved, VERDICT_STYLE, verdictOf } from '../palette.js';
import { deaths } from './deaths.js';
import { count, el, keepingPlace, reveal, seconds } from './dom.js';
import { findings } from './findings.js';
import { limitsOf } from './limits.js';
import { OneStop } from './one_stop.js';

/** @import {ShownVerdict} from '../palette.js' */
/** @import {Store} from '../store.js' */
/** @import {Progress, Region} from '../types/page_data.js' */
/** @import {Query, Report, Result} from '../types/report.js' */

const kMaxUnsearched = 8; // max number of queries without a search field

/**
 * Returns a region's name, or `otherwise` if it has none or says the same.
 * @param {Region | null | undefined} region
 * @param {string} otherwise
 */
function placeName(region, otherwise) {
  const name = region?.name ?? '';
  return !name || otherwise.endsWith(name.toLowerCase()) ? otherwise : name;
}

/** @param {ShownVerdict} verdict */
function badge(verdict) {
  const style = VERDICT_STYLE[verdict];
  return el('span', {
    class: 'badge',
    role: 'img', // without a role, screen readers skip the sign or spell it out
    'aria-label': style.label,
    text: style.mark,
    style: { '--tint': style.color },
    title: style.label,
  });
}

/** @param {[label: string, value: string][]} facts */
function numberGrid(facts) {
  const grid = el('dl', { class: 'numbers' });
  for (const [label, value] of facts)
    grid.append(el('div', {}, el('dt', { text: label }), el('dd', { text: value })));
  return grid;
}

/**
 * Returns ids that occur in several levels.
 * @param {Query[]} queries
 */
function sharedIds(queries) {
  const levels = new Map(queries.map(({ id, level }) => [id, level]));
  return new Set(queries.filter(({ id, level }) => levels.get(id) !== level).map(({ id }) => id));
}

/**
 * Returns the answer's figures, or the progress of a running search.
 * @param {Query} query
 * @returns {Partial<Result & Progress>}
 */
const numbersOf = (query) => query.result ?? query.progress ?? {};

/**
 * @param {HTMLElement} list
 * @returns {HTMLElement[]}
 */
const rowsOf = (list) => /** @type {HTMLElement[]} */ ([...list.children]);

export class Sidebar {
  /**
   * `lists`: elements below the query.
   * @param {HTMLElement} root
   * @param {Report} report
   * @param {Store} store
   * @param {HTMLElement[]} lists
   */
  constructor(root, report, store, lists) {
    this.root = root;
    this.report = report;
    this.store = store;
    this.isEffortOpen = false;
    this.queries = el('div', { class: 'queries', role: 'listbox', 'aria-label': 'Queries' });
    this.stop = new OneStop(this.queries);
    this.detail = el('div', { class: 'detail' });
    this.head = el('header', { class: 'head' });
    this.notes = el('div', {});
    this.search = el('input', {
      class: 'search',
      type: 'search',
      placeholder: 'Find a query',
      'aria-label': 'Find a query',
      on: { input: () => this.filter(this.search.value) },
    });
    this.section = el('section', { class: 'block grow-little' }, this.search, this.queries);
    root.append(this.head, this.notes, this.section, this.detail, ...lists);
    this.fill();
    store.on(['query'], () => {
      this.markQuery();
      this.fillQuery();
    });
    store.on(['query', 'killer'], () => this.markKillers());
  }

  fill() {
    this.fillHead();
    this.notes.replaceChildren(
      ...this.report.notes.map((note) => el('p', { class: 'note', text: note })),
    );
    this.section.hidden = this.report.queries.length === 0;
    this.search.hidden = this.report.queries.length <= kMaxUnsearched;
    this.fillQueries();
    this.filter(this.search.value);
    this.fillQuery();
  }

  // Called when the report has changed.
  refresh() {
    keepingPlace(this.queries, () => keepingPlace(this.detail, () => this.fill()));
    this.markKillers();
  }

  fillHead() {
    const solved = this.report.queries.filter(isSolved).length;
    const total = this.report.queries.length;
    const summary = total
      ? `${solved} of ${total} ${total === 1 ? 'query' : 'queries'} solved`
      : 'Level only';
    this.head.replaceChildren(
      el('h1', { text: this.report.title }),
      el('p', { class: 'quiet', text: summary }),
    );
  }

  /** @param {string} text */
  filter(text) {
    const wanted = text.toLowerCase();
    for (const row of rowsOf(this.queries)) row.hidden = !row.dataset.name?.includes(wanted);
    this.stop.settle();
  }

  fillQueries() {
    this.queries.replaceChildren();
    const shared = sharedIds(this.report.queries);
    this.report.queries.forEach((query, index) => {
      const level = this.report.levels[query.level];
      const heading = query.title || query.id || 'Query';
      const name = level && shared.has(query.id) ? `${heading} · ${level.name || 'Level'}` : heading;
      const result = query.result;
      const facts =
        result?.verdict === 'solved' && level
          ? `${seconds(result.ticks / level.tickRate)} s`
          : VERDICT_STYLE[verdictOf(query)].short ?? VERDICT_STYLE[verdictOf(query)].label;
      this.queries.append(
        el(
          'button',
          {
            class: 'row query',
            role: 'option',
            tabindex: -1,
            type: 'button',
            data: { name: `${name} ${query.id}`.toLowerCase(), query: index, key: `query ${index}` },
            on: { click: () => this.store.set({ query: index }) },
          },
          badge(verdictOf(query)),
          el('span', { class: 'name', text: name }),
          el('span', { class: 'fact', text: facts }),
        ),
      );
    });
    this.markQuery();
  }

  markQuery() {
    for (const row of rowsOf(this.queries)) {
      row.setAttribute(
        'aria-selected',
        String(Number(row.dataset.query) === this.store.state.query),
      );
    }
    this.stop.settle();
    reveal(this.queries);
  }

  markKillers() {
    /** @type {NodeListOf<HTMLElement>} */
    const rows = this.detail.querySelectorAll('.ends .killer');
    for (const row of rows)
      row.setAttribute(
        'aria-pressed',
        String(Number(row.dataset.part) === this.store.state.killer),
      );
  }

  fillQuery() {
    const query = this.report.queries[this.store.state.query];
    this.detail.replaceChildren();
    this.detail.hidden = !query;
    if (!query) return;
    const level = this.report.levels[query.level];
    this.detail.append(
      ...this.verdict(query),
      this.course(query),
      limitsOf(query),
      this.numbers(query),
      this.effort(query),
      findings(query, level, this.store),
      deaths(query, level, this.store),
    );
  }

  /** @param {Query} query */
  verdict(query) {
    const style = VERDICT_STYLE[verdictOf(query)];
    const broken = query.paths.find((path) => path.mismatch && path.kind === 'solution');
    const reason = broken
      ? `A recorded solution cannot be reproduced by replaying it: ${broken.mismatch}.`
      : query.result?.reason;
    return [
      el('h2', { class: 'verdict', text: style.label, style: { '--tint': style.color } }),
      el('p', { class: 'reason', text: reason ?? '', hidden: !reason }),
    ];
  }

  /**
   * Says from where to where a query goes, unless its title does.
   * @param {Query} query
   */
  course({ start, goal, goals, title }) {
    const from = placeName(start, 'the start');
    const count = goals.length + (goal ? 1 : 0);
    const to = count > 1 ? `one of ${count} goals` : placeName(goal ?? goals[0], 'the goal');
    const text = `From ${from} to ${to}`;
    return el('p', { class: 'quiet course', text, hidden: Boolean(title) });
  }

  /** @param {Query} query */
  numbers(query) {
    const { result } = query;
    const { steps, closest = 0, seconds: searched = 0 } = numbersOf(query);
    const rate = this.report.levels[query.level]?.tickRate ?? 60;
    /** @type {[string, string][]} */
    const facts = [];
    const add = (/** @type {[string, string]} */ ...fact) => facts.push(fact);
    const first = query.paths.find(({ provisional }) => provisional);
    const found = result?.verdict === 'solved' ? result : first;
    if (found) {
      add(found === first ? 'Play time so far' : 'Play time', `${seconds(found.ticks / rate)} s`);
      add(found === first ? 'Jumps so far' : 'Jumps', String(found.jumps));
    } else if (Number(steps) > 0) {
      add('Closest to goal', `${closest.toFixed(1)} studs`);
      if (searched > 0) add('Searched', `${seconds(searched)} s`);
    }
    return numberGrid(facts);
  }

  /**
   * Adds the search's effort, folded by default.
   * @param {Query} query
   */
  effort(query) {
    const { steps = 0, cells = 0, stepsPerSecond = 0, firstSolution = 0 } = numbersOf(query);
    /** @type {[string, string][]} */
    const facts = [];
    if (firstSolution > 0) facts.push(['Found after', `${seconds(firstSolution)} s`]);
    if (Number(steps) > 0) facts.push(['Simulated ticks', count(steps)]);
    if (Number(cells) > 0) facts.push(['Places explored', count(cells)]);
    if (stepsPerSecond > 0) facts.push(['Ticks per second', count(Math.round(stepsPerSecond))]);
    const details = el(
      'details',
      { hidden: !facts.length, open: this.isEffortOpen },
      el('summary', {
        text: 'Search effort',
        data: { key: 'effort' },
        // A toggle event may come after a refresh, which would lose the change.
        on: {
          click: () => {
            this.isEffortOpen = !details.open;
          },
        },
      }),
      numberGrid(facts),
    );
    return details;
  }
}
