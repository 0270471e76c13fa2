// The left column: the queries with their verdicts, the numbers of the chosen one, and its trajectories.
import {
  BAND_STYLE,
  causeOf,
  hardestOf,
  OUTCOME_STYLE,
  pathColor,
  VERDICT_STYLE,
  verdictOf,
} from '../palette.js';
import { count, el, plural, seconds } from './dom.js';
import { findings } from './findings.js';

const kMostRows = 400;
const KIND_NAMES = { solution: 'Solution', closest: 'Closest', newest: 'Newest' };

function badge(verdict) {
  const style = VERDICT_STYLE[verdict];
  return el('span', {
    class: 'badge',
    text: style.mark,
    style: { '--tint': style.color },
    title: style.label,
  });
}

function jumpLimits({ minJumps, maxJumps }) {
  if (maxJumps >= 0 && maxJumps === minJumps) return [`exactly ${plural(maxJumps, 'jump')}`];
  const limits = [];
  if (maxJumps >= 0) limits.push(`at most ${plural(maxJumps, 'jump')}`);
  if (minJumps > 0) limits.push(`at least ${plural(minJumps, 'jump')}`);
  return limits;
}

// fallingDown: falling down
const stateName = (state) => state.replace(/[A-Z]/g, (c) => ` ${c.toLowerCase()}`);

export class Sidebar {
  constructor(root, report, store, playback) {
    Object.assign(this, { root, report, store, playback });
    this.queries = el('div', { class: 'queries', role: 'listbox', 'aria-label': 'Queries' });
    this.detail = el('div', { class: 'detail' });
    this.list = el('div', { class: 'paths', role: 'listbox', 'aria-label': 'Trajectories' });
    root.append(this.header(), ...this.notes(), this.querySection(), this.detail, this.list);
    this.fillQueries();
    this.fillQuery();
    store.on(['query'], () => {
      this.markQuery();
      this.fillQuery();
    });
    store.on(['path', 'hoverPath'], () => this.markPaths());
  }

  header() {
    const solved = this.report.queries.filter((query) => verdictOf(query) === 'solved').length;
    const total = this.report.queries.length;
    const summary = total
      ? `${solved} of ${plural(total, 'query').replace('querys', 'queries')} solved`
      : 'Level only';
    return el(
      'header',
      { class: 'head' },
      el('h1', { text: this.report.title }),
      el('p', { class: 'quiet', text: summary }),
    );
  }

  notes() {
    return this.report.notes.map((note) => el('p', { class: 'note', text: note }));
  }

  querySection() {
    const section = el('section', { class: 'block grow-little' });
    if (this.report.queries.length > 8) {
      section.append(
        el('input', {
          class: 'search',
          type: 'search',
          placeholder: 'Find a query',
          'aria-label': 'Find a query',
          on: { input: (event) => this.filter(event.target.value) },
        }),
      );
    }
    section.append(this.queries);
    section.hidden = this.report.queries.length === 0;
    return section;
  }

  filter(text) {
    const wanted = text.toLowerCase();
    for (const row of this.queries.children) row.hidden = !row.dataset.name.includes(wanted);
  }

