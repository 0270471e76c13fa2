// Measures between two points that the reader clicks.

/** @import {App} from './app.js' */
/** @import {Triple} from './types/page_data.js' */

/** @type {readonly Triple[]} */
export const NO_RULER = Object.freeze([]);

/** @param {number} studs */
const studs = (studs) => (Math.abs(studs) < 0.05 ? 0 : studs).toFixed(1);

/**
 * Returns the measures from one point to another: the distance, the reach (its horizontal part) and
 * the height, which has a sign.
 * @param {Triple} a
 * @param {Triple} b
 */
export function measure(a, b) {
  const [x, y, z] = b.map((value, k) => value - a[k]);
  return { distance: Math.hypot(x, y, z), reach: Math.hypot(x, z), height: y };
}

/**
 * @param {Triple} a
 * @param {Triple} b
 */
export function rulerText(a, b) {
  const { distance, reach, height } = measure(a, b);
  const sign = height >= 0.05 ? '+' : '';
  return `${studs(distance)} studs: reach ${studs(reach)}, height ${sign}${studs(height)}`;
}

export class Ruler {
  /** @param {App} app */
  constructor(app) {
    this.app = app;
    this.store = app.store;
    this.store.on(['measuring', 'ruler'], ({ measuring, ruler }) => {
      app.stage.rulerView.set(ruler);
      app.trajectories.label();
      this.store.set({ status: measuring || ruler.length ? this.text() : '' });
    });
    this.store.on(['measuring'], ({ measuring }) => {
      app.stage.canvas.style.cursor = measuring ? 'crosshair' : '';
    });
  }

  text() {
    const [a, b] = this.store.state.ruler;
    if (b) return rulerText(a, b);
    return a ? 'Measure: click the second point' : 'Measure: click two points';
  }

  toggle() {
    const measuring = !this.store.state.measuring;
    this.store.set({ measuring, drawing: false, ruler: NO_RULER });
  }

  /** @param {Triple} at */
  add(at) {
    const { ruler } = this.store.state;
    this.store.set({ ruler: ruler.length === 1 ? [...ruler, at] : [at] });
  }

  // Returns the label of the picture.
  label() {
    const [a, b] = this.store.state.ruler;
    if (!b) return null;
    const middle = /** @type {Triple} */ (a.map((value, k) => (value + b[k]) / 2));
    return { text: rulerText(a, b), at: middle };
  }
}
