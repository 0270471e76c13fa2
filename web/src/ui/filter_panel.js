// The filters: outcome, route, killer, jumps, time, and boxes that a trajectory must or must not
// pass.
import { filtered, routeKey, UNFILTERED } from '../choice.js';
import { OUTCOME_STYLE } from '../palette.js';
import { partName } from '../part_name.js';
import { routeNames } from '../route_names.js';
import { tally } from '../tally.js';
import { BoxList } from './box_list.js';
import { choice, el, numberField } from './dom.js';

/** @import {Store} from '../store.js' */
/** @import {Source} from '../types/report.js' */

const kMaxRoutes = 50;

export class FilterPanel {
  /**
   * `sourceOf`: returns the current {query, level}; `addBox`: adds a box in view.
   * @param {Store} store
   * @param {() => Source} sourceOf
   * @param {() => void} addBox
   */
  constructor(store, sourceOf, addBox) {
    this.store = store;
    this.sourceOf = sourceOf;
    this.stale = false;
    this.outcome = choice(store, 'outcome', 'Outcome', []);
    this.route = choice(store, 'route', 'Route', []);
    this.killer = choice(store, 'killer', 'Killed by', []);
    this.fields = el(
      'div',
      { class: 'fields' },
      this.outcome,
      this.route,
      this.killer,
      numberField(store, 'maxJumps', 'Max jumps', -1, { min: '0', step: '1' }),
      numberField(store, 'maxSeconds', 'Max seconds', 0, { min: '0', step: 'any' }),
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
    this.root.addEventListener('focusout', () => {
      if (this.stale) this.fill();
    });
    store.on(['order'], () => this.show());
    store.on(['boxes', 'drawing'], ({ boxes, drawing }) => {
      if (boxes.length || drawing) this.open(true);
    });
  }

  /** @param {boolean} wanted */
  open(wanted) {
    this.body.hidden = !wanted;
    this.fold.setAttribute('aria-expanded', String(wanted));
  }

  // Called when the query has changed. A focused panel is updated only after losing the focus.
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
    const routes = tally(query.paths.map(routeKey).filter(Boolean)).slice(0, kMaxRoutes);
    const killers = tally(
      query.paths.filter((p) => p.outcome === 'killed' && p.part >= 0).map((p) => p.part),
    );
    const outcomes = tally(query.paths.map((path) => path.outcome));
    const names = routeNames(query, level);
    offer(this.outcome, '', outcomes, (key) => OUTCOME_STYLE[key].short);
    offer(this.route, '', routes, (key) => names.get(key)?.text ?? key);
    offer(this.killer, -1, killers, (part) => partName(level, part));
  }

  show() {
    const on = filtered(this.store.state);
    this.fold.classList.toggle('on', on);
    this.clear.hidden = !on;
  }
}

/**
 * Fills a field with the choices "any" and each value with its count.
 * @template {string | number} N
 * @template {string | number} V
 * @param {HTMLElement & {offer: (options: [N | V, string][]) => void}} field
 * @param {N} none
 * @param {[V, number][]} counts
 * @param {(value: V) => string} nameOf
 */
function offer(field, none, counts, nameOf) {
  /** @type {[V, string][]} */
  const named = counts.map(([value, n]) => [value, `${nameOf(value)} (${n})`]);
  field.offer([[none, 'any'], ...named]);
  field.hidden = counts.length < 2;
}
