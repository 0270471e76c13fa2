// The floating panel on the right: legend of the level's roles, display options, and the selected
// part.
import { ROLES } from '../data.js';
import { ROLE_STYLE } from '../palette.js';
import { checkbox, decimal, el } from './dom.js';
import { heatLegend } from './heat_legend.js';

/** @import {Store} from '../store.js' */
/** @import {PartList} from './part_list.js' */
/** @import {Coloring, Level, NamesOf, Query} from '../types/report.js' */

const kSolid = 1; // bits of a part's flags
const kTouch = 2;

/**
 * Returns a part's path, which may break after each of its slashes.
 * @param {string} path
 */
function breakable(path) {
  const words = path.split(/(?<=\/)/).flatMap((word) => [word, el('wbr')]);
  return el('strong', {}, ...words);
}

export class ScenePanel {
  /**
   * `coloringOf`: returns the current colouring.
   * @param {HTMLElement} root
   * @param {Store} store
   * @param {object} now what is shown now
   * @param {() => Query | undefined} now.queryOf
   * @param {() => Level | undefined} now.levelOf
   * @param {() => Coloring} now.coloringOf
   * @param {PartList} now.parts
   * @param {HTMLElement} now.tools
   */
  constructor(root, store, { queryOf, levelOf, coloringOf, parts, tools }) {
    this.root = root;
    this.store = store;
    this.queryOf = queryOf;
    this.levelOf = levelOf;
    this.coloringOf = coloringOf;
    this.legend = el('div', { class: 'legend' });
    this.inspector = el('section', { class: 'inspector', hidden: true });
    root.append(
      this.inspector,
      this.card('Legend', this.legend, true),
      this.card('Display', this.toggles(), false),
      this.card('Parts', parts.root, false, () => parts.refresh()),
      this.card('Tools', tools, false),
    );
    store.on(['order', 'attempts', 'colorBy', 'heat', 'heatTrajectories', 'heatMax'], () =>
      this.fillLegend(),
    );
    store.on(['part', 'query'], () => this.inspect());
    this.fillLegend();
  }

  /**
   * Adds a card whose body folds under its title.
   * @param {string} title
   * @param {HTMLElement} content
   * @param {boolean} open
   * @param {() => void} [shown] called when the body is unfolded
   */
  card(title, content, open, shown) {
    const body = el('div', { class: 'panel-body', hidden: !open }, content);
    const fold = el('button', {
      class: 'fold',
      type: 'button',
      'aria-expanded': open ? 'true' : 'false',
      text: title,
      on: {
        click: () => {
          body.hidden = !body.hidden;
          fold.setAttribute('aria-expanded', String(!body.hidden));
          if (!body.hidden) shown?.();
        },
      },
    });
    return el('section', { class: 'card' }, fold, body);
  }

  fillLegend() {
    const level = this.levelOf();
    this.legend.replaceChildren();
    if (!level) return;
    this.legend.append(...heatLegend(this.store.state, this.queryOf()));
    /** @type {Map<number, number>} */
    const counts = new Map();
    for (const role of level.role) counts.set(role, (counts.get(role) ?? 0) + 1);
    ROLES.forEach((role, code) => {
      if (!counts.has(code)) return;
      this.legend.append(
        el(
          'div',
          {},
          el('i', { class: `chip role-${role}`, style: { '--tint': ROLE_STYLE[role].color } }),
          el('span', { text: ROLE_STYLE[role].label }),
          el('small', { text: String(counts.get(code)) }),
        ),
      );
    });
    const { attempts, colorBy } = this.store.state;
    const isDrawn = (/** @type {string} */ kind) =>
      attempts || kind !== 'attempt' || colorBy !== 'outcome';
    const legend = this.coloringOf().legend.filter(([, , kind]) => isDrawn(kind));
    if (legend.length) this.legend.append(el('hr'));
    for (const [label, tint, kind] of legend)
      this.legend.append(
        el(
          'div',
          {},
          el('i', { class: `swatch ${kind}`, style: { '--tint': tint } }),
          el('span', { text: label }),
        ),
      );
  }