  fillQueries() {
    this.report.queries.forEach((query, index) => {
      const level = this.report.levels[query.level];
      const result = query.result;
      const facts =
        result?.verdict === 'solved' && level
          ? `${seconds(result.ticks / level.tickRate)} s`
          : VERDICT_STYLE[verdictOf(query)].label;
      this.queries.append(
        el(
          'button',
          {
            class: 'row query',
            role: 'option',
            type: 'button',
            data: { name: query.id.toLowerCase(), query: index },
            on: { click: () => this.store.set({ query: index }) },
          },
          badge(verdictOf(query)),
          el('span', { class: 'name', text: query.id || 'Query' }),
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
  }

  fillQuery() {
    const query = this.report.queries[this.store.state.query];
    this.detail.replaceChildren();
    this.list.replaceChildren();
    if (!query) return;
    this.detail.append(
      ...this.verdict(query),
      this.limits(query),
      this.numbers(query),
      findings(query, this.report.levels[query.level]),
      this.ends(query),
    );
    this.fillPaths(query);
  }

  verdict(query) {
    const style = VERDICT_STYLE[verdictOf(query)];
    const broken = query.paths.find((path) => path.mismatch && path.kind === 'solution');
    const reason = broken
      ? `A recorded solution does not hold: ${broken.mismatch}.`
      : query.result?.reason;
    return [
      el('h2', { class: 'verdict', text: style.label, style: { '--tint': style.color } }),
      el('p', { class: 'reason', text: reason ?? '', hidden: !reason }),
    ];
  }

  limits(query) {
    const parts = [];
    parts.push(...jumpLimits(query));
    if (query.timeLimit > 0) parts.push(`within ${seconds(query.timeLimit)} s`);
    if (query.waypoints.length) parts.push(plural(query.waypoints.length, 'waypoint'));
    if (query.visits.length) parts.push(`${plural(query.visits.length, 'place')} in any order`);
    if (query.goals.length) parts.push(`one of ${query.goals.length + (query.goal ? 1 : 0)} goals`);
    if (query.avoid.length) parts.push(`${plural(query.avoid.length, 'region')} to avoid`);
    if (query.maxDamage >= 0) parts.push(`at most ${query.maxDamage} health lost`);
    if (query.forbid.length) parts.push(`never ${query.forbid.map(stateName).join(' or ')}`);
    return el('p', {
      class: 'quiet limits',
      text: parts.length ? `Asked: ${parts.join(', ')}` : '',
      hidden: !parts.length,
    });
  }

  numbers(query) {
    const grid = el('dl', { class: 'numbers' });
    const r = query.result;
    if (!r) return grid;
    const rate = this.report.levels[query.level]?.tickRate ?? 60;
    const add = (label, value) =>
      grid.append(el('div', {}, el('dt', { text: label }), el('dd', { text: value })));
    if (r.verdict === 'solved') {
      add('Play time', `${seconds(r.ticks / rate)} s`);
      add('Jumps', String(r.jumps));
      if (r.firstSolution > 0) add('Found after', `${seconds(r.firstSolution)} s`);
    } else if (Number(r.steps) > 0) {
      add('Closest', `${r.closest.toFixed(1)} studs`);
      if (r.seconds > 0) add('Searched', `${seconds(r.seconds)} s`);
    }
    if (Number(r.steps) > 0) add('Steps', count(r.steps));
    if (Number(r.cells) > 0) add('Cells', count(r.cells));
    if (r.stepsPerSecond > 0) add('Steps/s', count(Math.round(r.stepsPerSecond)));
    return grid;
  }

  // How the attempts ended, as one bar.
  ends(query) {
    const totals = new Map();
    for (const end of query.result?.ends ?? [])
      totals.set(end.outcome, (totals.get(end.outcome) ?? 0) + Number(end.count));
    const all = [...totals.values()].reduce((a, b) => a + b, 0);
    const box = el('div', { class: 'ends', hidden: all === 0 });
    const bar = el('div', { class: 'bar' });
    const key = el('div', { class: 'key' });
    for (const [outcome, n] of [...totals].sort((a, b) => b[1] - a[1])) {
      const style = OUTCOME_STYLE[outcome];
      const share = (100 * n) / all;
      bar.append(
        el('i', {
          style: { '--tint': style.color, 'flex-grow': String(Math.max(share, 0.6)) },
          title: `${style.label}: ${n}`,
        }),
      );
      key.append(
        el('span', {
          style: { '--tint': style.color },
          text: `${style.short} ${share < 1 ? '<1' : Math.round(share)} %`,
        }),
      );
    }
    box.append(el('h3', { text: 'How attempts ended' }), bar, key);
    return box;
  }

  fillPaths(query) {
    const groups = [
      ['Solutions', query.paths.filter((path) => path.kind === 'solution')],
      ['Attempts', query.paths.filter((path) => path.kind !== 'solution')],
    ];
    for (const [title, paths] of groups) {
      if (!paths.length) continue;
      this.list.append(el('h3', {}, title, el('small', { text: ` ${paths.length}` })));
      for (const path of paths.slice(0, kMostRows)) this.list.append(this.pathRow(query, path));
      if (paths.length > kMostRows) {
        this.list.append(
          el('p', {
            class: 'quiet',
            text: `and ${paths.length - kMostRows} more: click their lines`,
          }),
        );
      }
    }
    if (!query.paths.length)
      this.list.append(
        el('p', { class: 'quiet', text: 'The stream holds no trajectory of this query.' }),
      );
    this.markPaths();
  }

  pathRow(query, path) {
    const index = query.paths.indexOf(path);
    const level = this.report.levels[query.level];
    const cause = path.mismatch ? `Replay mismatch: ${path.mismatch}` : causeOf(path, level);
    const name = KIND_NAMES[path.kind] ?? OUTCOME_STYLE[path.outcome].short;
    return el(
      'button',
      {
        class: `row path${path.mismatch ? ' mismatch' : ''}`,
        role: 'option',
        type: 'button',
        title: [cause, hardestOf(path, level)].filter(Boolean).join('. '),
        data: { path: index },
        on: {
          click: () => this.choose(index),
          pointerenter: () => this.store.set({ hoverPath: index }),
          pointerleave: () => this.store.set({ hoverPath: -1 }),
        },
      },
      el('i', { class: `swatch ${path.kind}`, style: { '--tint': pathColor(path) } }),
      el('span', { class: 'name', text: path.mismatch ? `${name} ≠` : name }),
      ...this.bandOf(path),
      el('span', { class: 'fact', text: `${plural(path.jumps, 'jump')}` }),
      el('span', {
        class: 'fact time',
        text: `${seconds(path.ticks / (level?.tickRate ?? 60))} s`,
      }),
    );
  }

  bandOf(path) {
    if (!path.difficulty) return [];
    const style = BAND_STYLE[path.difficulty.band];
    return [el('span', { class: 'fact band', text: style.label, style: { color: style.color } })];
  }

  choose(index) {
    const same = this.store.state.path === index;
    this.store.set(same ? { path: -1, playing: false } : { path: index, tick: 0 });
  }

  markPaths() {
    const { path, hoverPath } = this.store.state;
    for (const row of this.list.querySelectorAll('.path')) {
      const index = Number(row.dataset.path);
      row.setAttribute('aria-selected', String(index === path));
      row.classList.toggle('hover', index === hoverPath);
      if (index === path) row.scrollIntoView({ block: 'nearest' });
    }
  }
}
