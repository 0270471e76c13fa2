// Helpers that build and update elements. Markup is never parsed from data.

/** @import {Child, ElementOptions} from '../types/dom.js' */
/** @import {NamesOf, State} from '../types/report.js' */
/** @import {Store} from '../store.js' */

/**
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} tag
 * @param {ElementOptions} options
 * @param {Child[]} children
 * @returns {HTMLElementTagNameMap[K]}
 */
export function el(tag, options = {}, ...children) {
  const node = document.createElement(tag);
  const { class: name, text, on, data, style, ...attributes } = options;
  if (name) node.className = name;
  if (text !== undefined) node.textContent = text;
  for (const [key, value] of Object.entries(attributes)) {
    if (value === true) node.setAttribute(key, '');
    else if (value !== false && value !== undefined) node.setAttribute(key, String(value));
  }
  for (const [key, value] of Object.entries(data ?? {})) node.dataset[key] = String(value);
  for (const [key, value] of Object.entries(style ?? {})) node.style.setProperty(key, value);
  const listeners = /** @type {[string, EventListener][]} */ (Object.entries(on ?? {}));
  for (const [event, listener] of listeners) node.addEventListener(event, listener);
  node.append(...children.filter((child) => child !== null && child !== undefined));
  return node;
}

const kSvg = 'http://www.w3.org/2000/svg';

/**
 * @template {keyof SVGElementTagNameMap} K
 * @param {K} tag
 * @param {Record<string, string>} attributes
 * @param {Node[]} children
 * @returns {SVGElementTagNameMap[K]}
 */
export function svg(tag, attributes = {}, ...children) {
  const node = document.createElementNS(kSvg, tag);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.append(...children);
  return node;
}

const kIcons = {
  play: 'M7 4.5v15l12-7.5z',
  pause: 'M7 5h3.5v14H7zM13.5 5H17v14h-3.5z',
  back: 'M16.5 5.5v13L8 12zM6 5.5h2v13H6z',
  forward: 'M7.5 5.5v13L16 12zM16 5.5h2v13h-2z',
  loop: 'M7 7h9v-3l5 4-5 4V9H8v4H6V8a1 1 0 0 1 1-1zm10 10H8v3l-5-4 5-4v3h8v-4h2v5a1 1 0 0 1-1 1z',
};

/** @param {keyof typeof kIcons} name */
export function icon(name) {
  return svg(
    'svg',
    { viewBox: '0 0 24 24', class: 'icon', 'aria-hidden': 'true' },
    svg('path', { d: kIcons[name] }),
  );
}

/** @param {number} value */
export const seconds = (value) => (value >= 100 ? value.toFixed(0) : value.toFixed(2));

/** @type {[number, string][]} */
const kUnits = [
  [1e12, 'T'],
  [1e9, 'G'],
  [1e6, 'M'],
  [1e3, 'k'],
];

/**
 * Formats 1234567 as 1.23 M.
 * @param {number | string} value
 */
export function count(value) {
  const number = Number(value);
  if (number < 10000) return String(number);
  for (const [unit, name] of kUnits) {
    // Values that round up to a thousand of the unit below use this unit.
    if (number >= 0.9995 * unit) return `${(number / unit).toPrecision(3)} ${name}`;
  }
  return String(number);
}

/**
 * Formats with a fixed number of decimals, and never as "-0.0".
 * @param {number} value
 */
export const decimal = (value, digits = 1) =>
  Number(value.toFixed(digits) || 0).toFixed(digits);

/** @param {number} n */
export const trajectories = (n) => `${n} ${n === 1 ? 'trajectory' : 'trajectories'}`;

/**
 * @param {number} n
 * @param {string} word
 */
export const plural = (n, word) => `${n} ${word}${n === 1 ? '' : 's'}`;

/**
 * Calls `refill`, which replaces the contents of `root`. The focus moves to the element with the
 * same data-key.
 * @param {HTMLElement} root
 * @param {() => void} refill
 */
export function keepingFocus(root, refill) {
  const focused = document.activeElement;
  const isOurs = focused instanceof HTMLElement && root.contains(focused);
  const key = isOurs ? focused.dataset.key : undefined;
  refill();
  if (key === undefined) return;
  /** @type {HTMLElement | null} */
  const heir = root.querySelector(`[data-key="${CSS.escape(key)}"]`);
  heir?.focus({ preventScroll: true });
}

/**
 * Scrolls a list just far enough to show its selected row.
 * @param {HTMLElement} rows
 */
export function reveal(rows) {
  /** @type {HTMLElement | null} */
  const row = rows.querySelector('[aria-selected=true]');
  if (!row || row.hidden) return;
  const [top, height] = [row.offsetTop, row.offsetHeight];
  const { scrollTop, clientHeight } = rows;
  if (top < scrollTop) rows.scrollTop = top;
  else if (top + height > scrollTop + clientHeight) rows.scrollTop = top + height - clientHeight;
}

/**
 * Like keepingFocus(), and also keeps the scroll position, which forces a layout of the page.
 * @param {HTMLElement} root
 * @param {() => void} refill
 */
export function keepingPlace(root, refill) {
  const top = root.scrollTop;
  keepingFocus(root, refill);
  root.scrollTop = top;
}

/**
 * Returns a check box; `set` gets its state. A mouse click does not leave it focused, so that Space
 * still plays.
 * @param {(checked: boolean) => void} set
 */
export function checkbox(set) {
  const input = el('input', {
    type: 'checkbox',
    on: {
      change: () => {
        set(input.checked);
        if (!input.matches(':focus-visible')) input.blur();
      },
    },
  });
  return input;
}

/**
 * Returns a labelled list of choices, bound to a name of the store. `options`: [value, text] in
 * order; an object would reorder numeric values.
 * @template {NamesOf<string | number>} K
 * @param {Store} store
 * @param {K} name
 * @param {string} label
 * @param {[value: State[K], text: string][]} options
 */
export function choice(store, name, label, options) {
  const select = el('select', {
    on: { change: () => store.put(name, offered[select.selectedIndex][0]) },
  });
  let offered = options;
  const offer = (/** @type {typeof options} */ wanted) => {
    offered = wanted;
    select.replaceChildren(
      ...offered.map(([value, text]) => el('option', { value, text })),
    );
    select.value = String(store.state[name]);
  };
  offer(options);
  store.on([name], (state) => {
    select.value = String(state[name]);
  });
  const field = el('label', { class: `choice ${name}` }, el('span', { text: label }), select);
  return Object.assign(field, { offer });
}

/**
 * Returns a number field, bound to a name of the store. An empty field means `none`.
 * @param {Store} store
 * @param {NamesOf<number>} name
 * @param {string} label
 * @param {number} none
 * @param {{min: string, step: string}} limits
 */
export function numberField(store, name, label, none, limits) {
  const input = el('input', {
    type: 'number',
    placeholder: 'any',
    ...limits,
    on: {
      input: () => {
        const value = input.valueAsNumber;
        store.put(name, Number.isFinite(value) && value >= 0 ? value : none);
      },
    },
  });
  const show = () => {
    const value = store.state[name];
    if (input !== document.activeElement) input.value = value === none ? '' : String(value);
  };
  store.on([name], show);
  show();
  return el('label', { class: `choice ${name}` }, el('span', { text: label }), input);
}
