// The left column: the queries with their verdicts, and the details of the selected one.
import { VERDICT_STYLE, verdictOf } from '../palette.js';
import { kMostAlike } from '../scene/regions.js';
import { deaths } from './deaths.js';
import { count, el, keepingPlace, plural, reveal, seconds } from './dom.js';
import { findings } from './findings.js';
import { OneStop } from './one_stop.js';

const kMostUnsearched = 8; // number of queries that needs no search field

function badge(verdict) {
  const style = VERDICT_STYLE[verdict];
  return el('span', {
    class: 'badge',
    role: 'img', // screen readers would skip the sign or spell it
    'aria-label': style.label,
    text: style.mark,
    style: { '--tint': style.color },
    title: style.label,
  });
}

function jumpLimits({ minJumps, maxJumps }) {
  if (maxJumps === 0) return ['no jumps'];
  if (maxJumps >= 0 && maxJumps === minJumps) return [`exactly ${plural(maxJumps, 'jump')}`];
  const limits = [];
  if (maxJumps >= 0) limits.push(`at most ${plural(maxJumps, 'jump')}`);
  if (minJumps > 0) limits.push(`at least ${plural(minJumps, 'jump')}`);
  return limits;
}

function numberGrid(facts) {
  const grid = el('dl', { class: 'numbers' });
  for (const [label, value] of facts)
    grid.append(el('div', {}, el('dt', { text: label }), el('dd', { text: value })));
  return grid;
}

// Returns ids that occur in several levels.
function sharedIds(queries) {
  const levels = new Map(queries.map(({ id, level }) => [id, level]));
  return new Set(queries.filter(({ id, level }) => levels.get(id) !== level).map(({ id }) => id));
}

// Converts fallingDown to falling down.
const stateName = (state) => state.replace(/[A-Z]/g, (c) => ` ${c.toLowerCase()}`);

export class Sidebar {
  // `lists`: elements below the query.
  constructor(root, report, store, lists) {
    Object.assign(this, { root, report, store });
    this.queries = el('div', { class: 'queries', role: 'listbox', 'aria-label': 'Queries' });
    this.stop = new OneStop(this.queries);
    this.detail = el('div', { class: 'detail' });
    this.head = el('header', { class: 'head' });
    this.notes = el('div', {});
    root.append(this.head, this.notes, this.querySection(), this.detail, ...lists);
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
    this.search.hidden = this.report.queries.length <= kMostUnsearched;
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
    const solved = this.report.queries.filter((query) => ['solved', 'doubtful'].includes(verdictOf(query))).length;
    const total = this.report.queries.length;
    const summary = total
      ? `${solved} of ${total} ${total === 1 ? 'query' : 'queries'} solved`
      : 'Level only';
    this.head.replaceChildren(
      el('h1', { text: this.report.title }),
      el('p', { class: 'quiet', text: summary }),
    );
  }

  querySection() {
    this.search = el('input', {
      class: 'search',
      type: 'search',
      placeholder: 'Find a query',
      'aria-label': 'Find a query',
      on: { input: (event) => this.filter(event.target.value) },
    });
    this.section = el('section', { class: 'block grow-little' }, this.search, this.queries);
    return this.section;
  }

  filter(text) {
    const wanted = text.toLowerCase();
    for (const row of this.queries.children) row.hidden = !row.dataset.name.includes(wanted);
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
    for (const row of this.queries.children) {
      row.setAttribute(
        'aria-selected',
        String(Number(row.dataset.query) === this.store.state.query),
      );
    }
    this.stop.settle();
    reveal(this.queries);
  }

  markKillers() {
    for (const row of this.detail.querySelectorAll('.ends .killer'))
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
      this.limits(query),
      this.numbers(query),
      this.effort(query),
      findings(query, level, this.store),
      deaths(query, level, this.store),
    );
  }

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

  // Describes start and goal by the names of their places.
  course({ start, goal }) {
    const ends = [start?.name && `from ${start.name}`, goal?.name && `to ${goal.name}`];
    const text = ends.filter(Boolean).join(' ');
    return el('p', { class: 'quiet course', text, hidden: !text });
  }

  limits(query) {
    const parts = [];
    parts.push(...jumpLimits(query));
    if (query.timeLimit > 0) parts.push(`within ${seconds(query.timeLimit)} s`);
    if (query.waypoints.length) parts.push(plural(query.waypoints.length, 'waypoint'));
    if (query.visits.length) parts.push(`${plural(query.visits.length, 'place')} in any order`);
    const drawn = ({ length }) => (length > kMostAlike ? ` (${kMostAlike} are drawn)` : '');
    const goals = query.goals.length + (query.goal ? 1 : 0);
    if (query.goals.length) parts.push(`one of ${plural(goals, 'goal')}${drawn(query.goals)}`);
    if (query.avoid.length)
      parts.push(`${plural(query.avoid.length, 'region')} to avoid${drawn(query.avoid)}`);
    if (query.maxDamage >= 0) parts.push(`at most ${query.maxDamage} health lost`);
    if (query.forbid.length) parts.push(`never ${query.forbid.map(stateName).join(' or ')}`);
    return el('p', {
      class: 'quiet limits',
      text: parts.length ? `Limits: ${parts.join(', ')}` : '',
      hidden: !parts.length,
    });
  }

  numbers(query) {
    const r = query.result ?? query.progress ?? {}; // progress of a running search
    const rate = this.report.levels[query.level]?.tickRate ?? 60;
    const facts = [];
    const add = (...fact) => facts.push(fact);
    if (r.verdict === 'solved') {
      add('Play time', `${seconds(r.ticks / rate)} s`);
      add('Jumps', String(r.jumps));
      if (r.firstSolution > 0) add('Found after', `${seconds(r.firstSolution)} s`);
    } else if (Number(r.steps) > 0) {
      add('Closest to goal', `${r.closest.toFixed(1)} studs`);
      if (r.seconds > 0) add('Searched', `${seconds(r.seconds)} s`);
    }
    return numberGrid(facts);
  }

  // Adds the search's effort, folded by default.
  effort(query) {
    const r = query.result ?? query.progress ?? {};
    const facts = [];
    if (Number(r.steps) > 0) facts.push(['Simulated ticks', count(r.steps)]);
    if (Number(r.cells) > 0) facts.push(['Places explored', count(r.cells)]);
    if (r.stepsPerSecond > 0) facts.push(['Ticks per second', count(Math.round(r.stepsPerSecond))]);
    return el(
      'details',
      { hidden: !facts.length, open: this.isEffortOpen },
      el('summary', {
        text: 'Search effort',
        data: { key: 'effort' },
        // A toggle event would come too late for a refresh before it.
        on: { click: (event) => (this.isEffortOpen = !event.currentTarget.parentNode.open) },
      }),
      numberGrid(facts),
    );
  }
}
