// The filters: outcome, route, killer, jumps, time, and boxes that a trajectory must or must not
// pass.
import { filtered, routeKey, UNFILTERED } from '../choice.js';
import { OUTCOME_STYLE } from '../palette.js';
import { partName } from '../part_name.js';
import { routeNames } from '../route_names.js';
import { BoxList } from './box_list.js';
import { choice, el, numberField } from './dom.js';

const kMostRoutes = 50;

export class FilterPanel {
  // `sourceOf`: returns the current {query, level}; `addBox`: adds a box in view.
  constructor(store, sourceOf, addBox) {
    Object.assign(this, { store, sourceOf });
    this.outcome = choice(store, 'outcome', 'Outcome', []);
    this.route = choice(store, 'route', 'Route', []);
    this.killer = choice(store, 'killer', 'Killed by', []);
    this.fields = el(
      'div',
      { class: 'fields' },
      this.outcome,
      this.route,
      this.killer,
      numberField(store, 'mostJumps', 'Max jumps', -1, { min: '0', step: '1' }),
      numberField(store, 'mostSeconds', 'Max seconds', 0, { min: '0', step: 'any' }),
    );
    this.clear = el('button', {
      class: 'plain text',
      type: 'button',
      text: 'Clear all',
      on: { click: () => store.set(UNFILTERED) },
    });
    this.boxes = new BoxList(store, sourceOf, addBox);
    this.body = el(
      'div',
      { class: 'filter-body', hidden: true },
      this.fields,
      this.boxes.root,
      this.clear,
    );
    this.fold = el('button', {
      class: 'fold',
      type: 'button',
      'aria-expanded': 'false',
      text: 'Filter',
      on: { click: () => this.open(this.body.hidden) },
    });
    this.root = el('section', { class: 'filters' }, this.fold, this.body);
    this.root.addEventListener('focusout', () => this.stale && this.fill());
    store.on(['order'], () => this.show());
    store.on(['boxes', 'drawing'], ({ boxes, drawing }) => {
      if (boxes.length || drawing) this.open(true);
    });
  }

  open(wanted) {
    this.body.hidden = !wanted;
    this.fold.setAttribute('aria-expanded', String(wanted));
  }

  // Called when the query has changed. A focused panel is updated only after it loses the focus.
  refresh() {
    this.stale = this.root.contains(document.activeElement);
    if (!this.stale) this.fill();
  }

  // Fills in the choices of the query.
  fill() {
    this.stale = false;
    const { query, level } = this.sourceOf();
    this.root.hidden = !query?.paths.length;
    if (!query) return;
    const routes = tally(query.paths.map(routeKey).filter(Boolean)).slice(0, kMostRoutes);
    const killers = tally(
      query.paths.filter((p) => p.outcome === 'killed' && p.part >= 0).map((p) => p.part),
    );
    const offer = (field, none, counts, nameOf) => {
      const named = counts.map(([key, n]) => [key, `${nameOf(key)} (${n})`]);
      field.offer([[none, 'any'], ...named]);
      field.hidden = counts.length < 2;
    };
    const outcomes = tally(query.paths.map((path) => path.outcome));
    offer(this.outcome, '', outcomes, (key) => OUTCOME_STYLE[key].short);
    offer(this.route, '', routes, (key) => routeNames(query, level).get(key).text);
    offer(this.killer, -1, killers, (part) => partName(level, part));
  }

  show() {
    const on = filtered(this.store.state);
    this.fold.classList.toggle('on', on);
    this.clear.hidden = !on;
  }
}

// Returns [value, count], most frequent first.
function tally(values) {
  const counts = new Map();
  for (const value of values) counts.set(value, (counts.get(value) ?? 0) + 1);
  return [...counts].sort((a, b) => b[1] - a[1]);
}
