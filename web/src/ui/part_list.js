// The tree of parts with a search field. A click on a part selects and frames it. Folders are
// filled when they are opened, since a place may have thousands of parts.
import { ROLES } from '../data.js';
import { ROLE_STYLE } from '../palette.js';
import { fullName, partName } from '../part_name.js';
import { foundParts, partTree } from '../part_tree.js';
import { el, plural } from './dom.js';

/** @import {Folder} from '../part_tree.js' */
/** @import {Store} from '../store.js' */
/** @import {Level} from '../types/report.js' */

const kMaxShown = 200; // parts of a folder or of a search

export class PartList {
  /**
   * @param {Store} store
   * @param {() => Level | undefined} levelOf
   */
  constructor(store, levelOf) {
    this.store = store;
    this.levelOf = levelOf;
    /** @type {Level | undefined} */
    this.level = undefined; // the level shown
    this.search = el('input', {
      class: 'search',
      type: 'search',
      placeholder: 'Name, role or tag',
      'aria-label': 'Find a part',
      on: { input: () => this.fill() },
    });
    this.count = el('output', { class: 'quiet' });
    this.tree = el('div', { class: 'parts' });
    this.root = el('div', {}, this.search, this.count, this.tree);
    store.on(['query'], () => this.refresh());
    store.on(['part'], () => this.mark());
  }

  // Fills the list when it becomes visible or its level has changed.
  refresh() {
    if (!this.root.checkVisibility() || this.level === this.levelOf()) return;
    this.level = this.levelOf();
    this.fill();
  }

  /** @param {number} part */
  textOf(part) {
    const { level } = this;
    if (!level) return '';
    return `${ROLE_STYLE[ROLES[level.role[part]]].label} ${(level.tags?.[part] ?? []).join(' ')}`;
  }

  fill() {
    const { level } = this;
    this.tree.replaceChildren();
    this.count.textContent = '';
    if (!level) return;
    const text = this.search.value.trim();
    if (text) {
      const found = foundParts(level, text, (part) => this.textOf(part));
      this.count.textContent = plural(found.length, 'part');
      this.tree.append(...this.rows(found, (part) => fullName(level, part)));
    } else this.tree.append(...this.inside(partTree(level)));
    this.mark();
  }

  /**
   * @param {Folder} folder
   * @returns {HTMLElement[]}
   */
  inside(folder) {
    const folders = [...folder.folders.values()].map((child) => this.folder(child));
    return [...folders, ...this.rows(folder.parts, (part) => partName(this.level, part))];
  }

  /** @param {Folder} folder */
  folder(folder) {
    const details = el('details', {});
    details.append(
      el('summary', {}, folder.name, el('small', { text: ` ${folder.count}` })),
    );
    details.addEventListener('toggle', () => {
      if (details.open && details.children.length === 1) {
        details.append(...this.inside(folder));
        this.mark();
      }
    });
    return details;
  }

  /**
   * @param {number[]} parts
   * @param {(part: number) => string} nameOf
   * @returns {HTMLElement[]}
   */
  rows(parts, nameOf) {
    const rows = parts.slice(0, kMaxShown).map((part) => this.row(part, nameOf(part)));
    const left = parts.length - rows.length;
    const text = `and ${plural(left, 'more part')}. Search for them.`;
    const more = el('p', { class: 'quiet', text });
    return left > 0 ? [...rows, more] : rows;
  }

  /**
   * @param {number} part
   * @param {string} name
   * @returns {HTMLElement}
   */
  row(part, name) {
    const role = this.level ? ROLES[this.level.role[part]] : 'plain';
    return el(
      'button',
      {
        class: 'part',
        type: 'button',
        data: { part },
        on: { click: () => this.store.set({ part, frame: part }) },
      },
      el('i', { class: `chip role-${role}`, style: { '--tint': ROLE_STYLE[role].color } }),
      el('span', { text: name }),
    );
  }

  mark() {
    /** @type {NodeListOf<HTMLElement>} */
    const rows = this.tree.querySelectorAll('.part');
    for (const row of rows)
      row.setAttribute('aria-pressed', String(Number(row.dataset.part) === this.store.state.part));
  }
}