  toggles() {
    const box = el('div', { class: 'toggles' });
    /**
     * @param {NamesOf<boolean>} name
     * @param {string} label
     * @param {string} key
     */
    const add = (name, label, key, isShown = () => true) => {
      const input = checkbox((checked) => this.store.put(name, checked));
      input.checked = this.store.state[name];
      this.store.on([name], (state) => {
        input.checked = state[name];
      });
      const row = el(
        'label',
        { title: key ? `Key ${key}` : undefined },
        input,
        el('span', { text: label }),
        key ? el('kbd', { text: key }) : null,
      );
      const show = () => {
        row.hidden = !isShown();
      };
      this.store.on(['query', 'heat', 'order'], show); // an answer for the query may arrive
      show();
      box.append(row);
    };
    add('solutions', 'Solutions', '1');
    add('attempts', 'Failed attempts', '2');
    add('markers', 'Attempt ends', '3');
    add('runners', 'All players', '4');
    add('regions', 'Regions', '5');
    add('labels', 'Labels', '6');
    add('motionPaths', 'Motion paths', '7');
    add('grid', 'Grid', '8');
    add('heat', 'Heat map', '9');
    const searched = () => this.store.state.heat && Boolean(this.queryOf()?.result?.heatMap);
    add('heatTrajectories', '… of listed trajectories only', '', searched);
    add('cut', 'Impossible step', '0');
    add('isolate', 'Selected only', 'I');
    const original = checkbox((checked) =>
      this.store.set({ colors: checked ? 'level' : 'roles' }),
    );
    original.checked = this.store.state.colors === 'level';
    this.store.on(['colors'], (state) => {
      original.checked = state.colors === 'level';
    });
    box.append(
      el(
        'label',
        { title: 'Key C' },
        original,
        el('span', { text: 'Level colours' }),
        el('kbd', { text: 'C' }),
      ),
    );
    return box;
  }

  inspect() {
    const level = this.levelOf();
    const { part } = this.store.state;
    // Another query's level may have fewer parts, and the selection is reset only later.
    const isKnown = level !== undefined && part >= 0 && part < level.count;
    this.inspector.hidden = !isKnown;
    this.inspector.replaceChildren();
    if (!isKnown) return;
    const role = ROLES[level.role[part]];
    const size = [...level.size.subarray(3 * part, 3 * part + 3)]
      .map((v) => Number(v.toFixed(2)))
      .join(' × ');
    const at = [...level.position.subarray(3 * part, 3 * part + 3)]
      .map((v) => decimal(v))
      .join(', ');
    const facts = el('dl', {});
    const add = (/** @type {string} */ label, /** @type {string} */ value) =>
      facts.append(el('dt', { text: label }), el('dd', { text: value }));
    add('Role', ROLE_STYLE[role].label);
    const material = level.materials[level.material[part] ?? 0];
    if (material) add('Material', material.replace(/(?<=[a-z])(?=[A-Z])/g, ' '));
    const flags = level.flags[part];
    add('Collides', flags & kSolid ? 'yes' : 'no (CanCollide is off)');
    if (!(flags & kTouch)) add('Touch', 'no (CanTouch is off)');
    const tags = level.tags?.[part] ?? [];
    if (tags.length) add('Tags', tags.join(', '));
    add('Size', size);
    add('Position', at);
    for (const note of level.notes[part] ?? []) add('Reason', note);
    this.inspector.append(
      el(
        'header',
        {},
        breakable(level.names[part] || `Part ${part}`),
        el('button', {
          class: 'plain close',
          type: 'button',
          'aria-label': 'Close',
          text: '×',
          on: { click: () => this.store.set({ part: -1 }) },
        }),
      ),
      facts,
    );
  }
}
