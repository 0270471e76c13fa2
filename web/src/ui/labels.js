// Places labels of regions and places in the picture as the camera moves. Overlapping labels are
// stacked.
import { el } from './dom.js';

/** @import {PerspectiveCamera, Vector3} from 'three' */
/** @import {Label} from '../types/report.js' */

const kLineHeight = 22; // pixels
const kMaxStacked = 6;

/** @typedef {{x: number, y: number, halfWidth: number}} Placed */

export class Labels {
  /** @param {HTMLElement} root */
  constructor(root) {
    this.root = root;
    /** @type {{node: HTMLElement, at: Vector3, halfWidth: number}[]} */
    this.items = [];
  }

  /** @param {Label[]} labels */
  set(labels) {
    this.root.replaceChildren();
    this.items = labels.map(({ text, at, color }) => {
      const node = el('span', { class: 'label', text, style: { '--tint': color } });
      this.root.append(node);
      return { node, at, halfWidth: 9 + 3.4 * text.length };
    });
  }

  hide() {
    this.root.hidden = true;
  }

  /**
   * @param {PerspectiveCamera} camera
   * @param {number} width
   * @param {number} height
   * @param {boolean} visible
   */
  update(camera, width, height, visible) {
    this.root.hidden = !visible;
    if (!visible) return;
    /** @type {Placed[]} */
    const placed = [];
    for (const { node, at, halfWidth } of this.items) {
      const p = at.clone().project(camera);
      const inside = p.z < 1 && Math.abs(p.x) < 1.1 && Math.abs(p.y) < 1.1;
      node.hidden = !inside;
      if (!inside) continue;
      const x = ((p.x + 1) / 2) * width;
      const y = this.freeHeight(placed, x, ((1 - p.y) / 2) * height, halfWidth);
      placed.push({ x, y, halfWidth });
      node.style.transform = `translate(${x}px, ${y}px) translate(-50%, -100%)`;
    }
  }

  /**
   * Returns a position in pixels above the labels already placed.
   * @param {Placed[]} placed
   * @param {number} x
   * @param {number} wanted
   * @param {number} halfWidth
   */
  freeHeight(placed, x, wanted, halfWidth) {
    let y = wanted;
    for (let tries = 0; tries < kMaxStacked; tries++) {
      const other = placed.find(
        (each) =>
          Math.abs(each.x - x) < each.halfWidth + halfWidth && Math.abs(each.y - y) < kLineHeight,
      );
      if (!other) break;
      y = other.y - kLineHeight;
    }
    return y;
  }
}
