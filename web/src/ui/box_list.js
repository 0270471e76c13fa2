// The filter's boxes: position, whether trajectories through them are kept or dropped, and how
// many pass.
import { boxOf, pathsThrough } from '../choice.js';
import { el, keepingFocus, trajectories } from './dom.js';

/** @import {Store} from '../store.js' */
/** @import {FilterBox, Query, Source} from '../types/report.js' */

const kAxes = ['x', 'y', 'z'];

/**
 * @param {Query | undefined} query
 * @param {FilterBox} box
 */
function passing(query, box) {
  const n = query ? pathsThrough(query, box).size : 0;
  return `${trajectories(n)} ${n === 1 ? 'passes' : 'pass'} through`;
}

export class BoxList {
  /**
   * @param {Store} store
   * @param {() => Source} sourceOf
   * @param {() => void} addBox
   */
  constructor(store, sourceOf, addBox) {
    this.store = store;
    this.sourceOf = sourceOf;
    this.items = el('div', {});
    this.draw = el('button', {
      class: 'plain text',
      type: 'button',
      text: 'Draw a box',
      title: 'Draw a box by dragging over the floor (B)',
      on: { click: () => store.set({ drawing: !store.state.drawing }) },
    });
    const add = el('button', {
      class: 'plain text',
      type: 'button',
      text: 'Box here',
      title: 'Add a box around the player, or where the camera looks',
      on: { click: addBox },
    });
    this.root = el(
      'div',
      { class: 'boxes' },
      el('div', { class: 'box-bar' }, this.draw, add),
      this.items,
    );
    // The focused field keeps the focus through the change that it causes.
    store.on(['boxes', 'query'], () => keepingFocus(this.items, () => this.fill()));
    store.on(['order'], () => this.count());
    store.on(['drawing'], ({ drawing }) => {
      this.draw.setAttribute('aria-pressed', String(drawing));
      this.draw.textContent = drawing ? 'Drag over the floor …' : 'Draw a box';
    });
  }

  /**
   * @param {number} index
   * @param {FilterBox | null} box null removes it
   */
  replace(index, box) {
    const boxes = this.store.state.boxes.flatMap((each, i) => (i === index ? (box ?? []) : each));
    this.store.set({ boxes });
  }

  fill() {
    this.items.replaceChildren(
      ...this.store.state.boxes.map((box, index) => this.item(box, index)),
    );
  }

  // Updates the counts, because trajectories may have been added. Unfinished input stays.
  count() {
    const { query } = this.sourceOf();
    this.items.querySelectorAll('output').forEach((output, index) => {
      output.textContent = passing(query, this.store.state.boxes[index]);
    });
  }

  /**
   * @param {FilterBox} box
   * @param {number} index
   */
  item(box, index) {
    const keep = el(
      'select',
      {
        'aria-label': `Box ${index + 1}`,
        data: { key: `${index} keep` },
        on: { change: () => this.replace(index, { ...box, keep: keep.value === 'keep' }) },
      },
      el('option', { value: 'keep', text: 'show only these', selected: box.keep }),
      el('option', { value: 'drop', text: 'hide these', selected: !box.keep }),
    );
    const remove = el('button', {
      class: 'plain close',
      type: 'button',
      'aria-label': `Remove box ${index + 1}`,
      text: '×',
      on: { click: () => this.replace(index, null) },
    });
    return el(
      'div',
      { class: 'box' },
      el('div', { class: 'box-bar' }, el('strong', { text: `Box ${index + 1}` }), keep, remove),
      el('output', { class: 'quiet', text: passing(this.sourceOf().query, box) }),
      this.corner(box, index, 'min', 'from'),
      this.corner(box, index, 'max', 'to'),
    );
  }

  /**
   * @param {FilterBox} box
   * @param {number} index
   * @param {'min' | 'max'} end
   * @param {string} label
   */
  corner(box, index, end, label) {
    const field = (/** @type {string} */ axis, /** @type {number} */ k) => {
      const input = el('input', {
        type: 'number',
        step: '1',
        value: Number(box[end][k].toFixed(2)),
        'aria-label': `Box ${index + 1} ${label} ${axis}`,
        data: { key: `${index} ${end} ${k}` },
        on: {
          change: () => {
            if (!Number.isFinite(input.valueAsNumber)) return;
            const corner = box[end].map((v, i) => (i === k ? input.valueAsNumber : v));
            const other = end === 'min' ? box.max : box.min;
            this.replace(index, boxOf(corner, other, box.keep));
          },
        },
      });
      return input;
    };
    return el('div', { class: 'corner' }, el('small', { text: label }), ...kAxes.map(field));
  }
}
